#!/usr/bin/python3
"""Asks the search of the site the questions of questions.txt:

    check_questions.py SITE [-v]     SITE has search/search_index.json

The page that answers must be among the first ten pages found. It searches as the site does: with lunr, any word of the
question, a title counts more than the text, results are grouped by page.
"""
import json
import pathlib
import sys

from lunr import lunr

PAGES = 10  # of the first page of results
TITLE_BOOST = 1000  # of the site's theme


def ask(index, question):
    """The pages found, best first."""
    words = "".join(c if c.isalnum() or c in "_#" else " " for c in question)
    pages = {}
    for result in index.search(words):
        page = result["ref"].split("#")[0]
        pages[page] = max(pages.get(page, 0.0), result["score"])
    return sorted(pages, key=lambda page: -pages[page])


def main():
    site = pathlib.Path(sys.argv[1])
    documents = json.loads((site / "search" / "search_index.json").read_text(encoding="utf-8"))["docs"]
    index = lunr(ref="location", fields=[{"field_name": "title", "boost": TITLE_BOOST}, "text"], documents=documents)
    known = {document["location"].split("#")[0] for document in documents}
    failures = 0
    count = 0
    questions = pathlib.Path(__file__).with_name("questions.txt")
    for line in questions.read_text(encoding="utf-8").splitlines():
        if not line.strip() or line.startswith("#"):
            continue
        question, answers = (part.strip() for part in line.split("|"))
        expected = ["doc/" + answer.strip() + ".html" for answer in answers.split(",")]
        unknown = [page for page in expected if page not in known]
        if unknown:
            sys.exit(f"{questions.name}: the site has no page {', '.join(unknown)}")
        found = ask(index, question)
        places = [found.index(page) + 1 for page in expected if page in found]
        count += 1
        if not places or min(places) > PAGES:
            failures += 1
            print(f"not answered: {question} ({answers}: place {places or 'none'})\n  found: {', '.join(found[:PAGES])}")
        elif "-v" in sys.argv:
            print(f"{min(places):3} {question}")
    if failures:
        sys.exit(f"{failures} of {count} questions are not answered on the first page of results")
    print(f"the search answers {count} questions on its first page of results")


main()
