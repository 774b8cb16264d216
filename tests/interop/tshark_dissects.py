"""Everything hazer sends, as Wireshark dissects it: nothing malformed, and the values that were sent."""
import os
import subprocess
import tempfile

import lab

lab.need("tshark")
lab.own_network()
lab.lay_cable()
lab.Probe("--artnet", "0.0.0.0", "1,300", at=lab.far())
with tempfile.TemporaryDirectory() as folder:
    capture = os.path.join(folder, "sent.pcap")
    recorder = lab.start("tshark", "-q", "-i", "viz0", "-f", "udp", "-w", capture, "-F", "pcap",
                         stderr=subprocess.DEVNULL)
    lab.wait_until(lambda: os.path.exists(capture) and os.path.getsize(capture) > 0, "tshark")
    # A poll, for hazer's replies; then both kinds of levels.
    poll = b"Art-Net\0\x00\x20\x00\x0e\x00\x00".ljust(22, b"\0")
    with lab.socket.socket(lab.socket.AF_INET, lab.socket.SOCK_DGRAM) as desk:
        desk.bind(("10.77.0.1", 6454))
        desk.sendto(poll, ("10.77.0.2", 6454))
        desk.settimeout(5)
        desk.recv(2000)
        desk.recv(2000)
    artnet = lab.send("--universe", "300", "--pattern", "sine", "--sync", "--to", "10.77.0.2", "--seconds", "1")
    sacn = lab.send("--protocol", "sacn", "--universes", "1-3", "--pattern", "sine", "--priority", "150", "--sync", "7000",
                    "--slot-priority", "1=0", "--interface", "viz0", "--seconds", "1")
    artnet.wait(20)
    sacn.wait(20)
    lab.time.sleep(0.5)
    lab.stop(recorder)

    def tshark(*arguments):
        done = subprocess.run(["tshark", "-r", capture, "--enable-heuristic", "acn", "-o", "acn.dmx_enable:TRUE",
                               *arguments], capture_output=True, text=True, check=True)
        return [line for line in done.stdout.splitlines() if line]

    everything = tshark()
    malformed = tshark("-Y", "_ws.malformed")
    lab.expect(not malformed, f"malformed: {malformed[:3]}")
    kinds = {
        "ArtDmx of Port-Address 300": "artnet.output.universe == 300 && artnet.output.length == 512",
        "ArtSync": "artnet.header.opcode == 0x5200",
        "ArtPollReply": "artnet.poll_reply",
        "levels of priority 150": "acn.dmx.universe == 2 && acn.dmx.priority == 150 && acn.dmx.start_code2 == 0",
        "per-address priorities": "acn.dmx.start_code2 == 221 && acn.dmx.count == 513",
        "terminations": "acn.dmx.option_s == 1",
        "synchronization": "ip.dst == 239.255.27.88 && udp.length == 57",
        "discovery": "ip.dst == 239.255.250.214",
    }
    for kind, wanted in kinds.items():
        count = len(tshark("-Y", wanted))
        print(f"{kind}: {count} packets")
        lab.expect(count > 0, f"tshark sees no {kind}")
    print(f"{len(everything)} packets dissected")
