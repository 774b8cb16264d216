"""QLC+ as a desk: Art-Net and unicast E1.31 at 50 Hz, both fading."""
import os
import subprocess
import tempfile
import time

import lab

lab.need("qlcplus")
lab.own_network()
probe = lab.Probe("--artnet", "127.0.0.2", "3", "--sacn", "127.0.0.2", "7")
work = tempfile.TemporaryDirectory()
environment = {**os.environ, "HOME": work.name, "XDG_RUNTIME_DIR": work.name, "QT_QPA_PLATFORM": "offscreen"}
lab.start("qlcplus", "-o", os.path.join(lab.HERE, "qlc_desk.qxw"), "-p", "-n", "-m", "-d", "0", env=environment,
          stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def packets(protocol, number):
    universe = probe.universe(protocol, number)
    return universe["packets"] if universe else 0


seen = {"artnet": set(), "sacn": set()}
lab.wait_until(lambda: packets("artnet", 3) > 0 and packets("sacn", 7) > 0, "QLC+", 30)
begin = {"artnet": packets("artnet", 3), "sacn": packets("sacn", 7)}
end = time.monotonic() + 2
while time.monotonic() < end:
    seen["artnet"].add(tuple(probe.slots("artnet", 3, 3)))
    seen["sacn"].add(tuple(probe.slots("sacn", 7, 11)[9:]))
for protocol, number in ("artnet", 3), ("sacn", 7):
    rate = (packets(protocol, number) - begin[protocol]) / 2
    print(f"{protocol}: {rate:.0f} packets a second, {len(seen[protocol])} different looks")
    lab.expect(rate > 20, f"{protocol} at {rate} packets a second")
    lab.expect(len(seen[protocol]) > 10, f"{protocol} does not fade: {seen[protocol]}")
source = probe.universe("sacn", 7)["sources"][0]
lab.expect(source["priority"] == 120 and source["name"].startswith("Q Light Controller"), f"who: {source}")
report = probe.ask()
for protocol in "artnet", "sacn":
    lab.expect(report[protocol]["malformed"] == 0 and report[protocol]["late"] == 0, f"{protocol}: {report[protocol]}")
