#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the start of the editor from outside, from exec until it reports its first frame:
start.py CLEARCUT [ROUNDS [FILE]]. Needs a display or QT_QPA_PLATFORM=offscreen."""
import os
import statistics
import subprocess
import sys
import tempfile
import time


def processor_ms(pid):
    fields = open(f"/proc/{pid}/stat").read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) * 1000 / os.sysconf("SC_CLK_TCK")


def start(program, files):
    with tempfile.TemporaryDirectory() as home:
        environment = dict(os.environ, HOME=home, XDG_CONFIG_HOME=home, XDG_STATE_HOME=home)
        before = time.monotonic()
        process = subprocess.Popen([program, "--verbose", *files], stderr=subprocess.PIPE,
                                   env=environment)
        while b"first frame" not in process.stderr.readline():
            if process.poll() is not None:
                sys.exit("no first frame")
        passed = (time.monotonic() - before) * 1000
        used = processor_ms(process.pid)
        process.kill()
        process.wait()
        return passed, used


program, rounds, files = sys.argv[1], int((sys.argv[2:3] or [9])[0]), sys.argv[3:]
times = [start(program, files) for _ in range(rounds)]
for name, values in zip(("first frame", "processor time until then"), zip(*times)):
    print(f"{name:40}median {statistics.median(values):.0f} ms, least {min(values):.0f}, "
          f"worst {max(values):.0f}")
