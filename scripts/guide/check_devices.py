#!/usr/bin/env python3
"""Checks the tables of doc/guide/devices.md against an installed simulator: devices against argos3 -q, classes and
methods against the headers, names in Lua against the tables of robots that have the devices.

    check_devices.py REPOSITORY PREFIX     in a folder for temporary files
"""
import pathlib
import re
import subprocess
import sys

NOT_IN_THE_TEST = {"planar_drive"}  # no built-in robot has it


def listed(kind):
    """Tags of all devices of a kind."""
    text = subprocess.run(["argos3", "-q", kind], capture_output=True, text=True, check=True).stdout
    return set(re.findall(r"\[ (\w+) \(", text))


def header_of(tag, kind):
    folder = {"footbot": "foot-bot", "eyebot": "eye-bot", "epuck": "e-puck", "pipuck": "pi-puck", "joints": "prototype"}
    name = {"cameras": "camera"}.get(tag, tag)
    robot = folder.get(tag.split("_")[0], "generic")
    return f"argos3/plugins/robots/{robot}/control_interface/ci_{name}_{kind}.h"


def with_own_includes(include, header):
    """A header and those of control interfaces that it includes."""
    text = (include / header).read_text()
    for other in re.findall(r"#include <(argos3/plugins/robots/[^>]*control_interface/[^>]*)>", text):
        text += with_own_includes(include, other)
    return text


def lua_names(cell):
    """Full names of the functions and readings in a cell: ".x" follows the last full one."""
    full = ""
    for name in re.findall(r"`((?:robot)?\.[^`(]*)", cell):
        full = name if name.startswith("robot") else full[:full.rindex(".")] + name
        yield re.sub(r"<\w+>", "*", full)


def main():
    repository, prefix = map(pathlib.Path, sys.argv[1:3])
    page = (repository / "doc/guide/devices.md").read_text()
    command = ["argos3", "-zc", repository / "scripts/guide/devices.argos"]
    known = subprocess.run(command, capture_output=True, text=True)
    in_lua = set(re.findall(r"^key (\S+)$", known.stdout, flags=re.M))
    problems = [] if known.returncode == 0 else [known.stderr]
    source = ""
    for kind in ("sensor", "actuator"):
        section = re.search(rf"^## {kind.capitalize()}s\b[^\n]*\n(.*?)^(?:## |<!--)", page, flags=re.M | re.S).group(1)
        rows = re.findall(r"^\| `(\w+)` \| `(\w+)`(.*?) \| (.*) \|$", section, flags=re.M)
        tags = {row[0] for row in rows}
        problems += [f"{kind} {tag}: in one list only" for tag in tags ^ listed(kind + "s")]
        for tag, name, methods, lua in rows:
            header = header_of(tag, kind)
            source += f"#include <{header}>\nstatic_assert(sizeof(argos::{name}) > 0);\n"
            text = with_own_includes(prefix / "include", header)
            words = re.findall(r"`(\w+)(?:\([^`]*\))?`", methods)
            problems += [f"{name} has no {word}" for word in words if not re.search(rf"\b{word}\b", text)]
            if tag not in NOT_IN_THE_TEST:
                problems += [f"{tag}: there is no {key} in Lua" for key in lua_names(lua) if key not in in_lua]
    pathlib.Path("devices.cpp").write_text(source)
    compiler = subprocess.run(["c++", "-std=c++17", "-fsyntax-only", f"-I{prefix}/include", "devices.cpp"],
                              capture_output=True, text=True)
    if compiler.returncode != 0:
        problems.append(compiler.stderr)
    print("\n".join(problems))
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
