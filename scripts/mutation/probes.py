"""Which tests reach which mutants: marks in the sources, and the test cases that pass them."""

import re
from typing import NamedTuple, Optional

from mutants import list_code

# relative to the tree
_HEADER = "scripts/mutation/reach.h"
# what opens a block of statements; not a list of values, a type or a namespace
_BLOCK = re.compile(r"(?:\)|\b(?:else|do|try|const|noexcept|override|mutable)|\]|\)\s*->\s*[\w:<>*& ]+|\bcase [^{]*:|\bdefault:)\s*\{$")
_NO_BLOCK = re.compile(r"^\s*(?:namespace|class|struct|union|enum|switch|extern)\b")


class Case(NamedTuple):
    program: str
    name: str
    seconds: float
    reached: str  # a character for each mutant: 1 if the test case comes to its block


def _list_code(text: str) -> list[str]:
    # shaders have mutants, and no marks
    text = re.sub(r'R"(\w+)\((?:.|\n)*?\)\1"', lambda match: re.sub(r"[^\n]", "~", match[0]), text)
    return [line for _, line in list_code(text)]


def _indentation(line: str) -> int:
    return len(line) - len(line.lstrip())


def _find_blocks(code: list[str]) -> dict[int, int]:
    """By the first line of each statement that opens a block: the line with the bracket."""
    blocks: dict[int, int] = {}
    for first, line in enumerate(code):
        if not line.strip("~ ") or _NO_BLOCK.match(line):
            continue
        for last in range(first, min(first + 12, len(code))):
            text = code[last].rstrip("~ ")
            if text.endswith("{") and _BLOCK.search(text):
                blocks[first] = last
            if text.endswith(("{", ";", "}", "public:", "protected:", "private:")):
                break
    return blocks


def find_probes(text: str, lines: list[int]) -> dict[int, list[int]]:
    """
    Where marks are needed.

    lines: of mutants, from 1.
    Returns the numbers of mutants by the index of a line that ends with the opening bracket of a block: that of the innermost
    block that can be told by its indentation, or all blocks of the file, for a change outside of functions.
    """
    code = _list_code(text)
    blocks = _find_blocks(code)
    probes: dict[int, list[int]] = {}
    for number, line in enumerate(lines):
        at = line - 1
        indentation = _indentation(code[at])
        found: Optional[int] = None
        for first in range(at - 1, -1, -1):
            if not code[first].strip("~ ") or _indentation(code[first]) >= indentation:
                continue
            indentation = _indentation(code[first])
            if first in blocks and blocks[first] < at:
                found = blocks[first]
                break
        for place in blocks.values() if found is None else [found]:
            probes.setdefault(place, []).append(number)
    return probes


def add_probes(path: str, text: str, probes: dict[int, list[int]], numbers: list[int]) -> str:
    """numbers: of the mutants of this file, whose path is relative to the tree, in the whole run. Lines keep their numbers."""
    if not probes:
        return text
    code = _list_code(text)
    lines = text.split("\n")
    for place, mutants in probes.items():
        end = len(code[place].rstrip("~ "))
        marks = "".join(f" argos_mutation::Mark({numbers[m]});" for m in sorted(set(mutants)))
        lines[place] = lines[place][:end] + marks + lines[place][end:]
    return f'#include "{"../" * path.count("/")}{_HEADER}"\n#line 1\n' + "\n".join(lines)


def read_cases(program: str, written: str) -> tuple[list[Case], list[str]]:
    """The test cases that passed, and the names of those that failed."""
    passed, failed = [], []
    for line in written.splitlines():
        result, seconds, reached, name = line.split(" ", 3)
        if result == "passed":
            passed.append(Case(program, name, float(seconds), reached))
        else:
            failed.append(name)
    return passed, failed


def order_cases(cases: list[Case], programs: list[str], digests: Optional[Case]) -> list[list[Case]]:
    """
    Groups of test cases in the order in which they run: quick ones of each program in one process, the digests, slow ones.

    programs: those that test the file come first.
    """
    order = {p: i for i, p in enumerate(programs)}
    groups: list[list[Case]] = []
    for low, high in ((0.0, 0.1), (0.1, 1.0)):
        quick: dict[str, list[Case]] = {}
        for case in cases:
            if low <= case.seconds < high:
                quick.setdefault(case.program, []).append(case)
        groups += [quick[p] for p in sorted(quick, key=lambda p: (order.get(p, len(order)), p))]
        if low == 0.0 and digests is not None:
            groups.append([digests])
    slow = [c for c in cases if c.seconds >= 1.0]
    return groups + [[c] for c in sorted(slow, key=lambda c: (c.seconds, c.name))]
