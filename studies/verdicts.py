"""Verdicts about properties that studies reproduce, from the table of runs that argos3-campaign exports.

A property is a statement about a statistic, such as "the median is above 0.9". It is reproduced if the whole confidence
interval of the statistic fulfils it, not reproduced if no part of the interval does, and undecided otherwise. Intervals need
no assumption about the distribution of the runs:
  median      order statistics (H. A. David and H. N. Nagaraja, Order Statistics, 2003, section 7.1)
  difference  of two samples: the shift of Hodges and Lehmann, with the interval that belongs to the rank-sum test of
              Wilcoxon (M. Hollander, D. A. Wolfe and E. Chicken, Nonparametric Statistical Methods, 2014, section 4.3)
"""

import argparse
import csv
import math
import statistics
import sys

LEVEL = 0.95


def read_runs(*files):
    """The runs of several tables, a dictionary each; runs that failed are left out. `file` is the table's name."""
    runs = []
    for name in files:
        with open(name, newline="", encoding="utf-8") as file:
            rows = csv.DictReader(line for line in file if not line.startswith("#"))
            runs += [row | {"file": name} for row in rows if row["status"] == "done"]
    return runs


def select(runs, metric, **factors):
    """The values of a metric in the runs with these levels of factors."""
    return [float(run[metric]) for run in runs
            if run.get(metric) and all(run.get(name) == str(level) for name, level in factors.items())]


def median(values, level=LEVEL):
    """The median and its interval; the interval of too few runs is unlimited."""
    ordered = sorted(values)
    n = len(ordered)
    # the largest k for which P(fewer than k of n runs are below the median) is at most (1 - level) / 2
    k, tail = 0, 0.0
    while tail + math.comb(n, k) / 2**n <= (1 - level) / 2:
        tail += math.comb(n, k) / 2**n
        k += 1
    if k == 0:
        return statistics.median(ordered), -math.inf, math.inf
    return statistics.median(ordered), ordered[k - 1], ordered[n - k]


def difference(first, second, level=LEVEL):
    """The shift from the second sample to the first, and its interval (normal approximation, without ties)."""
    shifts = sorted(a - b for a in first for b in second)
    m, n = len(first), len(second)
    z = statistics.NormalDist().inv_cdf((1 + level) / 2)
    k = math.floor(m * n / 2 - z * math.sqrt(m * n * (m + n + 1) / 12))
    if k < 1:
        return statistics.median(shifts), -math.inf, math.inf
    return statistics.median(shifts), shifts[k - 1], shifts[-k]


def judge(estimate, above=-math.inf, below=math.inf):
    """The verdict on `above` < statistic < `below`. estimate: value, lower and upper end of the interval."""
    _, low, high = estimate
    if low > above and high < below:
        return "reproduced"
    if high <= above or low >= below:
        return "not reproduced"
    return "undecided"


class Table:
    """Collects verdicts; prints them as a table in Markdown."""

    def __init__(self):
        self.rows = []

    def add(self, text, what, estimate, n, above=-math.inf, below=math.inf, digits=2):
        """A property: `above` < statistic < `below`. estimate: value, lower and upper end of the interval; n: number of runs."""
        value, low, high = estimate
        verdict = judge(estimate, above, below)
        ours = f"{what}: {value:.{digits}f} [{low:.{digits}f}, {high:.{digits}f}], n = {n}"
        self.rows.append((text, ours, verdict))

    def add_median(self, text, what, values, **limits):
        if values:
            self.add(text, what, median(values), len(values), **limits)

    def add_difference(self, text, what, first, second, **limits):
        if first and second:
            self.add(text, what, difference(first, second), f"{len(first)} and {len(second)}", **limits)

    def finish(self, is_test):
        """Prints the table. With is_test, ends the program with 1 unless all properties are reproduced."""
        print(f"| Printed value or property | Ours, with {LEVEL:.0%} interval | Verdict |\n|---|---|---|")
        for row in self.rows:
            print("| " + " | ".join(row) + " |")
        if is_test and (not self.rows or any(row[2] != "reproduced" for row in self.rows)):
            sys.exit("a property is not reproduced, see above" if self.rows else "there are no runs")


def parse_arguments(description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--test", action="store_true", help="exit with 1 unless all properties are reproduced")
    parser.add_argument("runs", nargs="+", metavar="RUNS.csv", help="tables/runs.csv of argos3-campaign export")
    return parser.parse_args()
