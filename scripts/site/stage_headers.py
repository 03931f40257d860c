#!/usr/bin/env python3
"""Copies the installed headers for Doxygen; line numbers change by a few:

- each header joins the group that groups.txt names for its folder, inside and after its namespace;
- elements and attributes of experiment files in comments are escaped;
- parameters whose names are comments get these names.

    stage_headers.py INCLUDE_FOLDER OUT
"""
import pathlib
import re
import sys

here = pathlib.Path(__file__).resolve().parent


def read_groups():
    groups = {}
    for line in (here / "groups.txt").read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            folder, group = line.split()
            groups[folder] = group
    return groups


def group_of(groups, path):
    for folder in [path, *path.parents]:
        if str(folder) in groups:
            return groups[str(folder)]
    sys.exit(f"{path}: no line of groups.txt is for this header")


def escape(line):
    # what is between backticks is verbatim
    parts = re.split(r"(`[^`]*`)", line)
    for i in range(0, len(parts), 2):
        parts[i] = re.sub(r"<(/?[a-z_][^<>]*|[A-Z][A-Za-z]*)>", r"\\<\1\\>", parts[i])
        parts[i] = parts[i].replace(" #table", r" \#table")
        parts[i] = re.sub(r"(?<=[/ \[(])@(?=length|quantity|id|position)", r"\\@", parts[i])
    return "".join(parts)


def prepare(text, group):
    begin, end = f"/** @addtogroup {group}\n */ /** @{{ */", "/** @} */"
    # the text behind @file on the same line would be taken for the name of a file
    lines = re.sub(r"@file (?=\w)", "@file\n * ", text).split("\n")
    opening = [i for i, line in enumerate(lines) if line == "namespace argos {"]
    closing = [i for i, line in enumerate(lines) if line == "}  // namespace argos"]
    in_comment = False
    for i, line in enumerate(lines):
        in_comment = in_comment or "/**" in line
        if in_comment or "///" in line:
            lines[i] = escape(line)
        if "*/" in line:
            in_comment = False
        lines[i] = re.sub(r"([&*]) ?/\*(\w+)\*/(?=[,)])", r"\1 \2", lines[i])
        lines[i] = lines[i].replace("Init(TConfigurationNode&)", "Init(TConfigurationNode& tree)")
    if len(opening) != len(closing) or not opening:
        return "\n".join(lines)
    for i in opening:
        lines[i] += " " + begin
    for i in closing:
        lines[i] = f"{end} {lines[i]}"
    if any(line.startswith("#define") for line in lines[closing[-1]:]):
        # macros come behind the namespace
        lines[closing[-1]] += " " + begin
        last = max(i for i, line in enumerate(lines) if line.startswith("#endif"))
        lines[last] = f"{end}\n{lines[last]}"
    return "\n".join(lines)


def main():
    include, out = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    groups = read_groups()
    for header in sorted(include.rglob("*.h")):
        path = header.relative_to(include)
        target = out / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(prepare(header.read_text(encoding="utf-8"), group_of(groups, path.relative_to("argos3"))),
                          encoding="utf-8")


main()
