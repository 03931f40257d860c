#!/usr/bin/env python3
"""Properties of section 6.1: ./verdicts.py [--test] full.tables/runs.csv [full_lua.tables/runs.csv]"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from verdicts import Table, parse_arguments, read_runs, select  # noqa: E402  # pylint: disable=wrong-import-position

NAMES = {"hcs": "HCS", "ics": "ICS", "scs": "SCS"}


def main():
    arguments = parse_arguments(__doc__)
    runs = read_runs(arguments.runs[0])
    lua = [run for run in read_runs(*arguments.runs[1:]) if "scenario" in run]
    table = Table()
    for algorithm, name in NAMES.items():
        table.add_median("order goes to near 1", f"{name}, scenario 2, end of phase 1",
                         select(runs, "order_1", scenario=2, algorithm=algorithm), above=0.9)
    for algorithm in "ics", "scs":
        table.add_median("accuracy rises to near 1 in phase 1", f"{NAMES[algorithm]}, scenario 2",
                         select(runs, "accuracy_1", scenario=2, algorithm=algorithm), above=0.9)
    table.add_median("the swarm follows the target to the other end", "ICS, accuracy, scenario 2, end of phase 2",
                     select(runs, "accuracy_2", scenario=2, algorithm="ics"), above=0.9)
    table.add_median("SCS leaves the first target for the second one (values close to 0 are good)",
                     "accuracy, scenario 3, end of phase 2",
                     select(runs, "accuracy_2", scenario=3, algorithm="scs"), below=0.1)
    table.add_median("SCS resumes the first target", "accuracy, scenario 3, end of phase 3",
                     select(runs, "accuracy_3", scenario=3, algorithm="scs"), above=0.9)
    table.add_difference("ICS is held between the two targets [L]", "accuracy of ICS minus SCS, scenario 3, end of phase 2",
                         select(runs, "accuracy_2", scenario=3, algorithm="ics"),
                         select(runs, "accuracy_2", scenario=3, algorithm="scs"), above=0.1)
    table.add_difference("HCS is slower than ICS [L]", "time until the accuracy is 0.9, HCS minus ICS, s",
                         select(runs, "rise", scenario=2, algorithm="hcs"),
                         select(runs, "rise", scenario=2, algorithm="ics"), above=0.0, digits=1)
    table.add_difference("HCS is less accurate than ICS [L]", "accuracy, HCS minus ICS, scenario 2, end of phase 1",
                         select(runs, "accuracy_1", scenario=2, algorithm="hcs"),
                         select(runs, "accuracy_1", scenario=2, algorithm="ics"), below=0.0)
    for scenario, algorithm in (2, "ics"), (3, "scs"):
        table.add_difference("the same statistics in C++ and in Lua (ours)",
                             f"{NAMES[algorithm]}, accuracy, scenario {scenario}, end of phase 2, Lua minus C++",
                             select(lua, "accuracy_2", scenario=scenario, algorithm=algorithm),
                             select(runs, "accuracy_2", scenario=scenario, algorithm=algorithm), above=-0.02, below=0.02,
                             digits=3)
    table.finish(arguments.test)


main()
