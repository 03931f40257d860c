"""Changes the code in small ways (a condition negated or false, < to <=, + to -, a dropped clamp, another constant), one at a time,
and reports which changes the tests notice.

The sources are copied to BUILD/tree, and only the copy is changed and built. A mutant is killed if a test fails or takes
much longer than without it, survives if all pass, and is invalid if it does not compile. A survivor is a missing test,
or equivalent: the change has no effect that matters.

  scripts/mutate.sh src/plugins/media/rab_medium.cpp            every mutant of a file
  scripts/mutate.sh src/plugins/media/rab_medium.cpp:75         of a line
  scripts/mutate.sh --since origin/main                         of the lines changed since a revision
  scripts/mutate.sh --count 20 --seed 7 src/plugins/media/*.cpp   20 of them at random
"""

import argparse
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Optional

sys.path.insert(0, str(Path(__file__).parent))
from mutants import Mutant, find_mutants  # noqa: E402
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


def copy_tree(tree: Path) -> None:
    """Makes the tree equal to the checkout; files that are equal keep their times, so that builds are incremental."""
    wanted = {p for p in git("ls-files", "--cached", "--others", "--exclude-standard", "-z").split("\0") if p}
    for path in wanted:
        source, target = REPO / path, tree / path
        if not source.is_file():
            continue
        if not target.is_file() or source.read_bytes() != target.read_bytes():
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
        self.tree = folder / "tree"
        # inside of the tree, as in a checkout: ccache knows paths relative to the tree
        self.build = self.tree / "build"
        self.jobs = jobs
        self.limits: dict[str, float] = {}

    def configure(self, paths: list[str]) -> dict[str, list[str]]:
        """Returns the targets of each file."""
        self.tree.mkdir(parents=True, exist_ok=True)
        copy_tree(self.tree)
        written = self.build / "mutated_targets.txt"
        mutated = ";".join(str(self.tree / p) for p in paths)
        # the options of scripts/test.sh, whose objects ccache has
        run(["cmake", "-S", str(self.tree), "-B", str(self.build), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
             "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=8", "-DARGOS_BUILD_TESTING=ON", "-DARGOS_WERROR=ON",
             f"-DCMAKE_PROJECT_argos3_INCLUDE={Path(__file__).parent / 'separate.cmake'}",
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

    def make(self, targets: list[str]) -> bool:
        command = ["ninja", "-C", str(self.build), f"-j{self.jobs}", *targets]
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT).returncode == 0

    def passes(self, program: str, limit: Optional[float]) -> bool:
        name, _, tags = program.partition(" ")
        if name == DIGESTS:
            command = [str(self.tree / "scripts/digests.sh"), str(self.build)]
        else:
            command = [str(self.build / "bin" / name), "--abort", tags + "~[.]"]
        with subprocess.Popen(command, cwd=self.build, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL, start_new_session=True) as process:
            try:
                return process.wait(limit) == 0
            except BaseException as end:
                os.killpg(process.pid, signal.SIGKILL)
                if isinstance(end, subprocess.TimeoutExpired):
                    return False
                raise

    def measure(self, program: str) -> None:
        """The tests must pass without a mutant; their time limits that with one."""
        began = time.monotonic()
        if self.passes(program, None):
            self.limits[program] = 10.0 + 3.0 * (time.monotonic() - began)
        else:
            print(f"left out {program}: it fails without any change", flush=True)
            self.limits[program] = 0.0

    def judge(self, mutant: Mutant, outputs: list[str], programs: list[str]) -> str:
        """outputs: of this mutant and of the last one, because that has to be built again without it."""
        path = self.tree / mutant.path
        original = path.read_text()
        lines = original.split("\n")
        lines[mutant.line - 1] = mutant.after
        try:
            path.write_text("\n".join(lines))
            if not self.make(outputs):
                return "invalid"
            for program in programs:
                if program not in self.limits:
                    path.write_text(original)
                    self.make(outputs)
                    self.measure(program)
                    path.write_text("\n".join(lines))
                    self.make(outputs)
                if self.limits[program] > 0.0 and not self.passes(program, self.limits[program]):
                    return f"killed by {program}"
            return "survived"
        finally:
            path.write_text(original)


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
    return mutants[arguments.skip :]


def main() -> None:
    arguments = read_arguments()
    mutants = choose(arguments)
    if arguments.list:
        print("\n".join(m.describe() for m in mutants))
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
    # a program that tests run contains the objects of its target, as test programs do
    outputs = {p: [o for t in targets[p] for o in found[t] or [*_PROGRAMS, *built]] for p in paths}
    print(f"{len(mutants)} mutants in {len(paths)} files; building {' '.join(programs)}", flush=True)
    if not build.make(sorted({o for p in paths for o in outputs[p]}) + [*_PROGRAMS, *built]):
        sys.exit("mutate.sh: the tree does not build without any change")
    results: dict[str, int] = {}
    last: list[str] = []
    try:
        for mutant in mutants:
            own = outputs[mutant.path]
            result = build.judge(mutant, [*own, *(o for o in last if o not in own)], tests[mutant.path])
            last = own
            word = result.split()[0]
            results[word] = results.get(word, 0) + 1
            print(f"{word:8} {mutant.describe()}{'' if word == result else '  (' + result + ')'}", flush=True)
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
