"""Tests the reduced form (reduced.sqlite): the main property of the study, with fixed seeds.

Each statement is an interval of 99 % (t distribution, 8 runs for each setting) that must lie within bounds.
"""
import math
import os
import statistics

from report import read

T_99 = {7: 3.499, 14: 2.977}  # two-sided, by degrees of freedom


def interval(values):
    half = T_99[len(values) - 1] * statistics.stdev(values) / math.sqrt(len(values))
    return statistics.mean(values) - half, statistics.mean(values) + half


def difference(first, second):
    variance = statistics.variance(first) / len(first) + statistics.variance(second) / len(second)
    half = T_99[len(first) + len(second) - 2] * math.sqrt(variance)
    mean = statistics.mean(first) - statistics.mean(second)
    return mean - half, mean + half


def main():
    _, runs = read(os.path.join(os.path.dirname(os.path.abspath(__file__)), "reduced.sqlite"))

    def values(metric, sigma, way):
        return [run[metric] for run in runs if run["sigma"] == sigma and run["way"] == way and run["seed"] <= 8]

    wrong = 0

    def require(text, found, low, high):
        nonlocal wrong
        holds = low <= found[0] and found[1] <= high
        wrong += not holds
        print(f"{'ok' if holds else 'WRONG'}: {text}: [{found[0]:.3f}, {found[1]:.3f}] within [{low}, {high}]")

    require("objects in 45 minutes without noise minus with noise", difference(values("delivered", 0, 0), values("delivered", 0.00134, 0)),
            0.01, 40)
    require("returns that found no object, with noise minus without", difference(values("lost", 0.00134, 0), values("lost", 0, 0)), 0.01, 20)
    require("error without noise, m", interval(values("error", 0, 0)), 0, 0.02)
    # straight out and back over 4 m, turned on the spot in between: mu s^2 / b = 0.19 m for the mean mu, 0.00168
    require("error with noise, m", interval(values("error", 0.00134, 0)), 0.1, 0.4)
    return 1 if wrong else 0
