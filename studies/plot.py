"""Files and figures of studies' scripts: gnuplot, as svg for the README and png to look at."""
import csv
import os
import subprocess
import sys

# of the study whose script runs
FOLDER = os.path.join(os.path.dirname(os.path.abspath(sys.argv[0])), "results")


def write_csv(name, header, rows):
    with open(os.path.join(FOLDER, name), "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


def fill_table(rows):
    """Prints the table of verdicts, and puts it into README.md, between its marks."""
    readme = os.path.join(os.path.dirname(FOLDER), "README.md")
    with open(readme, encoding="utf-8") as file:
        before, rest = file.read().split("<!--verdicts-->")
    after = rest.split("<!--end-->")[1]
    lines = ["| Figure, property | Printed | Ours, with 95 % interval | Verdict |", "|---|---|---|---|"]
    lines += ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]
    with open(readme, "w", encoding="utf-8") as file:
        file.write(before + "<!--verdicts-->\n" + "\n".join(lines) + "\n<!--end-->" + after)
    print("\n".join(lines))


def gnuplot(name, script, size="640,420"):
    """Draws results/<name>.svg, and .png if the environment has PNG=1."""
    kinds = {"svg": f"set terminal svg size {size} font 'Helvetica,13' background 'white'"}
    if os.environ.get("PNG"):
        kinds["png"] = f"set terminal pngcairo size {size} font 'Helvetica,11'"
    for kind, terminal in kinds.items():
        text = f"{terminal}\nset output '{name}.{kind}'\nset datafile separator ','\nset style fill noborder\n" \
               f"set datafile missing 'NaN'\nset tics nomirror\nset border 3\nset grid y lc 'gray90' lt 1\n{script}\n"
        if ".dat" in script:
            text = text.replace("set datafile separator ','", "set datafile separator whitespace")
        subprocess.run(["gnuplot"], input=text, text=True, check=True, cwd=FOLDER)
