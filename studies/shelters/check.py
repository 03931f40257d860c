"""Tests the reduced form (reduced.sqlite, reduced_lua.sqlite): the main property of the study, with fixed seeds.

Each statement is an interval of 99 % (t distribution, 24 or 48 runs) that must lie within bounds.
"""
import os

import model
from report import Results
from bounds import Statements, difference, interval  # found because report adds the folder above to the path


def main():
    folder = os.path.dirname(os.path.abspath(__file__))
    forms = [Results(os.path.join(folder, name)) for name in ("reduced.sqlite", "reduced_lua.sqlite")]
    statements = Statements()
    require = statements.require

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
    return 1 if model.check() or statements.wrong else 0
