"""A `scrubjay emulate` of a test's own, and what really happened to its robots."""

import json
import os
import signal
import subprocess
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROGRAM = os.environ.get("SCRUBJAY", str(HERE.parent.parent / "build" / "scrubjay"))


def eventually(condition, what, timeout=20.0):
    """Waits until `condition()` is true, and returns what it returned."""
    deadline = time.monotonic() + timeout
    while True:
        value = condition()
        if value:
            return value
        if time.monotonic() > deadline:
            raise AssertionError(f"waited {timeout:g} s in vain: {what}")
        time.sleep(0.02)


class Emulator:
    """Robots behind pseudo-terminals, from entering a `with` to `end()`, or to leaving it at the latest."""

    def __init__(self, *flags, world="hall", count=1):
        self._folder = tempfile.TemporaryDirectory(prefix="scrubjay-interop-")
        folder = Path(self._folder.name)
        link = folder / "robot"
        self.links = [str(link)] if count == 1 else [f"{link}{i}" for i in range(count)]
        self._said = open(folder / "said", "w+", encoding="utf-8")
        words = [PROGRAM, "emulate", str(HERE / f"{world}.yaml"), "--pty", str(link), "--noise", "none", "--json"]
        self._process = subprocess.Popen([*words, "--count", str(count), *flags], stdin=subprocess.DEVNULL,
                                         stdout=subprocess.PIPE, stderr=self._said, text=True)

    @property
    def link(self):
        return self.links[0]

    def __enter__(self):
        try:
            eventually(lambda: self._lives() and all(map(os.path.exists, self.links)), "no link to a robot")
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_):
        if self._process.poll() is None:
            self._process.kill()
        self._process.wait()
        self._process.stdout.close()
        self._said.close()
        self._folder.cleanup()

    def _lives(self):
        if self._process.poll() is not None:
            self._said.seek(0)
            raise AssertionError(f"emulate ended with {self._process.returncode}: {self._said.read().strip()}")
        return True

    def pulse_brc(self):
        """What would wake a robot by its BRC pin."""
        self._lives()
        self._process.send_signal(signal.SIGUSR1)

    def end(self):
        """Ends it as Ctrl-C does, and returns its account of every robot."""
        self._lives()
        self._process.send_signal(signal.SIGINT)
        account, _ = self._process.communicate(timeout=20)
        return json.loads(account)["robots"]
