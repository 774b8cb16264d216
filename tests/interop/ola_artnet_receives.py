"""hazer's Art-Net as OLA receives it, on loopback."""
import lab

lab.own_network()
olad = lab.Olad("artnet", always_broadcast="false", ip="127.0.0.1", net=0, subnet=0, output_ports=4,
                short_name="ola", long_name="OLA", use_limited_broadcast="false", use_loopback="true")
olad.patch(5, is_input=True)
desk = lab.send("--universe", "5", "--slot", "1=255", "--slot", "3=7", "--slot", "512=9")
lab.wait_until(lambda: olad.levels(5)[:3] == [255, 0, 7], "levels in OLA")
lab.expect(olad.levels(5)[511] == 9, "slot 512")
lab.stop(desk)
lab.send("--universe", "5", "--slot", "1=1")
lab.wait_until(lambda: olad.levels(5)[:3] == [1, 0, 0], "levels of a desk that was started anew")
