#!/usr/bin/env python3
"""Compares results of this study with what chapter 5 of the thesis prints: see verdicts.py --help."""

import argparse
import collections
import csv
import math
import os
import statistics
import sys

DESCRIPTION = """Compares results of this study with what chapter 5 of the thesis prints.

RUNS are files runs.csv of `argos3-campaign export CAMPAIGN --csv FOLDER`. A table in Markdown is
printed. Wall times are those of a minute of simulated time (600 ticks); shorter runs are scaled."""

TICKS = 600  # of a run of the thesis
REAL_TIME = 60.0  # s
THREADS_OF_THESIS = 16

# one row for each setting: means over the runs
Setting = collections.namedtuple("Setting", "engine engines threads robots")
Means = collections.namedtuple("Means", "w u memory runs")
Verdict = collections.namedtuple("Verdict", "ours word why")

REPRODUCED = "reproduced"
NOT_SLOWER = "not slower"
BETTER = "better"
DIFFERS = "differs"
FEW_CORES = "not applicable with these cores"
NOT_RUN = "not run"


class NotRun(Exception):
    """A setting that a criterion needs has no run."""


class Results:
    """The means of the runs of some files."""

    def __init__(self, paths):
        rows = []
        for path in paths:
            with open(path, newline="", encoding="utf-8") as file:
                lines = (line for line in file if not line.startswith("#"))
                rows += [row for row in csv.DictReader(lines) if row["status"] == "done"]
        if not rows:
            raise SystemExit(f"{', '.join(paths)}: no run is done")
        samples = collections.defaultdict(list)
        for row in rows:
            setting = Setting(row["engine"], int(row["engines"]), int(row["threads"]),
                              int(row["robots"]))
            samples[setting].append(
                (float(row["loop_wall_time"]) * TICKS / int(row["ticks"]), float(row["speedup"]),
                 float(row["resident_memory"])))
        self.means = {
            setting: Means(*(statistics.fmean(column) for column in zip(*sample)), len(sample))
            for setting, sample in samples.items()
        }
        self.threads = sorted({setting.threads for setting in self.means})
        self.most_threads = self.threads[-1]
        self.ticks = sorted({int(row["ticks"]) for row in rows})
        self.versions = sorted({row["version"] for row in rows})
        counts = [means.runs for means in self.means.values()]
        self.runs = f"{min(counts)}" if min(counts) == max(counts) else \
            f"{min(counts)} to {max(counts)}"

    def get(self, engine, engines, threads, robots):
        setting = Setting(engine, engines, threads, robots)
        if setting not in self.means:
            raise NotRun(f"{engine}, A{engines}, P = {threads}, N = {robots}")
        return self.means[setting]

    def robots_of(self, engine, engines, threads):
        """All N of a setting, ascending."""
        numbers = sorted(setting.robots for setting in self.means
                         if setting[:3] == (engine, engines, threads))
        if not numbers:
            raise NotRun(f"{engine}, A{engines}, P = {threads}")
        return numbers

    def engines_of(self, engine, threads, robots):
        """All numbers of engines of a setting, ascending."""
        numbers = sorted(setting.engines for setting in self.means
                         if (setting.engine, setting.threads, setting.robots) ==
                         (engine, threads, robots))
        if len(numbers) < 2:
            raise NotRun(f"{engine} with several numbers of engines, N = {robots}")
        return numbers


def number(value):
    """Three significant digits, without exponent."""
    if value == 0.0:
        return "0"
    digits = max(0, 2 - math.floor(math.log10(abs(value))))
    return f"{value:.{digits}f}"


def at_most(ours, limit, text):
    """The verdict of a printed time that is to be reached."""
    if ours <= limit:
        return Verdict(text, NOT_SLOWER, f"{number(limit / ours)} times as fast")
    return Verdict(text, DIFFERS, f"{number(ours / limit)} times as slow")


def seconds(w):
    return f"w = {number(w)} s = {number(w / REAL_TIME)} T"


def falls(times):
    """True if they fall from each to the next, and by a tenth at least in all."""
    return times == sorted(times, reverse=True) and times[0] > 1.1 * times[-1]


def several_threads(results):
    if results.most_threads < 2:
        raise NotRun("several threads")
    return [threads for threads in results.threads if threads > 0]


def e1(results):
    most = several_threads(results)[-1]
    ratio = (results.get("dynamics2d", 1, 0, 100000).w /
             results.get("dynamics2d", 1, most, 100000).w)
    text = f"w(P = 0) / w(P = {most}) = {number(ratio)}"
    if ratio >= 1.8:
        return Verdict(text, REPRODUCED if ratio <= 2.2 else BETTER,
                       "" if most >= THREADS_OF_THESIS else f"with {most} threads")
    return Verdict(text, DIFFERS if most >= THREADS_OF_THESIS else FEW_CORES,
                   f"{most} threads can give {most} at most")


def e2(results):
    threads = [0] + several_threads(results)
    gains = []
    for robots in results.robots_of("dynamics2d", 1, 0):
        if robots > 100:
            gains.append((robots, [results.get("dynamics2d", 1, p, robots).w for p in threads]))
    if not gains:
        raise NotRun("N > 100")
    text = "; ".join(f"N = {robots}: w(P = 0) / w(P = {threads[-1]}) = {number(w[0] / w[-1])}"
                     for robots, w in gains)
    if all(falls(w) for _, w in gains):
        return Verdict(text, REPRODUCED, "")
    return Verdict(text, DIFFERS, "w does not fall with P, by a tenth at least, for each of these N")


def e3(results):
    most = several_threads(results)[-1]
    costs = [(robots, results.get("dynamics2d", 1, most, robots).w /
              results.get("dynamics2d", 1, 0, robots).w)
             for robots in results.robots_of("dynamics2d", 1, 0) if robots < 100]
    if not costs:
        raise NotRun("N < 100")
    text = "; ".join(f"N = {robots}: w(P = {most}) / w(P = 0) = {number(ratio)}"
                     for robots, ratio in costs)
    slower = [robots for robots, ratio in costs if ratio > 1.1]
    why = "the main thread alone does phases with little work"
    if not slower:
        return Verdict(text, BETTER, why)
    if len(slower) == len(costs):
        return Verdict(text, REPRODUCED, "")
    return Verdict(text, f"{REPRODUCED} for N = {', '.join(map(str, slower))}; else {BETTER}", why)


def e4(results):
    most = several_threads(results)[-1]
    u = {robots: results.get("dynamics2d", 1, most, robots).u
         for robots in results.robots_of("dynamics2d", 1, most)}
    best = max(u, key=u.get)
    text = f"P = {most}: u from {number(min(u.values()))} to {number(u[best])}, at N = {best}"
    last = max(u)
    if u[best] >= 2.9 and min(u.values()) > 1.0:
        if last == best or u[last] >= 0.9 * u[best]:
            return Verdict(text, BETTER, "one engine uses all threads: u does not fall")
        if u[best] > 3.2 or best != 1000:
            return Verdict(text, BETTER if u[best] > 3.2 else DIFFERS, "another maximum")
        return Verdict(text, REPRODUCED, "")
    if most < 4:
        why = f"{most} threads give u = {most} at most. "
        why += ("u does not fall for larger N: one engine uses all threads"
                if u[last] >= 0.9 * u[best] else "u falls for larger N")
        if min(u.values()) < 1.0:
            alone = ", ".join(str(robots) for robots in sorted(u) if u[robots] < 1.0)
            why += f". For N = {alone} the main thread works alone, and u is 1 or less"
        return Verdict(text, FEW_CORES, why)
    return Verdict(text, DIFFERS, "")


def e5(results):
    several_threads(results)
    texts, words = [], []
    for threads, printed in ((2, 1.0), (16, 1.39)):
        if threads in results.threads:
            u = results.get("dynamics2d", 1, threads, 1).u
            texts.append(f"P = {threads}: u = {number(u)}")
            if abs(u - printed) <= 0.1:
                words.append(REPRODUCED)
            else:
                # one robot keeps one processor busy; threads that do not spin add nothing
                words.append(BETTER if 0.9 <= u < printed else DIFFERS)
    if not texts:
        raise NotRun("P = 2 or 16, N = 1")
    word = next((word for word in (DIFFERS, BETTER) if word in words), REPRODUCED)
    why = "" if 16 in results.threads else "P = 2 only; 1.39 needs 16 threads"
    if word == BETTER:
        why = "threads that wait use no processor"
    return Verdict("; ".join(texts), word, why)


def e6(results):
    w = results.get("dynamics2d", 1, 0, 1000).w
    return at_most(w, 0.24 * REAL_TIME, seconds(w))


def e7(results):
    w = results.get("dynamics2d", 2, results.most_threads, 10000).w
    return at_most(w, REAL_TIME, seconds(w))


def e8(results):
    ratio = (results.get("dynamics2d", 2, results.most_threads, 10000).w /
             results.get("dynamics2d", 1, results.most_threads, 10000).w)
    text = f"w(A2) / w(A1) = {number(ratio)}"
    if 0.5 <= ratio <= 0.7:
        return Verdict(text, REPRODUCED, "")
    if ratio > 0.7:
        return Verdict(text, DIFFERS, "one engine uses all threads here, so that a second one "
                       "brings no further thread")
    return Verdict(text, DIFFERS, "")


def e9(results):
    w = results.get("dynamics2d", 16, results.most_threads, 10000).w
    return at_most(w, 0.6 * REAL_TIME, seconds(w))


def e10(results):
    few, many = (results.get("dynamics2d", 16, results.most_threads, robots).w
                 for robots in (1000, 100000))
    exponent = math.log10(many / few) / 2
    verdict = at_most(many, 10 * REAL_TIME,
                      f"{seconds(many)}; from 10^3 to 10^5 w grows as N^{number(exponent)}")
    if not 0.8 <= exponent <= 1.2:
        return Verdict(verdict.ours, DIFFERS, verdict.why + "; not linear: 100,000 robots cover a "
                       "quarter of the ground and press against each other")
    return Verdict(verdict.ours, f"{verdict.word}, linear", verdict.why)


def e11(results):
    most = several_threads(results)[-1]
    robots = results.robots_of("dynamics2d", 16, most)[-1]
    engines = results.engines_of("dynamics2d", most, robots)
    w = [results.get("dynamics2d", count, most, robots).w for count in engines]
    by_threads = [results.get("dynamics2d", 16, threads, robots).w for threads in results.threads]
    settings = [(results.means[s].u, s) for s in results.means if s.engine == "dynamics2d"]
    largest, where = max(settings)
    text = (f"N = {robots}, P = {most}: w = " +
            ", ".join(f"{number(time)} s (A{count})" for count, time in zip(engines, w)) +
            f"; A16: w = " + ", ".join(f"{number(time)} s (P = {threads})" for threads, time in
                                       zip(results.threads, by_threads)) +
            f"; largest u = {number(largest)} at P = {where.threads}, A{where.engines}, "
            f"N = {where.robots}")
    improves_with_threads, improves_with_engines = falls(by_threads), falls(w)
    if improves_with_threads and improves_with_engines:
        is_there = where == Setting("dynamics2d", 16, most, robots)
        return Verdict(text, REPRODUCED if is_there else "reproduced for w; differs for u", "")
    if improves_with_threads:
        return Verdict(text, "reproduced for P; differs for E",
                       "one engine uses all threads here; more engines bring borders, but no "
                       "further thread")
    return Verdict(text, DIFFERS, "")


def orders(results, engine):
    """The times of an engine with N = 10,000 by the number of engines."""
    most = results.most_threads
    engines = results.engines_of(engine, most, 10000)
    w = {count: results.get(engine, count, most, 10000).w for count in engines}
    text = ", ".join(f"{number(time)} s (A{count})" for count, time in w.items())
    return w, f"w = {text}"


def e12(results):
    w, text = orders(results, "kinematics2d")
    verdict = at_most(w[max(w)], REAL_TIME, text)
    ratio = w[min(w)] / w[max(w)]
    if ratio > 2.0:
        return Verdict(text, f"{verdict.word}; {REPRODUCED}",
                       f"{verdict.why}. A{min(w)} takes {number(ratio)} times as long as A{max(w)}")
    return Verdict(text, f"{verdict.word}; {BETTER}",
                   f"{verdict.why}. A{min(w)} takes {number(ratio)} times as long as A{max(w)}: "
                   "collisions are found in a grid, not in O(N^2)")


def e13(results):
    w, text = orders(results, "dynamics3d")
    verdict = at_most(w[max(w)], REAL_TIME, text)
    spread = max(w.values()) / min(w.values())
    best = min(w, key=w.get)
    is_same = spread <= 1.5 and best == max(w)
    why = f"{verdict.why}. The slowest E takes {number(spread)} times as long as the fastest, A{best}"
    return Verdict(text, f"{verdict.word}; order " + (REPRODUCED if is_same else DIFFERS), why)


def e14(results):
    memory = max(results.get("dynamics2d", engines, threads, 100000).memory
                 for engines in (1, 16) for threads in results.threads)
    text = f"{number(memory)} MB"
    return Verdict(text, "not more" if memory <= 800.0 else DIFFERS,
                   f"{number(memory / 800.0)} of the thesis' memory")


CRITERIA = (
    ("E1", "dynamics2d, A1, N = 10^5", "w(P = 0) / w(P = 16) = 2", e1),
    ("E2", "dynamics2d, A1, N > 10^2", "more threads give a lower w; lowest at P = 16", e2),
    ("E3", "dynamics2d, A1, N < 10^2", "threads make it slower", e3),
    ("E4", "dynamics2d, A1, P > 0", "u > 1; maximum 3.04 at P = 16, N = 10^3; falls for larger N",
     e4),
    ("E5", "dynamics2d, A1, N = 1", "u = 1 at P = 2, 1.39 at P = 16", e5),
    ("E6", "dynamics2d, A1, P = 0, N = 10^3", "w = 0.24 T = 14.4 s", e6),
    ("E7", "dynamics2d, A2, P = 16, N = 10^4", "w = T = 60 s", e7),
    ("E8", "dynamics2d, P = 16, N = 10^4", "w(A2) / w(A1) = 0.6", e8),
    ("E9", "dynamics2d, A16, P = 16, N = 10^4", "w = 0.6 T = 36 s", e9),
    ("E10", "dynamics2d, A16, P = 16, N = 10^5", "w = 10 T = 600 s; linear in N from 10^3", e10),
    ("E11", "dynamics2d", "w falls with E and with P; largest u at P = 16, A16, N = 10^5", e11),
    ("E12", "kinematics2d, P = 16, N = 10^4", "w = T = 60 s at A16; far slower with fewer engines",
     e12),
    ("E13", "dynamics3d, P = 16, N = 10^4", "w = T = 60 s at A16; all E close, A16 best", e13),
    ("E14", "dynamics2d, N = 10^5", "about 800 MB", e14),
)


def judge(criterion, results):
    try:
        return criterion(results)
    except NotRun as missing:
        return Verdict("-", NOT_RUN, f"no results of {missing}")


def main():
    parser = argparse.ArgumentParser(description=DESCRIPTION,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", metavar="RUNS", nargs="+")
    arguments = parser.parse_args()
    try:
        results = Results(arguments.runs)
    except (OSError, KeyError, ValueError) as error:
        sys.exit(f"{', '.join(arguments.runs)}: these are no results of this study: {error!r}")
    print("# Chapter 5 of the thesis: printed values and ours\n")
    files = ", ".join(f"`{os.path.basename(path)}`" for path in arguments.runs)
    print(f"Made by `verdicts.py` from {files}: means of "
          f"{results.runs} runs of each setting; version {', '.join(results.versions)}. "
          f"P = {', '.join(map(str, results.threads))} threads; where the thesis has P = 16, "
          f"P = {results.most_threads} is compared.")
    if results.ticks != [TICKS]:
        print(f"Runs have {', '.join(map(str, results.ticks))} ticks instead of {TICKS}; w is scaled.")
    print("w: wall time of the main loop; u = c / w: processors in use, on average; T = 60 s: simulated "
          "time; A4: four engines share the arena.\n")
    print("| # | Setting | Thesis | Here | Verdict | |")
    print("|---|---|---|---|---|---|")
    for name, setting, printed, criterion in CRITERIA:
        verdict = judge(criterion, results)
        print(f"| {name} | {setting} | {printed} | {verdict.ours} | **{verdict.word}** | {verdict.why} |")


if __name__ == "__main__":
    main()
