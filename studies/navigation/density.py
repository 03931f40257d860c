#!/usr/bin/env python3
"""Density and mean movement of robots as a picture: ./density.py ROBOTS.csv PICTURE.svg [--from S]

ROBOTS.csv is the table that `argos3 --csv FOLDER` writes. The brighter a cell of 10 cm, the more time robots that move spent
in it. An arrow shows the mean of their displacements in a cell of 40 cm."""

import argparse
import collections
import csv
import math

CELL, ARROW_CELL = 0.1, 0.4  # m
SCALE = 110  # pixels per m
MARGIN = 0.1  # m
# from dark to bright; perceptually uniform (viridis)
COLOURS = ((68, 1, 84), (59, 82, 139), (33, 145, 140), (94, 201, 98), (253, 231, 37))


def read(name, start):
    outlines, arena, paths = [], None, collections.defaultdict(list)
    with open(name, newline="", encoding="utf-8") as file:
        lines = list(file)
    for line in lines:
        if line.startswith("# polygon:"):
            outlines.append([tuple(map(float, point.split(","))) for point in line.split(":")[1].split()])
        elif line.startswith("# arena:"):
            arena = [tuple(map(float, point.split(","))) for point in line.split(":")[1].split()]
    for row in csv.DictReader(line for line in lines if not line.startswith("#")):
        if float(row["time"]) >= start:
            paths[row["robot"]].append((float(row["x"]), float(row["y"])))
    return outlines, arena, paths


def colour(share):
    place = min(share, 0.9999) * (len(COLOURS) - 1)
    low, rest = int(place), place % 1
    return "#" + "".join(f"{round(a + (b - a) * rest):02x}" for a, b in zip(COLOURS[low], COLOURS[low + 1]))


def count(paths):
    cells = collections.Counter()
    movements = collections.defaultdict(lambda: [0.0, 0.0, 0])
    for path in paths.values():
        for (x0, y0), (x, y) in zip(path, path[1:]):
            if math.hypot(x - x0, y - y0) < 1e-3:
                continue  # stands still
            cells[math.floor(x / CELL), math.floor(y / CELL)] += 1
            movement = movements[math.floor(x / ARROW_CELL), math.floor(y / ARROW_CELL)]
            movement[0] += x - x0
            movement[1] += y - y0
            movement[2] += 1
    return cells, movements


def draw(outlines, arena, paths):
    (left, bottom), (right, top) = arena

    def place(x, y):
        return (x - left + MARGIN) * SCALE, (top - y + MARGIN) * SCALE

    width, height = place(right + MARGIN, bottom - MARGIN)
    cells, movements = count(paths)
    # the densest cells, where robots wait, would leave the others dark
    brightest = sorted(cells.values())[int(0.98 * (len(cells) - 1))]
    yield (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" '
           f'height="{height:.0f}"><rect width="100%" height="100%" fill="{colour(0)}"/>')
    for (i, j), number in sorted(cells.items()):
        x, y = place(i * CELL, (j + 1) * CELL)
        size = CELL * SCALE + 0.3  # without gaps
        yield f'<rect x="{x:.1f}" y="{y:.1f}" width="{size:.1f}" height="{size:.1f}" fill="{colour(number / brightest)}"/>'
    for outline in outlines:
        points = " ".join("{:.1f},{:.1f}".format(*place(x, y)) for x, y in outline)
        yield f'<polygon points="{points}" fill="#bbbbbb"/>'
    enough = sum(movement[2] for movement in movements.values()) / len(movements) / 10
    longest = max(math.hypot(x, y) / n for x, y, n in movements.values() if n > enough)
    for (i, j), (x, y, number) in sorted(movements.items()):
        if number <= enough:
            continue
        factor = 0.45 * ARROW_CELL / longest / number
        cx, cy = (i + 0.5) * ARROW_CELL, (j + 0.5) * ARROW_CELL
        (x1, y1), (x2, y2) = place(cx - x * factor, cy - y * factor), place(cx + x * factor, cy + y * factor)
        angle = math.degrees(math.atan2(y2 - y1, x2 - x1))
        yield f'<path d="M{x1:.1f},{y1:.1f}L{x2:.1f},{y2:.1f}" stroke="white" stroke-width="2"/>'
        yield f'<path d="M4,0L-5,4L-5,-4Z" fill="white" transform="translate({x2:.1f},{y2:.1f}) rotate({angle:.0f})"/>'
    for path in paths.values():
        if math.dist(path[0], path[-1]) < 0.1 and len({(round(x, 1), round(y, 1)) for x, y in path}) < 4:
            yield '<circle cx="{:.1f}" cy="{:.1f}" r="9" fill="none" stroke="white" stroke-width="2"/>'.format(*place(*path[0]))
    yield "</svg>"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("robots")
    parser.add_argument("picture")
    parser.add_argument("--from", dest="start", type=float, default=0.0, metavar="S", help="only from this time on")
    arguments = parser.parse_args()
    with open(arguments.picture, "w", encoding="utf-8") as file:
        file.write("\n".join(draw(*read(arguments.robots, arguments.start))) + "\n")


main()
