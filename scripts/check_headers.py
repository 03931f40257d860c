#!/usr/bin/env python3
"""Checks that each public header can be included alone, as C++17: scripts/check_headers.py BUILD_FOLDER

BUILD_FOLDER needs to be configured only. Headers are seen in two ways: lean, as by the simulator's sources (with
ARGOS_WITHOUT_COMPANIONS), and with their companions, as by users' code.

Read from the include graph, which takes no compiler:
  - each include of a header is found in the include roots that its target links;
  - each header brings the companions that src/testing/compat/companions.txt lists.
Compiled:
  - Lean: a header is checked by a unit that includes it after headers which it brings anyway. So one unit checks a whole chain
    of headers, each of which brings those before it; half as many units as headers are enough.
  - With companions: without cycles of includes the order of headers has no effect, so one unit with all headers is enough, and
    one for each header that is in a cycle, where the header that comes first decides.

A unit that passed is not compiled again before a header that it includes, this script or the compiler changes: stamps lie in
$XDG_CACHE_HOME/argos3-checks, by default ~/.cache/argos3-checks, so that they outlive a build folder. ARGOS_CHECK_ALL=1
compiles every unit.
"""
import concurrent.futures
import hashlib
import os
import re
import subprocess
import sys

INCLUDE = re.compile(r'^ *# *include *[<"](argos3/[^>"]+)[>"]', re.MULTILINE)
COMPANIONS = re.compile(r"^#ifndef ARGOS_WITHOUT_COMPANIONS.*?^#endif", re.MULTILINE | re.DOTALL)
STANDARD_HEADERS = "argos3/core/utility/datatypes/standard_headers.h"

source = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def lines_of(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read().split("\n")[:-1]


class Header:
    """A header: its path as it is included, its file, and the headers that it includes."""

    def __init__(self, path, file, roots):
        self.path, self.file, self.roots = path, file, roots
        with open(file, encoding="utf-8") as text:
            self.text = text.read()
        self.includes = {"users": INCLUDE.findall(self.text), "lean": INCLUDE.findall(COMPANIONS.sub("", self.text))}
        self.is_public = False
        self.brings = {}  # for each kind the paths of all headers that come with this one, without itself


def find(path, roots):
    for root in roots:
        file = os.path.join(root, path)
        if os.path.isfile(file):
            return file
    return None


def read_headers(build, errors):
    """Reads the public headers of all targets, and those that they include."""
    folder = os.path.join(build, "header_checks")
    targets = [(lines_of(folder, target + ".headers"),
                [root for root in lines_of(folder, target + ".roots") if root != "/usr/include"])
               for target in lines_of(folder, "targets")]
    every_root = list(dict.fromkeys(root for _, roots in targets for root in roots))
    headers, waiting = {}, []
    for paths, roots in targets:
        for path in paths:
            headers[path] = Header(path, find(path, roots), roots)
            headers[path].is_public = True
            waiting.append(path)
    while waiting:
        header = headers[waiting.pop()]
        for path in header.includes["lean"]:
            if find(path, header.roots) is None:
                errors.append(f"{header.file}: <{path}> is in no library that this one links")
        for path in header.includes["users"]:
            file = find(path, every_root)
            if path not in headers and file is not None:
                headers[path] = Header(path, file, header.roots)
                waiting.append(path)
    for kind in ("lean", "users"):
        for header in headers.values():
            header.brings[kind] = closure(header, headers, kind)
    return headers, every_root


def closure(header, headers, kind):
    found, waiting = set(), [header.path]
    while waiting:
        for path in headers[waiting.pop()].includes[kind]:
            if path in headers and path not in found:
                found.add(path)
                waiting.append(path)
    return found - {header.path}


def check_companions(headers, errors):
    listing = os.path.join(source, "src/testing/compat/companions.txt")
    header = None
    for number, line in enumerate(lines_of(listing), 1):
        if not line.strip() or line.startswith("#"):
            continue
        path = "argos3/" + line.strip()
        if path not in headers or not headers[path].is_public:
            errors.append(f"{listing}:{number}: no library has the public header {path}")
        elif not line.startswith(" "):
            header = headers[path]
            if header.path != STANDARD_HEADERS and STANDARD_HEADERS not in header.brings["users"]:
                errors.append(f"{header.file}: must bring {STANDARD_HEADERS}")
        elif path not in header.brings["users"]:
            errors.append(f"{header.file}: must bring {path}")


def chains(headers):
    """Distributes the public headers over as few chains as possible, each header of which brings those before it.

    A largest matching of headers with headers that they bring (Dilworth's theorem; Kuhn's algorithm).
    """
    public = sorted(path for path, header in headers.items() if header.is_public)
    brought = {path: [other for other in sorted(headers[path].brings["lean"])
                      if headers[other].is_public and path not in headers[other].brings["lean"]] for path in public}
    before, after = {}, {}

    def match(path, seen):
        for other in brought[path]:
            if other not in seen:
                seen.add(other)
                if other not in after or match(after[other], seen):
                    before[path], after[other] = other, path
                    return True
        return False

    sys.setrecursionlimit(10 * len(public) + 1000)
    for path in public:
        match(path, set())
    for last in (path for path in public if path not in after):
        chain = [last]
        while chain[-1] in before:
            chain.append(before[chain[-1]])
        yield chain[::-1]


def units(headers, every_root):
    """@return (include roots, defines, paths of headers in their order, code behind them) of each unit."""
    for chain in chains(headers):
        yield headers[chain[-1]].roots, ["-DARGOS_WITHOUT_COMPANIONS"], chain, ""
    public = [path for path, header in sorted(headers.items()) if header.is_public]
    yield every_root, [], public, ""
    in_use = f"#include <{STANDARD_HEADERS}>\n" + "\n".join(
        lines_of(source, "src/testing/compat/standard_headers_in_use.h"))
    yield every_root, [], [STANDARD_HEADERS], in_use
    for path in public:
        brings = headers[path].brings["users"]
        if any(path in headers[other].brings["users"] for other in brings):
            yield every_root, [], [path], ""


class Compiler:
    def __init__(self, build, headers):
        command, *warnings = lines_of(build, "header_checks", "compiler")
        self.command = [command, "-x", "c++", "-std=c++17", "-fsyntax-only",
                        *(flag for flag in warnings if flag.startswith("-W"))]
        self.headers = headers
        cache = os.environ.get("XDG_CACHE_HOME") or os.path.expanduser("~/.cache")
        self.stamps = os.path.join(cache, "argos3-checks", "headers")
        self.all = os.environ.get("ARGOS_CHECK_ALL", "0") != "0"
        version = subprocess.run([command, "--version"], capture_output=True, check=True).stdout
        with open(__file__, "rb") as script:
            self.common = version + script.read() + " ".join(self.command).encode()

    def note(self, stamp):
        """Writes a stamp, without effect where none can be written."""
        try:
            os.makedirs(self.stamps, exist_ok=True)
            with open(stamp, "w", encoding="utf-8"):
                pass
        except OSError:
            pass

    def key(self, defines, paths, code):
        kind = "lean" if defines else "users"
        texts = hashlib.sha256(self.common + "\n".join([*defines, *paths, code]).encode())
        for path in sorted({other for path in paths for other in self.headers[path].brings[kind] | {path}}):
            texts.update(f"\n{path}\n{self.headers[path].text}".encode())
        return texts.hexdigest()

    def check(self, unit):
        """@return whether the unit was compiled, and what the compiler said: nothing if it passed."""
        roots, defines, paths, code = unit
        stamp = os.path.join(self.stamps, self.key(defines, paths, code))
        if os.path.exists(stamp) and not self.all:
            self.note(stamp)  # it is in use
            return False, ""
        text = "".join(f"#include <{path}>\n" for path in paths) + code + "\n"
        folders = [flag for root in roots for flag in ("-isystem" if root.startswith("/usr/") else "-I", root)]
        done = subprocess.run([*self.command, *defines, *folders, "-"], input=text, text=True, capture_output=True, check=False)
        if done.returncode == 0 and not done.stderr:
            self.note(stamp)
            return True, ""
        if os.path.exists(stamp):
            os.remove(stamp)  # it failed in spite of it
        return True, f"{paths[-1]} alone:\n{done.stderr}"


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        sys.exit(__doc__)
    if not os.path.exists(os.path.join(sys.argv[1], "header_checks", "compiler")):
        sys.exit(f"{sys.argv[1]} is not configured; run: cmake -S {source} -B {sys.argv[1]}")
    errors = []
    headers, every_root = read_headers(os.path.abspath(sys.argv[1]), errors)
    check_companions(headers, errors)
    compiler = Compiler(os.path.abspath(sys.argv[1]), headers)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(compiler.check, units(headers, every_root)))
    errors += [text for _, text in results if text]
    if errors:
        sys.exit("\n".join(errors))
    public = sum(header.is_public for header in headers.values())
    print(f"{public} public headers: {len(results)} units are fine, {sum(ran for ran, _ in results)} of them compiled now")


main()
