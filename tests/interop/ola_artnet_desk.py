"""OLA as an Art-Net desk: it polls, hazer answers, and only then OLA sends."""
import lab

lab.own_network()
lab.lay_cable()
olad = lab.Olad("artnet", always_broadcast="false", ip="10.77.0.1", net=0, subnet=0, output_ports=4,
                short_name="ola-desk", long_name="OLA", use_limited_broadcast="false", use_loopback="false")
probe = lab.Probe("--artnet", "0.0.0.0", "1,2", at=lab.far())
olad.patch(1, port=0)
olad.patch(2, port=1)
lab.wait_until(lambda: probe.ask()["artnet"]["polls"] > 0, "a poll from OLA")


def look_arrives(universe, levels):
    olad.set(universe, levels)
    return probe.slots("artnet", universe, len(levels)) == levels


# OLA sends a look once, to those that have answered by then.
lab.wait_until(lambda: look_arrives(1, [255, 128, 64, 0, 1]), "levels of universe 1")
lab.wait_until(lambda: look_arrives(2, [1, 2, 3]), "levels of universe 2")
for level in range(1, 20):
    olad.set(1, [level, 0, 255])
probe.wait_for_slots("artnet", 1, [19, 0, 255, 0, 0])
counters = probe.ask()["artnet"]
lab.expect(counters["late"] == 0 and counters["malformed"] == 0, f"nothing late or malformed: {counters}")
