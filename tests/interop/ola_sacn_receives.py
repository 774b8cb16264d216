"""hazer's sACN as OLA receives it, by multicast: levels, priority, termination."""
import lab

lab.own_network()
lab.lay_cable()
olad = lab.Olad("e131", cid=lab.OLA_CID, draft_discovery="false", dscp=0, ignore_preview="false", input_ports=4,
                output_ports=4, ip="10.77.0.1", prepend_hostname="false", revision="0.46")
olad.patch(1, is_input=True)
sacn = ("--protocol", "sacn", "--interface", "viz1", "--universes", "1-30")
lab.send(*sacn, "--slot", "1=10", "--slot", "512=9", at=lab.far())
lab.wait_until(lambda: olad.levels(1)[:2] == [10, 0], "levels in OLA")
lab.expect(olad.levels(1)[511] == 9, "slot 512")
stronger = lab.send(*sacn, "--slot", "1=20", "--priority", "120", "--sync", "7000", at=lab.far())
lab.wait_until(lambda: olad.levels(1)[:1] == [20], "the source of higher priority")
lab.stop(stronger)
lab.wait_until(lambda: olad.levels(1)[:1] == [10], "the other source, after the termination", 2)
