"""Task partitioning: figures and verdicts of the campaigns full.xml and sensitivity.xml, whose databases are in FOLDER.

Needs argos3-campaign, for the intervals of Wilcoxon's test, and gnuplot.
"""
import math
import os
import random
import shutil
import sqlite3
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from plot import FOLDER, fill_table, gnuplot, write_csv  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
REAL_SAMPLES = 61  # positions of real robots in the thesis


def read(file):
    database = sqlite3.connect(f"file:{file}?mode=ro", uri=True)
    cursor = database.execute("SELECT * FROM results WHERE status = 'done'")
    names = [column[0] for column in cursor.description]
    return database, [dict(zip(names, row)) for row in cursor]


def errors(database, runs):
    """(x, y) of all arrivals, in m."""
    found = []
    for run in runs:
        series = [dict(database.execute("SELECT tick, value FROM series WHERE run = ? AND name = ?", (run["id"], name)))
                  for name in ("error_x", "error_y")]
        found += [(series[0][tick], series[1][tick]) for tick in sorted(series[0]) if tick in series[1]]
    return found


def interval(values, function=statistics.mean, count=2000):
    generator = random.Random(1)
    estimates = sorted(function(generator.choices(values, k=len(values))) for _ in range(count))
    return function(values), estimates[int(0.025 * count)], estimates[int(0.975 * count)]


def show(triple, digits=1):
    return f"{triple[0]:.{digits}f} [{triple[1]:.{digits}f}, {triple[2]:.{digits}f}]"


def campaign_figures(folder, campaign):
    """The figures of the campaign tool. Returns the intervals of the figures of the kind difference: (time, lower, middle, upper)."""
    with tempfile.TemporaryDirectory() as scratch:
        for name in (campaign, "partitioning.argos"):
            shutil.copy(os.path.join(HERE, name), scratch)
        shutil.copy(os.path.join(folder, campaign.replace(".xml", ".sqlite")), scratch)
        os.symlink(os.path.join(HERE, "build"), os.path.join(scratch, "build"))
        out = os.path.join(scratch, "report")
        subprocess.run(["argos3-campaign", "report", campaign, "-o", out], cwd=scratch, check=True, stdout=subprocess.DEVNULL)
        kept = {}
        results = os.path.join(FOLDER, campaign.replace(".xml", ""))
        os.makedirs(results, exist_ok=True)
        for file in os.listdir(os.path.join(out, "figures")):
            path = os.path.join(out, "figures", file)
            if file.endswith(".svg") or (file.endswith(".png") and os.environ.get("PNG")):
                shutil.copy(path, results)
            elif file.startswith("difference") and file.endswith(".dat"):
                with open(path, encoding="utf-8") as data:
                    kept[file[:-4]] = [[float(x) for x in line.split()[:4]] for line in data if line[0].isdigit()]
        shutil.copy(os.path.join(out, "tables", "summary.csv"), results)
        return kept


def judge(rows):
    """How the intervals of the times after 15 minutes lie, and at which share of the times they are above and below 0."""
    rows = [row for row in rows if row[0] >= 900]
    above = sum(row[1] > 0 for row in rows)
    below = sum(row[3] < 0 for row in rows)
    middle = statistics.mean(row[2] for row in rows)
    text = f"{middle:+.1f} objects on average; interval above 0 at {above}, below at {below} of {len(rows)} times"
    return text, above / len(rows), below / len(rows)


def scatter(database, runs, sigma):
    panels = []
    generator = random.Random(1)
    for way in (0, 2):
        points = errors(database, [run for run in runs if run["way"] == way and run["sigma"] == sigma])
        data = f"errors_way_{way}.csv"
        sample = generator.sample(points, min(len(points), 1000))
        write_csv(data, ["x", "y"], [[f"{x:.4f}", f"{y:.4f}"] for x, y in sample])
        panels.append(f"""
set title "{'not partitioned' if way == 0 else f'partitioned, {way} m'}: {len(points)} arrivals"
plot "{data}" every ::{1 + REAL_SAMPLES} using 1:2 with points pt 7 ps 0.25 lc rgb "#9ecae1" title "model", \\
     "{data}" every ::1::{REAL_SAMPLES} using 1:2 with points pt 7 ps 0.5 lc rgb "#b00000" title "{REAL_SAMPLES} of them"
""")
    gnuplot("figure_6_8", "set multiplot layout 1,2\nset size ratio -1\nset xrange [-1:1]\nset yrange [-1:1]\nset xlabel 'ahead (m)'\n"
            "set ylabel 'to the left (m)'\nset xzeroaxis\nset yzeroaxis\n" + "\n".join(panels) + "\nunset multiplot\n", "900,480")


def main(folder):
    table = []
    database, runs = read(os.path.join(folder, "full.sqlite"))
    differences = campaign_figures(folder, "full.xml")
    count = len([run for run in runs if run["sigma"] == 0 and run["way"] == 0])
    for way in (0, 2):
        text, above, _ = judge(differences[f"difference_noise_way_{way}"])
        table.append([f"6.7: throughput without noise minus with noise, {'not partitioned' if way == 0 else 'partitioned'}",
                      "simulation without noise too optimistic: interval excludes 0", f"{text}; n = {count}",
                      "reproduced" if above > 0.5 else f"the same sign; shown at {100 * above:.0f} % of the times" if above > 0
                      else "undecided"])
    text, above, below = judge(differences["difference_way_noisy"])
    table.append(["throughput not partitioned minus partitioned, with noise", "not printed", f"{text}; n = {count}",
                  "partitioning delivers more" if below > 0.5 else "partitioning delivers less" if above > 0.5 else "undecided"])
    scatter(database, runs, 0.00134)
    for way in (0, 2):
        points = errors(database, [run for run in runs if run["way"] == way and run["sigma"] > 0])
        length = interval([math.hypot(x, y) for x, y in points])
        table.append([f"6.8: mean distance from the target, {'not partitioned' if way == 0 else 'partitioned'}, m",
                      "scatter, no numbers", f"{show(length, 3)}, {len(points)} arrivals", "scatter drawn"])
        lost = interval([run["lost"] for run in runs if run["way"] == way and run["sigma"] > 0])
        none = interval([run["lost"] for run in runs if run["way"] == way and run["sigma"] == 0])
        table.append([f"returns that found no object, in an hour, {'not partitioned' if way == 0 else 'partitioned'}", "not printed",
                      f"{show(lost)} with noise, {show(none)} without", "noise makes robots lose the source"
                      if lost[1] > none[2] else "no difference shown"])
    if os.path.exists(os.path.join(folder, "sensitivity.sqlite")):
        campaign_figures(folder, "sensitivity.xml")
    fill_table(table)
