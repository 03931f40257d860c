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
# what is no text of a page, and options in the text
MARKUP = re.compile(r"(<title.*?</title>|<script.*?</script>|<style.*?</style>|<pre.*?</pre>|<[^>]*>)", re.DOTALL)
OPTION = re.compile(r"(?<![\w-])(--[A-Za-z][\w-]*)")
HEADING = re.compile(r"(<h[1-4][^>]*>)([^<]*)(<)")


def with_breaks(match):
    begin, text, end = match.groups()
    words = re.split(r"(\s+)", text)
    return begin + "".join(re.sub(r"(/|::|_)(?=\w)", r"\1<wbr>", word) if len(word) > LONG else word for word in words) + end


def with_options(text):
    parts = MARKUP.split(text)
    # the parts with an even number are between the markup
    return "".join(part if i % 2 else OPTION.sub(r'<span class="option">\1</span>', part) for i, part in enumerate(parts))


def main():
    for page in pathlib.Path(sys.argv[1]).rglob("*.html"):
        if page.relative_to(sys.argv[1]).parts[0] != "api":
            text = page.read_text(encoding="utf-8")
            page.write_text(with_options(HEADING.sub(with_breaks, CODE.sub(with_breaks, text))), encoding="utf-8")


main()
