"""Runs every test here, each in a process of its own, several at a time: they wait more than they work.

usage: run.py [--junit FILE] [--none-skipped] [word]...

A line a test on stdout, what one that failed or was skipped said after it, and the sum at the end; with words, only the
tests whose names hold one of them. Exit code 1 if one failed, or was skipped where none may be.
"""

import argparse
import concurrent.futures
import os
import re
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path
from xml.sax.saxutils import quoteattr

HERE = Path(__file__).resolve().parent
AT_A_TIME = 8
LONGEST = 120.0  # that a test may take, also on a machine that is busy [s]


def names_in(suite):
    for test in suite:
        if isinstance(test, unittest.TestSuite):
            yield from names_in(test)
        else:
            yield test.id()


def run(name):
    """Whether it passed, failed or was skipped, what it said, and how long it took."""
    began = time.monotonic()
    # A session of its own: a test that hangs goes with all that it started.
    process = subprocess.Popen([sys.executable, "-m", "unittest", "--verbose", name], cwd=HERE, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True)
    try:
        said, _ = process.communicate(timeout=LONGEST)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        said, _ = process.communicate()
        said += f"\nended after {LONGEST:g} s\n"
    skipped = re.search(r"\.\.\. skipped ['\"](.*)['\"]\n", said)
    state = "failed" if process.returncode != 0 else "skipped" if skipped else "passed"
    return state, skipped[1] if state == "skipped" else said, time.monotonic() - began


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--junit", type=Path)
    parser.add_argument("--none-skipped", action="store_true")
    parser.add_argument("words", nargs="*")
    options = parser.parse_args()

    sys.path.insert(0, str(HERE))
    names = [name for name in names_in(unittest.defaultTestLoader.discover(str(HERE)))
             if not options.words or any(word in name for word in options.words)]
    count = dict.fromkeys(("passed", "failed", "skipped"), 0)
    cases = []
    with concurrent.futures.ThreadPoolExecutor(AT_A_TIME) as pool:
        runs = {pool.submit(run, name): name for name in names}
        for done in concurrent.futures.as_completed(runs):
            state, said, seconds = done.result()
            if state == "skipped" and options.none_skipped:
                state, said = "failed", f"skipped, and none may be: {said}"
            count[state] += 1
            print(f"{state if state != 'failed' else 'FAILED'}  {runs[done]}  ({seconds:.1f} s)", flush=True)
            if state != "passed":
                print(said, flush=True)
            remark = {"passed": "", "failed": '<failure message="see the log"/>',
                      "skipped": f"<skipped message={quoteattr(said)}/>"}[state]
            cases.append(f"<testcase name={quoteattr(runs[done])} time=\"{seconds:.3f}\">{remark}</testcase>")
    print(", ".join(f"{number} {state}" for state, number in count.items() if number or state != "skipped"), flush=True)
    if options.junit:
        head = (f'<testsuite name="interop" tests="{len(names)}" failures="{count["failed"]}" '
                f'skipped="{count["skipped"]}">')
        options.junit.write_text("\n".join([head, *cases, "</testsuite>", ""]), encoding="utf-8")
    sys.exit(1 if count["failed"] or not names else 0)


if __name__ == "__main__":
    main()
