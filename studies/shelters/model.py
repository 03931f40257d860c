#!/usr/bin/env python3
"""Active shelters: the mathematical model (section 7.5.1 of the thesis).

  model.py           writes results/model.csv, results/model_phase_2.csv and figures
  model.py --check   compares with the reference values (a fraction of a minute)

The fraction x0 of free robots and the fractions xi of robots under shelter i follow

  x0(t+1) = x0(t) - sum_i pi x0(t) + sum_i li(t) xi(t)
  xi(t+1) = xi(t) + pi x0(t) - li(t) xi(t)

with pi = c ji and li(t) = (l_hi - l_low) exp(-gamma t) + l_low, gamma = ln(10) / delta, t since the last reset. Shelter 3 is
activated when shelters 1 and 2 have converged (T1), then shelter 2 is deactivated (T2), and the end is T3.
"""
import math
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from plot import FOLDER, gnuplot, write_csv  # noqa: E402

L_HIGH, L_LOW = 1e-2, 1e-5
CONVERGED = 1e-6
COVERED = 0.1  # c, the share of the area that a shelter covers
SETS = {"P1": (0.75, 0.5, 0.25), "P2": (0.25, 0.5, 0.75)}
# T1, T2 - T1, T3 - T2
REFERENCE = {
    ("P1", 10): (90, 46204, 108),
    ("P1", 100): (336, 7073, 351),
    ("P1", 1000): (2273, 2193, 2372),
    ("P1", 10000): (12619, 11826, 13590),
    ("P2", 10): (146, 156059, 107),
    ("P2", 100): (365, 116928, 359),
    ("P2", 1000): (2501, 2193, 2372),
    ("P2", 10000): (14842, 11826, 13590),
}


def phase(free, groups, active, joins, delta, course=None, begin=0):
    """Runs until convergence. Returns the number of steps, and the fractions at the end."""
    join = [COVERED * joins[i] if active[i] else 0.0 for i in range(3)]
    total = sum(join)
    decay = math.exp(-math.log(10) / delta)
    fall = L_HIGH - L_LOW
    a, b, c = groups
    step = 0
    while True:
        leave = fall + L_LOW
        fall *= decay
        da = join[0] * free - leave * a
        db = join[1] * free - leave * b
        dc = join[2] * free - leave * c
        change = -da - db - dc
        free, a, b, c = free + change, a + da, b + db, c + dc
        step += 1
        if course is not None and (step < 100 or step % 10 == 0):
            course.append((begin + step, free, a, b, c))
        if abs(change) < CONVERGED and abs(da) < CONVERGED and abs(db) < CONVERGED and abs(dc) < CONVERGED:
            return step, free, [a, b, c]


def experiment(joins, delta, course=None):
    """Returns the lengths of the phases, and the fractions (free, 1, 2, 3) at the end of each."""
    first, free, groups = phase(1.0, [0.0] * 3, (True, True, False), joins, delta, course)
    ends = [(free, *groups)]
    second, free, groups = phase(free, groups, (True, True, True), joins, delta, course, first)
    ends.append((free, *groups))
    free, groups = free + groups[1], [groups[0], 0.0, groups[2]]
    third, free, groups = phase(free, groups, (True, False, True), joins, delta, course, first + second)
    ends.append((free, *groups))
    return (first, second, third), ends


def check():
    wrong = 0
    for (name, delta), expected in REFERENCE.items():
        lengths, _ = experiment(SETS[name], delta)
        same = lengths == expected
        wrong += not same
        print(f"{name}, delta {delta}: {lengths}, expected {expected}: {'equal' if same else 'DIFFERENT'}")
    return wrong


def write():
    rows = []
    for (name, delta) in REFERENCE:
        lengths, ends = experiment(SETS[name], delta)
        rows.append([name, delta, *lengths] + [f"{x:.4f}" for end in ends[1:] for x in end])
    write_csv("model.csv", ["set", "delta", "phase_1", "phase_2", "phase_3"]
              + [f"{x}_T{t}" for t in (2, 3) for x in ("free", "x1", "x2", "x3")], rows)
    rows = []
    for i in range(25):
        delta = 10 ** (1 + i / 8)
        rows.append([f"{delta:.2f}"] + [experiment(SETS[name], delta)[0][1] for name in SETS])
    write_csv("model_phase_2.csv", ["delta", "P1", "P2"], rows)
    gnuplot("figure_7_3", """
set logscale xy
set xlabel "delta, steps"
set ylabel "length of phase 2, steps"
set key top right
plot "model_phase_2.csv" using 1:2 with linespoints lw 2 pt 7 title "P1 = 0.75, 0.5, 0.25", \\
     "" using 1:3 with linespoints lw 2 pt 5 title "P2 = 0.25, 0.5, 0.75"
""")
    panels = []
    for name in SETS:
        for delta in (100, 1000):
            course = []
            lengths, _ = experiment(SETS[name], delta, course)
            marks = [sum(lengths[:n]) for n in (1, 2, 3)]
            data = f"model_{name}_{delta}.dat"
            thin = max(1, len(course) // 300)
            with open(os.path.join(FOLDER, data), "w", encoding="utf-8") as file:
                for row in course[:100:2] + course[100:400:6] + course[400::thin]:
                    file.write(" ".join(f"{x:g}" for x in row) + "\n")
            arrows = "\n".join(
                f"set arrow {n + 1} from {t},0 to {t},1 nohead dt 2 lc 'gray40'\n"
                f"set label {n + 1} 'T{n + 1}' at {t},{0.97 - 0.07 * n} right offset -0.3" for n, t in enumerate(marks))
            panels.append(f"""
{arrows}
set xrange [1:{marks[-1] * 1.1}]
set title "{name}, delta = {delta}"
plot "{data}" using 1:2 with lines lw 2 lc 'gray50' title "free", "" using 1:3 with lines lw 2 title "shelter 1", \\
     "" using 1:4 with lines lw 2 title "shelter 2", "" using 1:5 with lines lw 2 title "shelter 3"
""")
    gnuplot("figure_7_4", "set multiplot layout 2,2\nset logscale x\nset yrange [0:1]\nset xlabel 'step'\n"
            "set ylabel 'fraction of the robots'\nset key outside top center horizontal samplen 2\n" + "\n".join(panels) + "\nunset multiplot\n", "1000,720")


if __name__ == "__main__":
    sys.exit(check() if "--check" in sys.argv else write())
