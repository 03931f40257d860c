#!/usr/bin/env python3
"""Tests of check_pages.py: pages that are right pass, and each kind of mistake is found.

    python3 scripts/guide/test_check_pages.py
"""
import pathlib
import tempfile
import unittest

import check_pages

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
# a page with a picture that its command makes; the page's file is in the folder of the page
MADE = "```sh\nffmpeg -v error -f lavfi -i color={} -frames:v 1 a.png\n```\n<!--picture a.png-->\n![a](a.png)\n"
RIGHT = {
    "state is kept": "```sh\nx=1; cd examples\n```\n```sh\necho $x; ls -d povray\n```\n```text\n1\npovray\n```\n",
    "lines left out": "```sh\nprintf 'a\\nb\\nc\\n'\n```\n```text\n...\nc\n```\n",
    "rest of a line": "```sh\necho 'took 3 s'\n```\n```text\ntook ... s\n```\n",
    "expected failure": "```sh fails=3\n(exit 3)\n```\n",
    "input is empty": "```sh\ncat\n```\n",
    "file": "```xml file=folder/a.xml\n<a />\n```\n```sh\ncat folder/a.xml\n```\n```text\n<a />\n```\n",
    "part of a file": "```cpp from=examples/evolution/main.cpp\nusing namespace argos;\n```\n",
    "untested": "```sh untested=needs-root\nfalse\n```\n",
    "link": "[a](page.md#a-title)\n\n## A title\n",
}
WRONG = {
    "command": "```sh\nfalse\ntrue\n```\n",
    "hidden command": "<!--sh\nfalse\n-->\n",
    "unexpected success": "```sh fails=1\ntrue\n```\n",
    "other status": "```sh fails=1\n(exit 3)\n```\n",
    "too much output": "```sh\necho a; echo b\n```\n```text\na\n```\n",
    "too little output": "```sh\necho a\n```\n```text\na\nb\n```\n",
    "output of nothing": "```text\na\n```\n",
    "unchecked block": "```xml\n<a />\n```\n",
    "changed listing": "```cpp from=examples/evolution/main.cpp\nusing namespace argo;\n```\n",
    "part of a line": "```cpp from=examples/evolution/main.cpp\nnamespace argos;\n```\n",
    "no reason": "```sh untested\nfalse\n```\n",
    "no end": "```sh\ntrue\n",
    "the shell ends": "```sh\nexit 0\n```\n",
    "link": "[a](none.md)\n",
    "picture without a file": "<!--picture none.png-->\n![a](none.png)\n",
    "picture that is not shown": "<!--picture none.png-->\n\n![a](none.png)\n",
    "anchor": "[a](page.md#none)\n\n## A title\n",
}


class TestPages(unittest.TestCase):
    def check(self, text):
        with tempfile.TemporaryDirectory() as name:
            page = pathlib.Path(name) / "page.md"
            page.write_text(text)
            return check_pages.check_page(page, REPOSITORY, pathlib.Path("/nonexistent"))[0]

    def test_right_pages_pass(self):
        for name, text in RIGHT.items():
            with self.subTest(name):
                self.assertEqual(self.check(text), "")

    def test_pictures_are_made_and_compared(self):
        with tempfile.TemporaryDirectory() as name:
            page = pathlib.Path(name) / "page.md"
            for picture, makes, right in (
                    ("red:s=80x60", False, False),  # the page has no picture yet
                    ("red:s=80x60", True, True),
                    ("red:s=80x60", False, True),
                    ("0xfe0000:s=80x60", False, True),
                    ("0xe00000:s=80x60", False, False),
                    ("red:s=80x60,drawbox=0:0:8:8:black:fill", False, False)):
                page.write_text(MADE.format(picture))
                error = check_pages.check_page(page, REPOSITORY, pathlib.Path("/nonexistent"), makes)[0]
                self.assertEqual(error == "", right, f"{picture}: {error}")

    def test_mistakes_are_found(self):
        for name, text in WRONG.items():
            with self.subTest(name):
                self.assertNotEqual(self.check(text), "")


if __name__ == "__main__":
    unittest.main()
