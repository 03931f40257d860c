"""Tests the reduced form (reduced.sqlite, reduced_lua.sqlite): the main property of the study, with fixed seeds.

Each statement is an interval of 99 % (t distribution, 24 or 48 runs) that must lie within bounds.
"""
import math
import os
import statistics

import model
from report import Results

T_99 = {23: 2.807, 46: 2.687, 47: 2.685}  # two-sided, by degrees of freedom


def interval(values):
    half = T_99[len(values) - 1] * statistics.stdev(values) / math.sqrt(len(values))
    return statistics.mean(values) - half, statistics.mean(values) + half


def difference(first, second):
    variance = statistics.variance(first) / len(first) + statistics.variance(second) / len(second)
    half = T_99[len(first) + len(second) - 2] * math.sqrt(variance)
    mean = statistics.mean(first) - statistics.mean(second)
    return mean - half, mean + half


def main():
    folder = os.path.dirname(os.path.abspath(__file__))
    forms = [Results(os.path.join(folder, name)) for name in ("reduced.sqlite", "reduced_lua.sqlite")]
    wrong = 0

    def require(text, found, low, high):
        nonlocal wrong
        holds = low <= found[0] and found[1] <= high
        wrong += not holds
        print(f"{'ok' if holds else 'WRONG'}: {text}: [{found[0]:.3f}, {found[1]:.3f}] within [{low}, {high}]")

    def at(metric, tick):
        return [value for form in forms for value in form.at(metric, tick, form.select())]

    added = at("ratio_2", 2500)
    require("size / target of shelter 3, 200 s after its activation", interval(added), 0.3, 1.0)
    removed = at("size_1", 5000)
    require("robots under shelter 2, 250 s after its deactivation", (min(removed), max(removed)), 0, 0)
    unequal = [a - b for a, b in zip(at("ratio_0", 5000), at("ratio_2", 5000))]
    require("difference of size / target between shelters 1 and 3 at the end", interval(unequal), -0.2, 0.2)
    free = at("free", 5000)
    require("free robots at the end", interval(free), 0, 9)
    for metric in ("ratio_0", "ratio_2"):
        both = [form.at(metric, 5000, form.select()) for form in forms]
        require(f"{metric} at the end, C++ minus Lua", difference(*both), -0.25, 0.25)
    return 1 if model.check() or wrong else 0
