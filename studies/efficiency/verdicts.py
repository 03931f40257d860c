#!/usr/bin/env python3
"""Compares results of this study with what chapter 5 of the thesis prints: see verdicts.py --help."""

import argparse
import collections
import math
import os
import pathlib
import statistics
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from verdicts import LEVEL, difference, judge, median, read_runs  # noqa: E402  # pylint: disable=wrong-import-position

DESCRIPTION = """Compares results of this study with what chapter 5 of the thesis prints.

RUNS are files runs.csv of `argos3-campaign export CAMPAIGN --csv FOLDER`. A table in Markdown is
printed. Wall times are those of a minute of simulated time (600 ticks); shorter runs are scaled.
A statement is reproduced if the whole interval of a statistic fulfils it, not reproduced if no part
of the interval does, and undecided otherwise."""

TICKS = 600  # of a run of the thesis
REAL_TIME = 60.0  # s
THREADS_OF_THESIS = 16
SAME = 1.05  # ratios below are no difference that matters
OUTLIER = 1.5  # times the median of a setting

Setting = collections.namedtuple("Setting", "engine engines threads robots")
Run = collections.namedtuple("Run", "w u memory load")
# a statement about a statistic: text, verdict, why
Claim = collections.namedtuple("Claim", "ours word why")

REPRODUCED, NOT_REPRODUCED, UNDECIDED = "reproduced", "not reproduced", "undecided"


class NotRun(Exception):
    """A setting that a criterion needs has no run."""


class Results:
    """The runs of some files."""

    def __init__(self, paths):
        rows = read_runs(*paths)
        if not rows:
            raise SystemExit(f"{', '.join(paths)}: no run is done")
        self.runs = collections.defaultdict(list)
        for row in rows:
            setting = Setting(row["engine"], int(row["engines"]), int(row["threads"]), int(row["robots"]))
            self.runs[setting].append(
                Run(float(row["loop_wall_time"]) * TICKS / int(row["ticks"]), float(row["speedup"]),
                    float(row["resident_memory"]), float(row.get("other_load") or "nan")))
        self.threads = sorted({setting.threads for setting in self.runs})
        self.most_threads = self.threads[-1]
        self.ticks = sorted({int(row["ticks"]) for row in rows})
        self.versions = sorted({row["version"] for row in rows})

    def get(self, *setting):
        if Setting(*setting) not in self.runs:
            engine, engines, threads, robots = setting
            raise NotRun(f"{engine}, A{engines}, P = {threads}, N = {robots}")
        return self.runs[Setting(*setting)]

    def list_levels(self, factor, **others):
        """All levels of a factor for which there are runs with these levels of the others, ascending."""
        found = {getattr(setting, factor) for setting in self.runs
                 if all(getattr(setting, name) == level for name, level in others.items())}
        if not found:
            raise NotRun(", ".join(f"{name} = {level}" for name, level in others.items()))
        return sorted(found)

    def describe_runs(self):
        counts = [len(runs) for runs in self.runs.values()]
        few, many = min(counts), max(counts)
        return f"{few}" if few == many else f"{few} to {many}"

    def describe_disturbances(self):
        """Runs that took much longer than others of their setting, and the load that other programs were."""
        outliers = []
        for setting, runs in sorted(self.runs.items()):
            usual = statistics.median(run.w for run in runs)
            outliers += [f"{setting.engine}, A{setting.engines}, P = {setting.threads}, N = {setting.robots}: "
                         f"{number(run.w / usual)} times" for run in runs if run.w > OUTLIER * usual]
        total = sum(map(len, self.runs.values()))
        text = f"Outliers, of {total} runs: {len(outliers)} took more than {OUTLIER} times the median of their setting"
        text += f" ({'; '.join(outliers[:10])}{'; ...' if len(outliers) > 10 else ''})." if outliers else "."
        loads = [run.load for runs in self.runs.values() for run in runs if not math.isnan(run.load)]
        if loads:
            text += f" Other programs kept {number(max(loads))} processors busy at most during a run of half a second or more."
        return text


def number(value):
    """Three significant digits, without exponent."""
    if value == 0.0 or not math.isfinite(value):
        return f"{value:.0f}"
    digits = max(0, 2 - math.floor(math.log10(abs(value))))
    return f"{value:.{digits}f}"


def show(estimate):
    value, low, high = estimate
    return f"{number(value)} [{number(low)}, {number(high)}]"


def claim(text, estimate, above=-math.inf, below=math.inf, why="", otherwise=""):
    """A statement: above < statistic < below. why: if it is reproduced; otherwise: if it is not."""
    word = judge(estimate, above, below)
    if word == UNDECIDED:
        reason = "more runs are needed"
    else:
        reason = why if word == REPRODUCED else otherwise
    return Claim(f"{text} = {show(estimate)}", word, reason)


def ratio(first, second):
    """First over second, with the interval that belongs to the rank-sum test of the logarithms."""
    shift = difference([math.log(run.w) for run in first], [math.log(run.w) for run in second])
    return tuple(math.exp(end) if end < 700.0 else math.inf for end in shift)


def time_of(runs):
    return median([run.w for run in runs])


def use_of(runs):
    return median([run.u for run in runs])


def at_most(estimate, limit, text, unit="s"):
    """A printed time or memory that is to be reached."""
    value = estimate[0]
    ours = f"{text} = {show(estimate)} {unit}"
    if unit == "s":
        ours += f" = {number(value / REAL_TIME)} T"
    word = judge(estimate, below=limit)
    more = f"{number(limit / value)} times less" if value < limit else f"{number(value / limit)} times more"
    return Claim(ours, word, "more runs are needed" if word == UNDECIDED else more)


def differs(text, estimate, why):
    """The statement that a ratio is above 1. A whole interval within 5 % of 1 is no difference."""
    if estimate[1] > 1.0 / SAME and estimate[2] < SAME:
        return Claim(f"{text} = {show(estimate)}", NOT_REPRODUCED, f"no difference of 5 %: {why}")
    return claim(text, estimate, above=1.0, otherwise=why)


def missing(text, what):
    return Claim(text, UNDECIDED, f"needs {what}")


def several_threads(results):
    if results.most_threads < 2:
        raise NotRun("several threads")
    return [threads for threads in results.threads if threads > 0]


ONE_ENGINE = "one engine uses all threads here"
ALONE = "the main thread alone does phases with little work"


def e1(results):
    most = several_threads(results)[-1]
    text = f"w(P = 0) / w(P = {most})"
    gain = ratio(results.get("dynamics2d", 1, 0, 100000), results.get("dynamics2d", 1, most, 100000))
    if most < THREADS_OF_THESIS and gain[0] < 2.2:
        return [missing(f"{text} = {show(gain)}", f"{THREADS_OF_THESIS} processors; {most} can give {most} at most")]
    return [claim(text, gain, 1.8, 2.2, otherwise="better" if gain[1] >= 2.2 else "")]


def e2(results):
    threads = [0] + several_threads(results)
    claims = []
    for robots in results.list_levels("robots", engine="dynamics2d", engines=1, threads=0):
        if robots > 100:
            for fewer, more in zip(threads, threads[1:]):
                gain = ratio(results.get("dynamics2d", 1, fewer, robots), results.get("dynamics2d", 1, more, robots))
                claims.append(differs(f"N = {robots}: w(P = {fewer}) / w(P = {more})", gain, "threads bring nothing"))
    if not claims:
        raise NotRun("N > 100")
    return claims


def e3(results):
    most = several_threads(results)[-1]
    claims = []
    for robots in results.list_levels("robots", engine="dynamics2d", engines=1, threads=0):
        if robots < 100:
            cost = ratio(results.get("dynamics2d", 1, most, robots), results.get("dynamics2d", 1, 0, robots))
            claims.append(differs(f"N = {robots}: w(P = {most}) / w(P = 0)", cost, ALONE))
    if not claims:
        raise NotRun("N < 100")
    return claims


def e4(results):
    most = several_threads(results)[-1]
    numbers = results.list_levels("robots", engine="dynamics2d", engines=1, threads=most)
    u = {robots: use_of(results.get("dynamics2d", 1, most, robots)) for robots in numbers}
    claims = [claim(f"P = {most}, N = {robots}: u", u[robots], above=1.0, otherwise=ALONE) for robots in numbers]
    if most < 4:
        claims.append(missing("maximum of u", f"4 processors or more, to reach 3.04; {most} give {most} at most"))
    else:
        best = max(u, key=lambda robots: u[robots][0])
        claims.append(claim(f"maximum of u, at N = {best}", u[best], 2.9, 3.2,
                            otherwise="better" if u[best][0] > 3.04 else ""))
        if best != 1000:
            claims.append(Claim(f"the maximum is at N = {best}", NOT_REPRODUCED, "another maximum"))
    if 1000 in u and numbers[-1] > 1000:
        fall = difference([run.u for run in results.get("dynamics2d", 1, most, 1000)],
                          [run.u for run in results.get("dynamics2d", 1, most, numbers[-1])])
        claims.append(claim(f"u(N = 1000) - u(N = {numbers[-1]})", fall, above=0.0, otherwise=ONE_ENGINE))
    return claims


def e5(results):
    several_threads(results)
    claims = []
    for threads, printed in ((2, 1.0), (16, 1.39)):
        if threads in results.threads:
            u = use_of(results.get("dynamics2d", 1, threads, 1))
            # one robot keeps one processor busy; threads that do not spin add nothing
            claims.append(claim(f"P = {threads}: u", u, printed - 0.1, printed + 0.1,
                                otherwise="threads that wait use no processor" if 0.9 <= u[0] < printed else ""))
        else:
            claims.append(missing(f"P = {threads}", f"{threads} processors"))
    return claims


def e6(results):
    return [at_most(time_of(results.get("dynamics2d", 1, 0, 1000)), 0.24 * REAL_TIME, "w")]


def e7(results):
    return [at_most(time_of(results.get("dynamics2d", 2, results.most_threads, 10000)), REAL_TIME, "w")]


def e8(results):
    share = ratio(results.get("dynamics2d", 2, results.most_threads, 10000),
                  results.get("dynamics2d", 1, results.most_threads, 10000))
    return [claim("w(A2) / w(A1)", share, 0.5, 0.7, otherwise=ONE_ENGINE if share[0] > 0.7 else "")]


def e9(results):
    return [at_most(time_of(results.get("dynamics2d", 16, results.most_threads, 10000)), 0.6 * REAL_TIME, "w")]


def e10(results):
    few, many = (results.get("dynamics2d", 16, results.most_threads, robots) for robots in (1000, 100000))
    exponent = tuple(math.log10(end) / 2.0 if 0.0 < end < math.inf else end for end in ratio(many, few))
    return [at_most(time_of(many), 10.0 * REAL_TIME, "w"),
            claim("exponent of N from 10^3 to 10^5", exponent, 0.8, 1.2,
                  otherwise="100,000 robots cover a quarter of the ground and press against each other")]


def falls(results, settings, texts, why):
    """w falls from each setting to the next one."""
    claims = []
    for (before, after), text in zip(zip(settings, settings[1:]), texts):
        claims.append(differs(text, ratio(results.get(*before), results.get(*after)), why))
    return claims


def e11(results):
    most = several_threads(results)[-1]
    robots = results.list_levels("robots", engine="dynamics2d", engines=16, threads=most)[-1]
    engines = results.list_levels("engines", engine="dynamics2d", threads=most, robots=robots)
    claims = falls(results, [("dynamics2d", count, most, robots) for count in engines],
                   [f"N = {robots}, P = {most}: w(A{few}) / w(A{many})" for few, many in zip(engines, engines[1:])],
                   ONE_ENGINE)
    threads = results.list_levels("threads", engine="dynamics2d", engines=16, robots=robots)
    claims += falls(results, [("dynamics2d", 16, count, robots) for count in threads],
                    [f"N = {robots}, A16: w(P = {few}) / w(P = {many})" for few, many in zip(threads, threads[1:])], "")
    largest = Setting("dynamics2d", 16, most, robots)
    others = [setting for setting in results.runs if setting.engine == "dynamics2d" and setting != largest]
    if others:
        best = max(others, key=lambda setting: use_of(results.runs[setting])[0])
        lead = difference([run.u for run in results.get(*largest)], [run.u for run in results.runs[best]])
        claims.append(claim(f"u(P = {most}, A16, N = {robots}) - u(P = {best.threads}, A{best.engines}, N = {best.robots})",
                            lead, above=0.0, otherwise=ONE_ENGINE))
    return claims


def engines_of(results, engine):
    """All numbers of engines with 10,000 robots, and their runs."""
    most = results.most_threads
    return {count: results.get(engine, count, most, 10000)
            for count in results.list_levels("engines", engine=engine, threads=most, robots=10000)}


def e12(results):
    runs = engines_of(results, "kinematics2d")
    few, many = min(runs), max(runs)
    return [at_most(time_of(runs[many]), REAL_TIME, f"A{many}: w"),
            claim(f"w(A{few}) / w(A{many})", ratio(runs[few], runs[many]), above=2.0,
                  otherwise="collisions are found in a grid, not in O(N^2)")]


def e13(results):
    runs = engines_of(results, "dynamics3d")
    many = max(runs)
    claims = [at_most(time_of(runs[many]), REAL_TIME, f"A{many}: w")]
    for count in sorted(runs)[:-1]:
        claims.append(claim(f"w(A{count}) / w(A{many})", ratio(runs[count], runs[many]), 1.0, 1.5))
    return claims


def e14(results):
    settings = [setting for setting in results.runs if setting.engine == "dynamics2d" and setting.robots == 100000]
    if not settings:
        raise NotRun("dynamics2d, N = 100000")
    memory = [median([run.memory for run in results.runs[setting]]) for setting in settings]
    return [at_most(max(memory), 800.0, "memory", "MB")]


CRITERIA = (
    ("E1", "dynamics2d, A1, N = 10^5", "w(P = 0) / w(P = 16) = 2", e1),
    ("E2", "dynamics2d, A1, N > 10^2", "more threads give a lower w; lowest at P = 16", e2),
    ("E3", "dynamics2d, A1, N < 10^2", "threads make it slower", e3),
    ("E4", "dynamics2d, A1, P > 0", "u > 1; maximum 3.04 at P = 16, N = 10^3; falls for larger N", e4),
    ("E5", "dynamics2d, A1, N = 1", "u = 1 at P = 2, 1.39 at P = 16", e5),
    ("E6", "dynamics2d, A1, P = 0, N = 10^3", "w = 0.24 T = 14.4 s", e6),
    ("E7", "dynamics2d, A2, P = 16, N = 10^4", "w = T = 60 s", e7),
    ("E8", "dynamics2d, P = 16, N = 10^4", "w(A2) / w(A1) = 0.6", e8),
    ("E9", "dynamics2d, A16, P = 16, N = 10^4", "w = 0.6 T = 36 s", e9),
    ("E10", "dynamics2d, A16, P = 16, N = 10^5", "w = 10 T = 600 s; linear in N from 10^3", e10),
    ("E11", "dynamics2d", "w falls with E and with P; largest u at P = 16, A16, N = 10^5", e11),
    ("E12", "kinematics2d, P = 16, N = 10^4", "w = T = 60 s at A16; far slower with fewer engines", e12),
    ("E13", "dynamics3d, P = 16, N = 10^4", "w = T = 60 s at A16; all E close, A16 best", e13),
    ("E14", "dynamics2d, N = 10^5", "about 800 MB", e14),
)


def list_claims(criterion, results):
    try:
        return criterion(results)
    except NotRun as setting:
        return [Claim("-", "not run", f"no results of {setting}")]


def main():
    parser = argparse.ArgumentParser(description=DESCRIPTION, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", metavar="RUNS", nargs="+")
    arguments = parser.parse_args()
    try:
        results = Results(arguments.runs)
    except (OSError, KeyError, ValueError) as error:
        sys.exit(f"{', '.join(arguments.runs)}: these are no results of this study: {error!r}")
    print("# Chapter 5 of the thesis: printed values and ours\n")
    files = ", ".join(f"`{os.path.basename(path)}`" for path in arguments.runs)
    print(f"Made by `verdicts.py` from {files}: {results.describe_runs()} runs of each setting; "
          f"version {', '.join(results.versions)}. P = {', '.join(map(str, results.threads))} threads; where the thesis "
          f"has P = 16, P = {results.most_threads} is compared. {results.describe_disturbances()}\n")
    if results.ticks != [TICKS]:
        print(f"Runs have {', '.join(map(str, results.ticks))} ticks instead of {TICKS}; w is scaled.\n")
    print(f"w: wall time of the main loop; u = c / w: processors in use, on average; T = 60 s: simulated time; A4: four "
          f"engines share the arena. In brackets: intervals of {LEVEL:.0%}, of medians by order statistics, of ratios and "
          "differences by the rank-sum test. Of printed times and of the memory, \"reproduced\" means not more.\n")
    print("| # | Setting | Thesis | Here | Verdict | |")
    print("|---|---|---|---|---|---|")
    for name, setting, printed, criterion in CRITERIA:
        for ours, word, why in list_claims(criterion, results):
            print(f"| {name} | {setting} | {printed} | {ours} | **{word}** | {why} |")
            name = setting = printed = ""


if __name__ == "__main__":
    main()
