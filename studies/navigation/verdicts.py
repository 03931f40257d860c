#!/usr/bin/env python3
"""Properties of section 6.2: ./verdicts.py [--test] full.tables/runs.csv [attempts.tables/runs.csv]"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from verdicts import Table, parse_arguments, read_runs, select  # noqa: E402  # pylint: disable=wrong-import-position


def main():
    arguments = parse_arguments(__doc__)
    runs = read_runs(arguments.runs[0])
    attempts = read_runs(*arguments.runs[1:])
    table = Table()
    for scenario, text in (1, "delay falls with the number of robots, single navigation"), \
                          (2, "delay falls with the number of robots, collective navigation"):
        for robots, fewer in (5, 1), (10, 1):
            table.add_difference(text, f"delay with {robots} minus delay with {fewer}, s",
                                 select(runs, "delay", scenario=scenario, robots=robots),
                                 select(runs, "delay", scenario=scenario, robots=fewer), below=0.0, digits=1)
    text = "a spinning loop, collective navigation"
    table.add_median(text, "mean angular momentum, 10 robots that pass each other on the right",
                     select(runs, "mean_rotation", scenario=2, robots=10), above=0.1)
    for avoidance, rule in ("away", "on the free side"), ("habit", "on a side that each robot chooses"):
        table.add_median(text, f"magnitude of the mean angular momentum, 10 robots that pass each other {rule}",
                         select(attempts, "loop", avoidance=avoidance, clearance=0), above=0.1)
    table.add_median("no loop in single navigation (ours)", "mean angular momentum, 10 robots",
                     select(runs, "mean_rotation", scenario=1, robots=10), above=-0.05, below=0.05)
    table.finish(arguments.test)


main()
