"""A laboratory for tests against other programs: networks that nothing leaves, and peers to start in them.

A test calls own_network() first. Network A is the test's own: 10.77.0.1 at viz0. Network B lies at the other end of
the cable: 10.77.0.2 at viz1; far("program", ...) says a command for it. Two are needed because OLA and QLC+ do not let
their multicast come back to their own machine.
"""
import atexit
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time

SKIPPED = 77
HERE = os.path.dirname(os.path.abspath(__file__))
OLA_PLUGINS = """artnet dmx4linux dummy e131 espnet ftdidmx gpio karate kinet milinst nanoleaf opendmx openpixelcontrol osc
pathport renard sandnet shownet spi spidmx stageprofi uartdmx usbdmx usbserial""".split()
OLA_CID = "00010203-0405-0607-0809-0a0b0c0d0e0f"

_far = None


def skip(sentence):
    print("skipped:", sentence)
    sys.exit(SKIPPED)


def need(*programs):
    for program in programs:
        if shutil.which(program) is None:
            skip(f"{program} is not installed; scripts/setup interop does that")


def run(*command):
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def start(*command, **options):
    """Starts a program that is ended with the test at the latest."""
    process = subprocess.Popen(command, **options)
    atexit.register(stop, process)
    return process


def stop(process):
    if process.poll() is None:
        process.send_signal(signal.SIGTERM)
        try:
            process.wait(5)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


def own_network():
    """Begins the test anew in a network of its own."""
    need("ip", "unshare", "nsenter")
    if "HAZER_OWN_NETWORK" not in os.environ:
        if subprocess.run(["unshare", "-n", "true"], stderr=subprocess.DEVNULL).returncode != 0:
            skip("this user may not make a network namespace")
        os.environ["HAZER_OWN_NETWORK"] = "1"
        os.execvp("unshare", ["unshare", "-n", sys.executable, *sys.argv])
    run("ip", "link", "set", "lo", "up")


def lay_cable():
    """Makes network B and the cable to it."""
    global _far
    _far = start("unshare", "-n", "sleep", "600")
    wait_until(lambda: os.readlink(f"/proc/{_far.pid}/ns/net") != os.readlink("/proc/self/ns/net"), "network B")
    run("ip", "link", "add", "viz0", "type", "veth", "peer", "name", "viz1")
    run("ip", "link", "set", "viz1", "netns", str(_far.pid))
    for at, name, address in ((), "viz0", "10.77.0.1"), (far(), "viz1", "10.77.0.2"):
        run(*at, "ip", "link", "set", "lo", "up")
        run(*at, "ip", "addr", "add", address + "/24", "brd", "10.77.0.255", "dev", name)
        run(*at, "ip", "link", "set", name, "up")
        run(*at, "ip", "route", "add", "224.0.0.0/4", "dev", name)


def far(*command):
    """`command`, to be run in network B."""
    return ("nsenter", "-t", str(_far.pid), "-n", "--", *command)


def wait_until(condition, what, seconds=15):
    end = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > end:
            fail(f"waited {seconds} s for {what}")
        time.sleep(0.05)


def fail(sentence):
    print("failed:", sentence)
    sys.exit(1)


def expect(condition, sentence):
    if not condition:
        fail(sentence)


class Olad:
    """The OLA daemon with one plugin, in network A. It will not run as root, so it runs as Debian's user "olad"."""

    def __init__(self, plugin, **settings):
        need("olad", "ola_patch", "ola_set_dmx", "setpriv")
        if os.geteuid() != 0:
            skip("olad must be started by root, to become its user")
        self.folder = tempfile.mkdtemp()
        atexit.register(shutil.rmtree, self.folder, True)
        for one in OLA_PLUGINS:
            self._write(f"ola-{one}.conf", {"enabled": "false"})
        self._write(f"ola-{plugin}.conf", {"enabled": "true", **settings})
        self._write("ola-server.conf", {"instance-name": "ola-desk"})
        shutil.chown(self.folder, "olad")
        for name in os.listdir(self.folder):
            shutil.chown(os.path.join(self.folder, name), "olad")
        start("setpriv", "--reuid=olad", "--regid=nogroup", "--clear-groups", "olad", "-c", self.folder, "-l", "1",
              "--no-http", "--no-register-with-dns-sd", "-i", "127.0.0.1")
        wait_until(self._answers, "olad")

    def _write(self, name, settings):
        with open(os.path.join(self.folder, name), "w") as file:
            file.writelines(f"{key} = {value}\n" for key, value in settings.items())

    @staticmethod
    def _answers():
        with socket.socket() as probe:
            return probe.connect_ex(("127.0.0.1", 9010)) == 0

    @staticmethod
    def patch(universe, port=0, is_input=False):
        def is_patched():
            done = subprocess.run(["ola_patch", "-d", "1", "-p", str(port), "-u", str(universe)] + ["-i"] * is_input,
                                  capture_output=True)
            return done.returncode == 0
        wait_until(is_patched, "olad's port")

    @staticmethod
    def set(universe, levels):
        run("ola_set_dmx", "-u", str(universe), "-d", ",".join(map(str, levels)))

    @staticmethod
    def levels(universe):
        """What OLA holds for a universe."""
        try:
            from ola.ClientWrapper import ClientWrapper
        except ImportError:
            skip("Python's module ola is not installed; scripts/setup interop does that")
        wrapper, got = ClientWrapper(), []

        def take(status, number, levels):
            got.extend(levels or [])
            wrapper.Stop()
        wrapper.Client().FetchDmx(universe, take)
        wrapper.Run()
        return got


class Probe:
    """hazer's receivers, printing what stands each time they are asked."""

    def __init__(self, *arguments, at=()):
        self.process = start(*at, os.environ["HAZER_PROBE"], *arguments, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                             text=True)
        self.ask()

    def ask(self):
        self.process.stdin.write("\n")
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def universe(self, protocol, number):
        """That universe as it stands, or None."""
        for one in self.ask()["universes"]:
            if (one["protocol"], one["universe"]) == (protocol, number):
                return one
        return None

    def slots(self, protocol, number, count):
        universe = self.universe(protocol, number)
        return universe["slots"][:count] if universe else None

    def wait_for_slots(self, protocol, number, slots):
        wait_until(lambda: self.slots(protocol, number, len(slots)) == slots,
                   f"{protocol} universe {number} to be {slots}; it is {self.slots(protocol, number, len(slots))}")


def send(*arguments, at=()):
    """hazer send, until the test ends or stop() is called with it."""
    return start(*at, os.environ["HAZER_PROGRAM"], "send", *arguments, stdout=subprocess.DEVNULL,
                 stderr=subprocess.DEVNULL)
