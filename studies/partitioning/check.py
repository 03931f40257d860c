"""Tests the reduced form (reduced.sqlite): the main property of the study, with fixed seeds.

Each statement is an interval of 99 % (t distribution, 16 runs for each setting) that must lie within bounds.
"""
import os

from report import read
from bounds import Statements, difference, interval  # found because report adds the folder above to the path


def main():
    _, runs = read(os.path.join(os.path.dirname(os.path.abspath(__file__)), "reduced.sqlite"))

    def values(metric, sigma, way):
        return [run[metric] for run in runs if run["sigma"] == sigma and run["way"] == way and run["seed"] <= 16]

    statements = Statements()
    require = statements.require

    require("objects in 45 minutes without noise minus with noise", difference(values("delivered", 0, 0), values("delivered", 0.00134, 0)),
            0.01, 40)
    require("returns that found no object, with noise minus without", difference(values("lost", 0.00134, 0), values("lost", 0, 0)), 0.01, 20)
    require("error without noise, m", interval(values("error", 0, 0)), 0, 0.02)
    # straight out and back over 4 m, turned on the spot in between: mu s^2 / b = 0.19 m for the mean mu, 0.00168
    require("error with noise, m", interval(values("error", 0.00134, 0)), 0.1, 0.4)
    return 1 if statements.wrong else 0
