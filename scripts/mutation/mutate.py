"""Changes the code in small ways (a condition negated or false, < to <=, + to -, a dropped clamp, another constant), one at a time,
and reports which changes the tests notice.

The sources are copied to BUILD/tree, and only the copy is changed and built. The tests run once without a change, which says
which test cases come to the block of each mutant, and how long they take: only those judge it, quick ones first. A mutant
is killed if a test case fails or takes much longer, survives if all pass, and is invalid if it does not compile. A survivor
is a missing test, or equivalent: the change has no effect that matters.

  scripts/mutate.sh src/plugins/media/rab_medium.cpp            every mutant of a file
  scripts/mutate.sh src/plugins/media/rab_medium.cpp:75         of a line
  scripts/mutate.sh --since origin/main                         of the lines changed since a revision
  scripts/mutate.sh --count 20 --seed 7 src/plugins/media/*.cpp   20 of them at random
"""

import argparse
import hashlib
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Optional

sys.path.insert(0, str(Path(__file__).parent))
from mutants import Mutant, find_mutants  # noqa: E402
from probes import Case, add_probes, find_probes, order_cases, read_cases  # noqa: E402
from test_programs import DIGESTS, choose_programs  # noqa: E402

REPO = Path(__file__).resolve().parents[2]
# what tests run beside themselves and libraries
_PROGRAMS = ("run", "argos3-campaign", "argos3-plot")


def run(command: list[str], **options) -> str:
    return subprocess.run(command, check=True, text=True, stdout=subprocess.PIPE, **options).stdout


def git(*arguments: str) -> str:
    return run(["git", "-c", f"safe.directory={REPO}", "-C", str(REPO), *arguments])


def changed_lines(revision: str) -> dict[str, set[int]]:
    """The lines of each source that differ from a revision."""
    lines: dict[str, set[int]] = {}
    path = ""
    for line in git("diff", "--unified=0", revision, "--", "src/*.cpp").splitlines():
        if line.startswith("+++ "):
            path = line[6:]
        elif match := re.match(r"@@ -\S+ \+(\d+)(?:,(\d+))? @@", line):
            first, count = int(match[1]), int(match[2] or 1)
            lines.setdefault(path, set()).update(range(first, first + count))
    return {p: numbers for p, numbers in lines.items() if not p.startswith("src/testing/")}


def write_if_changed(path: Path, text: str) -> None:
    """Files that are equal keep their times, so that builds are incremental."""
    if not path.is_file() or path.read_text() != text:
        path.write_text(text)


def copy_tree(tree: Path, mutated: list[str]) -> None:
    """Makes the tree equal to the checkout, but for files that are written later."""
    wanted = {p for p in git("ls-files", "--cached", "--others", "--exclude-standard", "-z").split("\0") if p}
    for path in wanted:
        source, target = REPO / path, tree / path
        if not source.is_file():
            continue
        if not target.is_file() or (path not in mutated and source.read_bytes() != target.read_bytes()):
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)
    for folder, folders, files in os.walk(tree):
        if Path(folder) == tree and "build" in folders:
            folders.remove("build")
        for file in files:
            target = Path(folder) / file
            if target.relative_to(tree).as_posix() not in wanted:
                target.unlink()


class Build:
    def __init__(self, folder: Path, jobs: int):
        self.folder = folder
        self.tree = folder / "tree"
        # inside of the tree, as in a checkout: ccache knows paths relative to the tree
        self.build = self.tree / "build"
        self.jobs = jobs

    def configure(self, paths: list[str]) -> dict[str, list[str]]:
        """Returns the targets of each file."""
        self.tree.mkdir(parents=True, exist_ok=True)
        copy_tree(self.tree, paths)
        written = self.build / "mutated_targets.txt"
        mutated = ";".join(str(self.tree / p) for p in paths)
        # the options of scripts/test.sh, whose objects ccache has
        run(["cmake", "-S", str(self.tree), "-B", str(self.build), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=8", "-DARGOS_BUILD_TESTING=ON", "-DARGOS_WERROR=ON",
             f"-DCMAKE_PROJECT_argos3_INCLUDE={self.tree / 'scripts/mutation/separate.cmake'}",
             f"-DMUTATED={mutated}", f"-DMUTATED_TARGETS={written}"])
        targets: dict[str, list[str]] = {}
        for line in written.read_text().splitlines():
            path, target = line.rsplit(" ", 1)
            targets.setdefault(Path(path).relative_to(self.tree).as_posix(), []).append(target)
        return targets

    def find_outputs(self, target: str) -> list[str]:
        """What has to be built if a source of a target changes: shared libraries; else none, because programs contain its objects."""
        outputs = [line.split(":")[0] for line in self.query("-t", "targets", "all").splitlines()]
        if any(o.endswith(f"/lib{target}.so") for o in outputs):
            return [target]
        compiled = next(o for o in outputs if f"/{target}.dir/" in o and o.endswith(".o") and "cmake_pch" not in o)
        users = self.query("-t", "query", compiled).split("outputs:")[1].split()
        return [o for o in users if o.endswith(".so")]

    def query(self, *arguments: str) -> str:
        return run(["ninja", "-C", str(self.build), *arguments])

    def make(self, targets: list[str]) -> tuple[bool, str]:
        command = ["ninja", "-C", str(self.build), f"-j{self.jobs}", *targets]
        result = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return result.returncode == 0, result.stdout

    def passes(self, program: str, arguments: list[str], limit: Optional[float], written: Path) -> bool:
        """written: .map has a character for each mutant, .cases gets a line for each test case; see reach_listener.cpp."""
        if program == DIGESTS:
            command = [str(self.tree / "scripts/digests.sh"), str(self.build)]
        else:
            command = [str(self.build / "bin" / program), *arguments]
        environment = {**os.environ, "ARGOS_MUTATION_MAP": f"{written}.map", "ARGOS_MUTATION_CASES": f"{written}.cases"}
        with subprocess.Popen(command, cwd=self.build, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, start_new_session=True) as process:
            try:
                return process.wait(limit) == 0
            except BaseException as end:
                os.killpg(process.pid, signal.SIGKILL)
                if isinstance(end, subprocess.TimeoutExpired):
                    return False
                raise

    def measure(self, program: str, num_mutants: int) -> list[Case]:
        """Runs a program without a change: the test cases that pass, with their times and what they reach."""
        name, _, tags = program.partition(" ")
        written = self.folder / f"reach_{program.replace(' ', '_')}"
        reached, cases = Path(f"{written}.map"), Path(f"{written}.cases")
        reached.write_text("0" * num_mutants)
        cases.write_text("")
        began = time.monotonic()
        passes = self.passes(name, [tags + "~[.]"], None, written)
        seconds = time.monotonic() - began
        if name == DIGESTS:
            passed, failed = [Case(DIGESTS, "", seconds, reached.read_text())] if passes else [], []
        else:
            passed, failed = read_cases(name, cases.read_text())
        if not passes:
            names = ", ".join(f'"{n}"' for n in failed)
            print(f"left out: {program} fails without any change{': ' + names if failed else ''}", flush=True)
        return passed

    def judge(self, mutant: Mutant, text: str, outputs: list[str], groups: list[list[Case]], budget: float) -> str:
        """
        text: of the source with the change.
        outputs: of this mutant, and of the last one, which have to be built again without it.
        """
        path = self.tree / mutant.path
        original = path.read_text()
        written = self.folder / "judged"
        Path(f"{written}.map").write_text("0")
        names = self.folder / "names.txt"
        try:
            path.write_text(text)
            if not self.make(outputs)[0]:
                return "invalid"
            began = time.monotonic()
            for i, group in enumerate(groups):
                if time.monotonic() - began > budget:
                    return f"survived {sum(len(g) for g in groups[i:])} slower test cases did not run"
                # a comma or a quote would end the name
                names.write_text("".join(re.sub(r'([\\,"])', r"\\\1", case.name) + "\n" for case in group))
                Path(f"{written}.cases").write_text("")
                limit = 10.0 + 3.0 * sum(case.seconds for case in group)
                if not self.passes(group[0].program, ["--abort", "--input-file", str(names)], limit, written):
                    ended = Path(f"{written}.cases").read_text().splitlines()
                    failed = next((i for i, line in enumerate(ended) if line.startswith("failed ")), len(ended))
                    case = group[min(failed, len(group) - 1)].name
                    return f"killed by {group[0].program}{': ' + case if case else ''}"
            return "survived"
        finally:
            path.write_text(original)


class Reach:
    """The sources with marks, and the test cases that come to each mutant."""

    def __init__(self, build: Build, mutants: list[Mutant]):
        self.build = build
        self.mutants = mutants
        self.texts = {m.path: (REPO / m.path).read_text() for m in mutants}
        self.blind: set[str] = set()  # paths that do not compile with marks
        self.cases: list[Case] = []

    def text(self, path: str, mutant: Optional[Mutant] = None) -> str:
        text = self.texts[path]
        own = [i for i, m in enumerate(self.mutants) if m.path == path]
        probes = {} if path in self.blind else find_probes(text, [self.mutants[i].line for i in own])
        if mutant:
            lines = text.split("\n")
            lines[mutant.line - 1] = mutant.after
            text = "\n".join(lines)
        return add_probes(path, text, probes, own)

    def build_all(self, targets: list[str]) -> None:
        while True:
            for path in self.texts:
                write_if_changed(self.build.tree / path, self.text(path))
            good, output = self.build.make(targets)
            if good:
                return
            failed = {p for p in self.texts if re.search(rf"^FAILED: .*{re.escape(Path(p).name)}\.o", output, re.MULTILINE)}
            if not failed - self.blind:
                print(output[-4000:])
                sys.exit("mutate.sh: the tree does not build without any change")
            self.blind |= failed

    def measure(self, programs: list[str]) -> None:
        kept = self.build.folder / "reach.json"
        state = hashlib.sha256(repr((self.mutants, programs, sorted(self.blind))).encode())
        for path in sorted(p for p in git("ls-files", "--cached", "--others", "--exclude-standard", "-z").split("\0") if p):
            if (REPO / path).is_file() and not path.startswith(("doc/", "scripts/mutation/")):
                state.update((REPO / path).read_bytes())
        if kept.is_file() and (known := json.loads(kept.read_text()))["state"] == state.hexdigest():
            self.cases = [Case(*case) for case in known["cases"]]
            return
        with ThreadPoolExecutor(self.build.jobs) as pool:
            found = pool.map(lambda p: self.build.measure(p, len(self.mutants)), programs)
        self.cases = [case for cases in found for case in cases]
        kept.write_text(json.dumps({"state": state.hexdigest(), "cases": self.cases}))

    def find_groups(self, mutant: Mutant, programs: list[str]) -> tuple[list[list[Case]], bool]:
        """The second value says whether a test case reaches it; if none is known to, all of its programs are taken."""
        number = self.mutants.index(mutant)
        reaching = [c for c in self.cases if c.reached[number] == "1"]
        known = bool(reaching) or mutant.path in self.blind
        if not reaching:
            # static objects are made before the first test case
            reaching = [c for c in self.cases if c.program in programs]
        digests = next((c for c in reaching if c.program == DIGESTS), None)
        return order_cases([c for c in reaching if c.program != DIGESTS], programs, digests), known


def read_arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="scripts/mutate.sh", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="*", metavar="FILE[:LINE]", help="sources under src/")
    parser.add_argument("--since", metavar="REVISION", help="the lines changed since then, of FILEs or of all sources")
    parser.add_argument("--kinds", metavar="KIND,...",
                        help="of condition, comparison, sign, limit (std::min, max, clamp), number; default all")
    parser.add_argument("--count", type=int, metavar="N", help="judge N mutants, chosen at random; default all")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="of the choice; default 1")
    parser.add_argument("--skip", type=int, default=0, metavar="N", help="leave out the first N, to continue a run")
    parser.add_argument("--tests", metavar="PROGRAM[ [TAG]...],...",
                        help="test programs, such as \"unit_core_tests,contract_tests [media]\"; default by the folder of the file,"
                        " see test_programs.py")
    parser.add_argument("--budget", type=float, default=180.0, metavar="S",
                        help="begin no further test cases of a mutant after S seconds; default 180")
    parser.add_argument("--build", type=Path, default=REPO / "build-mutate", metavar="DIR", help="default build-mutate")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N", help="of the build")
    parser.add_argument("--list", action="store_true", help="print the mutants and stop")
    return parser.parse_args()


def choose(arguments: argparse.Namespace) -> list[Mutant]:
    lines = changed_lines(arguments.since) if arguments.since else None
    wanted: dict[str, Optional[set[int]]] = {}
    for argument in arguments.files:
        name, _, line = argument.partition(":")
        path = (REPO / name).resolve().relative_to(REPO).as_posix()
        known = wanted.setdefault(path, set() if line else None)
        if known is not None and line:
            known.add(int(line))
    if lines is not None:
        wanted = {p: n for p, n in lines.items() if not wanted or p in wanted}
    elif not wanted:
        sys.exit("mutate.sh: name files, or a revision with --since")
    mutants = [m for path in sorted(wanted) for m in find_mutants(path, (REPO / path).read_text(), wanted[path])]
    if arguments.kinds:
        mutants = [m for m in mutants if m.kind in arguments.kinds.split(",")]
    if arguments.count is not None:
        # in the order of the choice, so that a run can be continued
        mutants = random.Random(arguments.seed).sample(mutants, min(arguments.count, len(mutants)))
    return mutants


def main() -> None:
    arguments = read_arguments()
    mutants = choose(arguments)
    if arguments.list:
        print("\n".join(m.describe() for m in mutants[arguments.skip :]))
        return
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    build = Build(arguments.build.resolve(), arguments.jobs)
    paths = sorted({m.path for m in mutants})
    targets = build.configure(paths)
    tests = {p: arguments.tests.split(",") if arguments.tests else choose_programs(p) for p in paths}
    for path in [p for p in paths if p not in targets]:
        print(f"left out {path}: no source of a target")
        paths.remove(path)
    mutants = [m for m in mutants if m.path in paths]
    programs = sorted({t for p in paths for t in tests[p]})
    built = [p.partition(" ")[0] for p in programs if p != DIGESTS]
    found = {t: build.find_outputs(t) for p in paths for t in targets[p]}
    print(f"{len(mutants)} mutants in {len(paths)} files; building {' '.join(programs)}", flush=True)
    reach = Reach(build, mutants)
    reach.build_all([*sorted({o for outputs in found.values() for o in outputs}), *_PROGRAMS, *built])
    print("running the tests without a change", flush=True)
    reach.measure(programs)
    results: dict[str, int] = {}
    stale: set[str] = set()
    try:
        for mutant in mutants[arguments.skip :]:
            groups, known = reach.find_groups(mutant, [t.partition(" ")[0] for t in tests[mutant.path]])
            # a program that tests run contains the objects of its target, as test programs do
            users = {*_PROGRAMS, *(g[0].program for g in groups if g[0].program != DIGESTS)}
            own = {o for t in targets[mutant.path] for o in found[t] or users}
            began = time.monotonic()
            result = build.judge(mutant, reach.text(mutant.path, mutant), sorted(own | stale), groups, arguments.budget)
            word, _, reason = result.partition(" ")
            # if it does not compile, others may not have been built
            stale = own | stale if word == "invalid" else own
            if word == "survived" and not known:
                reason = "no test is known to reach it" + (", " if reason else "") + reason
            results[word] = results.get(word, 0) + 1
            reason = f"  ({reason})" if reason else ""
            print(f"{word:8} {mutant.describe()}{reason} [{time.monotonic() - began:.0f} s]", flush=True)
    except KeyboardInterrupt:
        print("interrupted")
    killed, survived = results.get("killed", 0), results.get("survived", 0)
    share = f", {100.0 * killed / (killed + survived):.0f} % killed" if killed + survived else ""
    print(f"{killed} killed, {survived} survived, {results.get('invalid', 0)} invalid{share}")


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("mutate.sh: interrupted")
