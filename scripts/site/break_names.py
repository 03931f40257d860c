#!/usr/bin/env python3
"""Lets browsers break long names of the site's pages at the end of a part, so that pages fit a phone:

    break_names.py SITE

Paths may break behind "/", other long names behind "_" and "::". Options, such as --set, break nowhere. Blocks of code
stay as they are.
"""
import pathlib
import re
import sys

LONG = 24  # letters that fit a phone in any place
CODE = re.compile(r"(?<!<span></span>)(<code>)([^<]*)(</code>)")
OPTION = re.compile(r"--?[A-Za-z][\w-]*[,;]?")
HEADING = re.compile(r"(<h[1-4][^>]*>)([^<]*)(<)")


def with_breaks(match):
    begin, text, end = match.groups()
    words = re.split(r"(\s+)", text)
    for i, word in enumerate(words):
        if len(word) > LONG:
            words[i] = re.sub(r"(/|::|_)(?=\w)", r"\1<wbr>", word)
        elif end == "</code>" and OPTION.fullmatch(word):
            words[i] = f'<span class="option">{word}</span>'
    return begin + "".join(words) + end


def main():
    for page in pathlib.Path(sys.argv[1]).rglob("*.html"):
        if page.relative_to(sys.argv[1]).parts[0] != "api":
            text = page.read_text(encoding="utf-8")
            page.write_text(HEADING.sub(with_breaks, CODE.sub(with_breaks, text)), encoding="utf-8")


main()
