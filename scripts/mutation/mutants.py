"""The operators of scripts/mutate.sh: small changes of a line of C++."""

import re
from typing import Iterator, NamedTuple, Optional


class Mutant(NamedTuple):
    path: str  # relative to the tree
    line: int  # from 1
    before: str
    after: str
    kind: str

    def describe(self) -> str:
        return f"{self.path}:{self.line}: {self.before.strip()}  ->  {self.after.strip()}"


# binary operators have spaces around them (clang-format), the brackets of templates have none
_SWAPS = [
    (" < ", " <= "), (" <= ", " < "), (" > ", " >= "), (" >= ", " > "), (" == ", " != "), (" != ", " == "),
    (" + ", " - "), (" - ", " + "), (" += ", " -= "), (" -= ", " += "), (" && ", " || "), (" || ", " && "),
]
_NUMBER = re.compile(r"(?<![\w.])(?<![\d.]e-)(\d+(?:\.\d+)?(?:e-?\d+)?)(?=[\s,;)\]}])")
_LIMIT = re.compile(r"\bstd::(min|max|clamp)(<\w+>)?\(")
_CONDITION = re.compile(r"\b(if|while) \(")
# messages, checks that tests cannot reach, and what the compiler evaluates
_SKIPPED = re.compile(r"^\s*(#|using |namespace |template|ARGOS_ASSERT|THROW_|static_assert|REGISTER_|for \()|\bLOG(ERR)?\b")


def find_end(text: str, start: int) -> Optional[int]:
    """Index of the bracket that closes the one before start."""
    depth = 1
    for i in range(start, len(text)):
        depth += (text[i] in "([{") - (text[i] in ")]}")
        if depth == 0:
            return i
    return None


def split_arguments(text: str) -> list[str]:
    parts, depth, start = [], 0, 0
    for i, c in enumerate(text):
        depth += (c in "([{") - (c in ")]}")
        if c == "," and depth == 0:
            parts.append(text[start:i].strip())
            start = i + 1
    return parts + [text[start:].strip()]


def change_number(number: str) -> str:
    if number.isdigit():
        return str(int(number) + 1)
    return repr(2.0 * float(number) or 1.0)


def is_comparison(condition: str) -> bool:
    """Negating it is the same as swapping == and !=."""
    return len(re.findall(" [!=]= ", condition)) == 1 and not re.search(" (&&|[|][|]) ", condition)


def mutate_line(line: str) -> Iterator[tuple[str, str]]:
    """Each change of a line without comments, with its kind."""
    for old, new in _SWAPS:
        for match in re.finditer(re.escape(old), line):
            # text is joined, not added
            if old in (" + ", " += ") and "~" in (line[match.start() - 1], line[match.end() : match.end() + 1]):
                continue
            yield "sign" if old.strip(" =") in ("+", "-") else "comparison", line[: match.start()] + new + line[match.end() :]
    for match in _CONDITION.finditer(line):
        end = find_end(line, match.end())
        if end is not None and not line[match.end() :].startswith("const"):
            condition = line[match.end() : end]
            if ";" in condition:
                continue
            if not is_comparison(condition):
                yield "condition", f"{line[: match.end()]}!({condition}){line[end:]}"
            if match[1] == "if":
                yield "condition", f"{line[: match.end()]}false{line[end:]}"
    for match in _LIMIT.finditer(line):
        end = find_end(line, match.end())
        if end is None or line[match.end()] == "{":
            continue
        arguments = split_arguments(line[match.end() : end])
        for kept in arguments[:1] if match[1] == "clamp" else arguments[:2]:
            yield "limit", f"{line[: match.start()]}({kept}){line[end + 1 :]}"
    for match in _NUMBER.finditer(line):
        yield "number", line[: match.start()] + change_number(match[1]) + line[match.end() :]


def list_code(text: str) -> Iterator[tuple[int, str]]:
    """The lines of code with their numbers; literals and comments are blank."""
    blank = lambda match: re.sub(r"[^\n]", "~", match[0])  # noqa: E731
    text = re.sub(r'R"\((?:.|\n)*?\)"|//[^\n]*|/\*(?:.|\n)*?\*/|"(?:\\.|[^"\\\n])*"|(?<!\d)\'(?:\\.|[^\'\\\n])+\'', blank, text)
    for number, line in enumerate(text.split("\n"), 1):
        yield number, line


def find_mutants(path: str, text: str, lines: Optional[set[int]] = None) -> list[Mutant]:
    """All changes of a file. lines: only of these; None: of all."""
    originals = text.split("\n")
    found = []
    in_message = False
    for number, code in list_code(text):
        in_message = in_message or bool(_SKIPPED.search(code)) and not code.rstrip("~ ").endswith(("{", ";", "}"))
        skipped = in_message or bool(_SKIPPED.search(code))
        if in_message and code.rstrip("~ ").endswith((";", "{", "}")):
            in_message = False
        if skipped or (lines is not None and number not in lines):
            continue
        original = originals[number - 1]
        for kind, changed in mutate_line(code):
            # put literals and comments back: a change is between a common head and a common tail
            head = next((i for i, (a, b) in enumerate(zip(code, changed)) if a != b), min(len(code), len(changed)))
            tail = 0
            while tail < min(len(code), len(changed)) - head and code[-1 - tail] == changed[-1 - tail]:
                tail += 1
            if "~" in changed[head : len(changed) - tail]:
                continue  # it would move a literal
            after = original[:head] + changed[head : len(changed) - tail] + original[len(original) - tail :]
            found.append(Mutant(path, number, original, after, kind))
    return found
