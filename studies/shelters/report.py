"""Active shelters: figures and verdicts of the campaigns.

Intervals are 95 % bootstrap intervals (BCa is not needed: means and medians of 20 to 100 runs; percentile, fixed seed).
"""
import os
import random
import sqlite3
import statistics
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from plot import FOLDER, fill_table, gnuplot, write_csv  # noqa: E402

LINES = ["smallest", "quartile_1", "median", "quartile_3", "largest"]
TICKS_PER_SECOND = 10


class Results:
    """The runs of a campaign that are done."""

    def __init__(self, file):
        self.database = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
        self.runs = {}
        cursor = self.database.execute("SELECT * FROM results WHERE status = 'done'")
        names = [column[0] for column in cursor.description]
        for row in cursor:
            run = dict(zip(names, row))
            self.runs[run["id"]] = run

    def select(self, **factors):
        return [i for i, run in self.runs.items() if all(run[k] == v for k, v in factors.items())]

    def series(self, name, run):
        return dict(self.database.execute("SELECT tick, value FROM series WHERE name = ? AND run = ?", (name, run)))

    def at(self, name, tick, runs):
        return [self.series(name, run).get(tick) for run in runs]

    def mean(self, name, runs):
        sums = {}
        for run in runs:
            for tick, value in self.series(name, run).items():
                sums.setdefault(tick, []).append(value)
        return {tick: statistics.mean(values) for tick, values in sums.items()}


def interval(values, function=statistics.mean, count=2000):
    values = [v for v in values if v is not None]
    generator = random.Random(1)
    estimates = sorted(function(generator.choices(values, k=len(values))) for _ in range(count))
    return function(values), estimates[int(0.025 * count)], estimates[int(0.975 * count)]


def show(triple, digits=1):
    return f"{triple[0]:.{digits}f} [{triple[1]:.{digits}f}, {triple[2]:.{digits}f}]"


def write_lines(name, results, runs, pick):
    rows = {}
    for line in LINES:
        for tick, value in pick(results, line, runs).items():
            rows.setdefault(tick, []).append(value)
    write_csv(name, ["time"] + LINES, [[tick / TICKS_PER_SECOND] + [f"{v:.2f}" for v in values]
                                       for tick, values in sorted(rows.items()) if len(values) == len(LINES)])


def grid(results, runs, count, tick):
    side = round(count ** 0.5)
    rows = [[0.0] * side for _ in range(side)]
    for i in range(count):
        values = [v for v in results.at(f"size_{i}", tick, runs) if v is not None]
        # shelter 0 is at the largest x and y
        rows[side - 1 - i // side][side - 1 - i % side] = statistics.mean(values) if values else 0.0
    return rows


def draw(name, results, runs, count, snapshots, length, event=None):
    """Top: one run, bottom: means over runs; group sizes over time, and grids of the sizes at some times."""
    sample = [min(runs)]
    parts = []
    for row, (title, chosen) in enumerate((("one run", sample), (f"mean of {len(runs)} runs", runs))):
        data = f"{name}_{row}.csv"
        write_lines(data, results, chosen, lambda r, line, c: r.mean(line, c))
        mark = f"set arrow 1 from {event},0 to {event},30 nohead dt 2 lc 'gray40'\n" if event else ""
        parts.append(f"""
{mark}set title "{title}" offset 0,1
set xrange [0:{length}]
set yrange [0:30]
set xlabel "time (s)"
set ylabel "robots in a group"
set size 0.52,0.5
set origin 0,{0.5 - 0.5 * row}
set key above left horizontal samplen 2
unset colorbox
plot "{data}" using 1:2:6 skip 1 with filledcurves lc rgb "#dddddd" title "smallest to largest", \\
     "" using 1:3:5 skip 1 with filledcurves lc rgb "#999999" title "quartiles", \\
     "" using 1:4 skip 1 with lines lw 2 lc rgb "#b00000" title "median"
unset arrow 1
""")
        width = 0.48 / len(snapshots)
        for i, time in enumerate(snapshots):
            cells = grid(results, chosen, count, time * TICKS_PER_SECOND)
            side = len(cells)
            lines = "\n".join(f"{x},{y},{cells[y][x]:.2f}" for y in range(side) for x in range(side))
            parts.append(f"""
$grid << EOD
{lines}
EOD
set title "{time} s" offset 0,0
set size {width},0.44
set origin {0.52 + i * width},{0.53 - 0.5 * row}
set size ratio -1
unset xlabel
unset ylabel
unset key
unset tics
set border 15
set xrange [-0.5:{side - 0.5}]
set yrange [-0.5:{side - 0.5}]
set palette defined (0 "white", 30 "black")
set cbrange [0:30]
plot $grid using 1:2:3 with image, "" using 1:2:(sprintf("%.0f", $3)):($3 > 15 ? 0xffffff : 0) with labels tc rgb variable
set size noratio
set xtics nomirror
set ytics nomirror
set border 3
set key
""")
    gnuplot(name, "set multiplot\n" + "\n".join(parts) + "\nunset multiplot\n", "1080,640")


def report_convergence(results, table):
    for count in (16, 25):
        runs = results.select(shelters=count)
        if not runs:
            continue
        draw(f"figure_7_8_{count}", results, runs, count, [250, 500, 750], 750)
        printed = {"quartile_1": 15, "median": 22, "quartile_3": 25}
        for line, value in printed.items():
            found = interval(results.at(line, 7500, runs))
            table.append([f"7.8, {count} shelters: {line.replace('_', ' ')} of the sizes after 750 s, mean of the runs", value,
                          show(found) + f", n = {len(runs)}",
                          "reproduced" if found[1] - 0.5 <= value <= found[2] + 0.5 else f"differs by {found[0] - value:+.1f}"])
        # the end of the fluctuating phase: the median is within one robot of its last value from then on
        ends = []
        for run in runs:
            course = sorted(results.series("median", run).items())
            last = statistics.mean(value for _, value in course[-10:])
            ends.append(max([tick for tick, value in course if abs(value - last) > 1.5], default=0) / TICKS_PER_SECOND)
        found = interval(ends, statistics.median)
        table.append([f"7.8, {count} shelters: length of the fluctuating phase, s", "about 400",
                      show(found, 0), "reproduced" if found[1] <= 500 and found[2] >= 300 else "differs"])
    lengths = [results.at("median", 7500, results.select(shelters=count)) for count in (16, 25)]
    if all(lengths):
        difference = statistics.mean(lengths[0]) - statistics.mean(lengths[1])
        table.append(["7.8: the median does not depend on the number of robots", "21 and 21, 22 and 22",
                      f"difference of the means {difference:+.2f}", "reproduced" if abs(difference) < 1 else "differs"])


def report_global(results, table):
    number = {"activates": "7_9", "deactivates": "7_10"}
    for event, figure in number.items():
        for place in ("corner", "centre"):
            runs = results.select(place=place, event=event)
            if not runs:
                continue
            draw(f"figure_{figure}_{place}", results, runs, 9, [750, 1000, 1500], 1500, 750)
            expected = 22.5 if event == "activates" else 20.0
            after = 42.5 - expected
            for tick, value, phase in ((7500, expected, 1), (15000, after, 2)):
                middle = interval(results.at("median", tick, runs))
                spread = interval(results.at("iqr", tick, runs))
                table.append([f"{figure.replace('_', '.')}, {place} {event}: end of phase {phase}, median; quartiles' difference",
                              f"{value:g}; tight", f"{show(middle)}; {show(spread)}, n = {len(runs)}",
                              "reproduced" if abs(middle[0] - value) < 1.5 and spread[0] < 6 else "differs"])
            where = 0 if place == "corner" else 4
            beside = [i for i in range(9) if abs(i // 3 - where // 3) + abs(i % 3 - where % 3) == 1]
            others = [i for i in range(9) if i != where and i not in beside]
            sizes = {i: results.at(f"size_{i}", 15000, runs) for i in range(9)}
            bias = interval([statistics.mean(sizes[i][run] for i in beside) - statistics.mean(sizes[i][run] for i in others)
                             for run in range(len(runs))])
            table.append([f"{figure.replace('_', '.')}, {place} {event}: size beside the event minus elsewhere, at the end", "no bias",
                          show(bias, 2), "reproduced" if bias[1] <= 0 <= bias[2] else "differs"])


def report_local(results, table):
    number = {"short": "7_11", "medium": "7_12", "global": "global"}
    found = {}
    for count in (16, 25):
        for signal, figure in number.items():
            runs = results.select(shelters=count, signal=signal)
            if not runs:
                continue
            draw(f"figure_{figure}_{count}", results, runs, count, [750, 1000, 1500], 1500, 750)
            bias = interval(results.at("bias", 15000, runs))
            found[count, signal] = bias
            rule = {"short": "negative", "medium": "negative, nearer to 0", "global": "near 0"}[signal]
            good = bias[2] < 0 if signal == "short" else \
                found[count, "short"][0] < bias[0] if signal == "medium" else bias[1] <= 0 <= bias[2] or abs(bias[0]) < 0.5
            table.append([f"{figure.replace('_', '.')}, {count} shelters: perturbed minus unperturbed mean size", rule,
                          f"{show(bias, 2)}, n = {len(runs)}",
                          "too few runs" if len(runs) < 3 else "reproduced" if good else "differs"])


def report_robots_30(results, table):
    times = {"printed": (500, 2500, 5000), "long": (7500, 15000, 22500)}
    active = ((0, 1), (0, 1, 2), (0, 2))
    for sizes in ("15,10,20", "12,12,12"):
        targets = [int(size) for size in sizes.split(",")]
        for name, ends in times.items():
            runs = results.select(sizes=sizes, times=name)
            if not runs:
                continue
            draw_robots_30(f"figure_7_6_{'a' if sizes[1] == '5' else 'b'}_{name}", results, runs, targets, ends)
            for phase, (end, groups) in enumerate(zip(ends, active), 1):
                total = min(1.0, 30 / sum(targets[i] for i in groups))
                ratios = [interval(results.at(f"ratio_{i}", end, runs)) for i in groups]
                table.append([f"7.6, targets {sizes}, {name} times: size / target at T{phase} of shelters "
                              + ", ".join(str(i + 1) for i in groups), f"equal; fair {total:.2f}",
                              "; ".join(show(r, 2) for r in ratios) + f", n = {len(runs)}",
                              judge_ratios([r[0] for r in ratios], total)])
            if name == "long":
                reach = []
                for run in runs:
                    course = results.series("converged", run)
                    reach.append(min([t for t, v in course.items() if t > ends[0] + 500 and t <= ends[1] and v >= 0.99],
                                     default=ends[1]) / 10 - ends[0] / 10)
                found = interval(reach, statistics.median)
                table.append([f"7.6, targets {sizes}: convergence in phase 2 is declared after, s", "slightly less than 600",
                              show(found, 0), "reproduced" if 400 <= found[0] < 650 else "differs"])


def judge_ratios(ratios, fair):
    spread = max(ratios) - min(ratios)
    reached = statistics.mean(ratios) / fair
    if spread >= 0.1:
        return f"differ by {spread:.2f}"
    return "reproduced" if reached >= 0.9 else f"equal, but not converged: {100 * reached:.0f} % of the fair share"


def draw_robots_30(name, results, runs, targets, ends):
    header = ["time"] + [f"{kind}_{i + 1}" for kind in ("run", "size", "ratio") for i in range(3)]
    columns = [results.mean(f"size_{i}", [min(runs)]) for i in range(3)]
    columns += [results.mean(f"size_{i}", runs) for i in range(3)] + [results.mean(f"ratio_{i}", runs) for i in range(3)]
    step = 50
    write_csv(f"{name}.csv", header, [[t / 10] + [f"{c[t]:.3f}" for c in columns]
                                      for t in sorted(columns[0]) if t % step == 0])
    parts = []
    for row, (title, label) in enumerate((("one run", "robots"), (f"mean of {len(runs)} runs", "robots"),
                                          (f"mean of {len(runs)} runs", "size / target"))):
        top = "[0:1.2]" if row == 2 else "[0:21]"
        arrows = "\n".join(f"set arrow {n} from {t / 10}, graph 0 to {t / 10}, graph 1 nohead dt 2 lc 'gray50'"
                           for n, t in enumerate(ends, 1))
        parts.append(f"""
set title "{title}"
set ylabel "{label}"
set yrange {top}
{arrows}
plot """ + ", ".join(f"'{name}.csv' using 1:{2 + 3 * row + i} skip 1 with lines lw 2 title 'shelter {i + 1}, target {targets[i]}'"
                     for i in range(3)))
    gnuplot(name, "set multiplot layout 3,1\nset xlabel 'time (s)'\nset key outside right\n" + "\n".join(parts)
            + "\nunset multiplot\n", "800,820")


def main(folder):
    table = []
    for name, function in (("robots_30", report_robots_30), ("convergence", report_convergence),
                           ("global", report_global), ("local", report_local)):
        file = os.path.join(folder, f"full_{name}.sqlite")
        if os.path.exists(file):
            function(Results(file), table)
    fill_table(table)
