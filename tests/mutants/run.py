#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Have the tests of app/ and ui/ teeth? Puts small faults into a copy of the sources, one at a time, and runs the tests
against each.

The faults are drawn at random: first the kind, then the place (sites.py). A fault is tested by the tests of its room and
of the rooms that stand directly on it, in ui/ also by those of the whole window; one that lives, by all other tests of
the layer, in ui/ also by the drawing tasks. The quickest begin. Prints each fault, and the test that killed it. Ends with 1 if one lives. The first run builds everything in build/mutants, which takes as
long as any first build; then a fault takes a minute or two. Needs what tests/run.sh installs. For clipping/ there is
tests/clipping/mutants.sh."""
from __future__ import annotations

import argparse
import collections
import concurrent.futures
import filecmp
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time
from typing import Any, Iterator, NamedTuple

sys.dont_write_bytecode = True
from sites import Mutant, mutants  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
COPY, BUILD = ROOT / "build/mutants/source", ROOT / "build/mutants/build"
LONGEST = 120  # seconds that a test may take without a fault; others are left out


class Test(NamedTuple):
    name: str
    program: str  # the ninja target
    command: list[str]
    environment: dict[str, str]


def copy_sources() -> None:
    """Makes the copy what the sources are; what is equal keeps its time, so that it is not built again."""
    listed = subprocess.run(["git", "ls-files", "-coz", "--exclude-standard"], cwd=ROOT, check=True, capture_output=True)
    names = {name for name in os.fsdecode(listed.stdout).split("\0") if name and (ROOT / name).is_file()}
    for name in names:
        if not (COPY / name).is_file() or not filecmp.cmp(ROOT / name, COPY / name, shallow=False):
            (COPY / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, COPY / name)
    for path in [path for path in COPY.rglob("*") if path.is_file()]:
        if str(path.relative_to(COPY)) not in names:
            path.unlink()


def configure() -> None:
    done = subprocess.run(["cmake", "-G", "Ninja", "-S", COPY, "-B", BUILD, "-DCMAKE_BUILD_TYPE=Release",
                           "-DCLEARCUT_PRECOMPILE=ON", "-DCLEARCUT_PYTHON=OFF"], capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stdout + done.stderr)


def build(programs: set[str]) -> str:
    """Empty, or what the compiler says."""
    done = subprocess.run(["ninja", "-C", BUILD, *sorted(programs)], capture_output=True, text=True)
    return done.stdout if done.returncode else ""


def all_tests() -> list[Test]:
    shown = subprocess.run(["ctest", "--show-only=json-v1"], cwd=BUILD, check=True, capture_output=True).stdout
    tests = []
    for test in json.loads(shown)["tests"]:
        properties: dict[str, Any] = {each["name"]: each["value"] for each in test.get("properties", [])}
        programs = [word for word in test.get("command", []) if word.startswith(f"{BUILD}/tests/")]
        if programs:
            environment = dict(each.removesuffix("unset:").split("=", 1) for each in [
                *properties.get("ENVIRONMENT", []), *properties.get("ENVIRONMENT_MODIFICATION", [])])
            tests.append(Test(test["name"], os.path.relpath(programs[0], BUILD), test["command"], environment))
    return tests


def rooms_above(layer: str) -> dict[str, set[str]]:
    """Of each room, itself and the rooms that stand directly on it."""
    above: dict[str, set[str]] = collections.defaultdict(set)
    for name, below in re.findall(r"^room\((\w+)(?: ON ([a-z_ ]+?))?(?=\)|\s+[A-Z]+\b)",
                                  (ROOT / layer / "CMakeLists.txt").read_text(), re.M):
        for room in (name, *below.split()):
            above[room].add(name)
    return above


def tests_of(room: str, layer: str, tests: list[Test]) -> tuple[list[Test], list[Test]]:
    """The tests that are near, and the others of the layer."""
    rooms = "|".join(rooms_above(layer)[room])
    near = rf"{layer}\.(?:{rooms})\." + (r"|ui\.\w+$" if layer == "ui" else "")
    of_layer = [test for test in tests if re.match(r"ui\.|tasks\." if layer == "ui" else r"app\.", test.name)]
    return ([test for test in of_layer if re.match(near, test.name)],
            [test for test in of_layer if not re.match(near, test.name)])


def run(test: Test, seconds: float) -> tuple[str, float]:
    """Which function failed, or how it ended; empty if it passed. And how long it took."""
    with tempfile.TemporaryDirectory() as home:
        environment = {**os.environ, "QT_LOGGING_RULES": "*.debug=false", "XDG_RUNTIME_DIR": home,
                       "XDG_CONFIG_HOME": f"{home}/config", "XDG_STATE_HOME": f"{home}/state", **test.environment}
        begin = time.monotonic()
        with subprocess.Popen(test.command, cwd=BUILD / "tests", env=environment, start_new_session=True, text=True,
                              errors="replace", stdout=subprocess.PIPE, stderr=subprocess.STDOUT) as process:
            try:
                output = process.communicate(timeout=seconds)[0]
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, 9)
                process.communicate()
                return f"{test.name}: does not end", seconds
    failed = re.search(r"^(?:FAIL!|XPASS) *: (\S+\))", output, re.M)
    how = failed[1] if failed else f"ended with {process.returncode}"
    return (f"{test.name}: {how}" if process.returncode else ""), time.monotonic() - begin


class Faults:
    """The places of a layer, and what kills a fault there."""

    def __init__(self, layer: str, rooms: list[str]) -> None:
        self.layer, self.tests = layer, all_tests()
        self.seconds: dict[str, float] = {}  # of each test without a fault; infinite: it is left out
        self.sites: dict[str, list[tuple[str, Mutant]]] = collections.defaultdict(list)
        for path in sorted((COPY / layer).glob("*/**/*.cpp")):
            name = str(path.relative_to(COPY))
            if not rooms or name.split("/")[1] in rooms:
                for mutant in mutants(path.read_text()):
                    self.sites[mutant.kind].append((name, mutant))

    def drawn(self, seed: int) -> Iterator[tuple[str, Mutant]]:
        chance = random.Random(seed)
        while True:
            yield chance.choice(self.sites[chance.choice(sorted(self.sites))])

    def prepare(self, tests: list[Test]) -> None:
        """Runs each test once without a fault. One that fails then, and would seem to kill everything, is left out."""
        new = [test for test in tests if test.name not in self.seconds]
        if new and (errors := build({test.program for test in tests} | {"clearcut"})):
            sys.exit(errors)
        for test in new:
            how, seconds = run(test, LONGEST)
            if how:
                print(f"Left out, because it fails without a fault: {how}", flush=True)
            self.seconds[test.name] = float("inf") if how else seconds

    def verdict(self, name: str, mutant: Mutant) -> str | None:
        """What kills it; empty if it lives; None if it does not compile."""
        near, others = tests_of(name.split("/")[1], self.layer, self.tests)
        self.prepare(near)
        text = (COPY / name).read_text()
        (COPY / name).write_text(text[:mutant.begin] + mutant.text + text[mutant.end:])
        try:
            if build({test.program for test in near} | {"clearcut"}):
                return None
            return self.killer(near) or self.far_killer(name, text, others)
        finally:
            (COPY / name).write_text(text)

    def far_killer(self, name: str, text: str, tests: list[Test]) -> str:
        if any(test.name not in self.seconds for test in tests):
            faulty = (COPY / name).read_text()
            (COPY / name).write_text(text)
            self.prepare(tests)
            (COPY / name).write_text(faulty)
        if errors := build({test.program for test in tests}):
            sys.exit(errors)
        return self.killer(tests)

    def killer(self, tests: list[Test]) -> str:
        tests = sorted((test for test in tests if self.seconds[test.name] <= LONGEST), key=lambda t: self.seconds[t.name])
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            runs = [pool.submit(run, test, 3 * self.seconds[test.name] + 20) for test in tests]
            for done in concurrent.futures.as_completed(runs):
                if done.result()[0]:
                    pool.shutdown(cancel_futures=True)
                    return done.result()[0]
        return ""


def described(name: str, mutant: Mutant) -> str:
    text = (COPY / name).read_text()
    begin, end = text.rfind("\n", 0, mutant.begin) + 1, text.find("\n", mutant.end)
    before, after = text[begin:end], text[begin:mutant.begin] + mutant.text + text[mutant.end:end]
    lines = [f"    {sign} {line}" for sign, part in (("-", before), ("+", after)) for line in part.split("\n")]
    return f"{name}:{text.count(chr(10), 0, mutant.begin) + 1} ({mutant.kind})\n" + "\n".join(lines)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("layer", choices=["app", "ui"])
    parser.add_argument("--count", type=int, default=20, help="of faults that compile (20)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--rooms", nargs="*", default=[], help="only these folders of the layer")
    given = parser.parse_args()
    copy_sources()
    configure()
    if errors := build(set()):  # everything: ctest has no commands for programs that are not there
        sys.exit(errors)
    faults = Faults(given.layer, given.rooms)
    done = lived = 0
    seen = set()
    for name, mutant in faults.drawn(given.seed):
        if (name, mutant) in seen:
            continue
        seen.add((name, mutant))
        verdict = faults.verdict(name, mutant)
        if verdict is None:
            continue
        done, lived = done + 1, lived + (not verdict)
        print(f"{done:3} {verdict or 'LIVES'}\n{described(name, mutant)}", flush=True)
        if done == given.count:
            break
    print(f"{done - lived} of {done} faults killed")
    sys.exit(lived > 0)


if __name__ == "__main__":
    main()
