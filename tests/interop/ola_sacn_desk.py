"""OLA as an E1.31 desk, by multicast: short and full packets, its draft of discovery, termination."""
import lab

lab.own_network()
lab.lay_cable()
olad = lab.Olad("e131", cid=lab.OLA_CID, draft_discovery="true", dscp=0, ignore_preview="false", input_ports=4,
                output_ports=4, ip="10.77.0.1", prepend_hostname="false", revision="0.46")
probe = lab.Probe("--sacn", "viz1", "1,2", at=lab.far())
olad.patch(1, port=0)
olad.patch(2, port=1)
olad.set(1, [255, 128, 64, 0, 1])
probe.wait_for_slots("sacn", 1, [255, 128, 64, 0, 1, 0])
full = [i % 256 for i in range(512)]
olad.set(2, full)
probe.wait_for_slots("sacn", 2, full)
source = probe.universe("sacn", 1)["sources"][0]
lab.expect((source["name"], source["address"], source["priority"]) == ("ola-desk", "10.77.0.1", 100), f"who: {source}")
lab.run("ola_patch", "-d", "1", "-p", "0", "-u", "1", "--unpatch")
lab.wait_until(lambda: probe.ask()["sacn"]["terminations"] == 3, "three terminations")
universe = probe.universe("sacn", 1)
lab.expect(universe["lost"] and universe["slots"][0] == 255, "the last look is held, as lost")
lab.wait_until(lambda: probe.ask()["sacn"]["ignored"] > 0, "OLA's draft of discovery, ignored")
lab.expect(probe.ask()["sacn"]["malformed"] == 0, "nothing malformed")
