#!/usr/bin/env python3
"""Runs the commands of the guide's pages, and checks their listings, links and expected outputs.

    check_pages.py [--pictures] REPOSITORY PREFIX [PAGE]...     by default all pages of doc/guide/

A page's commands run in a copy of examples/ and experiments/, with PREFIX/bin in the PATH, in the order of the page, in
one shell. A fenced block is one of these, by the words after its language:

    ```sh                   commands; fails=N: one of them has the exit status N
    ```text                 what the block above it has printed; "..." stands for a rest of a line, or alone for lines
    ```xml file=NAME        a file, written before the commands that follow; of any language
    ```cpp from=PATH        lines of that file of the repository; of any language
    ```sh needs=gdb         commands; left out, with a message, where programs cannot be debugged
    ```sh untested=REASON   neither run nor compared; of any language

Hidden commands, for checks, are comments that begin with "<!--sh" and end with "-->"; GUIDE_REPOSITORY and GUIDE_PREFIX
are the two folders.

The comment "<!--picture FILE-->" says that the picture or film in the next line is FILE, which the commands above it have
made. pictures.py compares the two; with --pictures it makes the page's picture from FILE instead.
"""
import concurrent.futures
import functools
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time

import pictures

FENCE = re.compile(r"^```(\w*) ?(.*)$")
LINK = re.compile(r"\]\(([^)#\s]*)(#[^)\s]*)?\)")
PICTURE = re.compile(r"<!--picture (\S+)-->$")
SHOWN = re.compile(r"!\[[^\]]+\]\((\S+)\)$")
# runs a block; the status is that of its last command that failed, if any
RUN_BLOCK = "failed=0; trap 'failed=$?' ERR; . {block} </dev/null >{output} 2>&1; trap - ERR; echo $failed >&3\n"


# what a block may need, and the command that succeeds where it can be had
NEEDS = {"gdb": ["gdb", "-batch", "-return-child-result", "-ex", "run", "--args", "true"]}
LEFT_OUT = object()  # in place of what a block has printed


class PageError(Exception):
    pass


@functools.lru_cache
def can_be_had(need):
    if need not in NEEDS:
        raise PageError(f"needs={need} is not known")
    try:
        run = subprocess.run(NEEDS[need], capture_output=True, text=True, timeout=60, check=False)
    except OSError:
        return False
    return run.returncode == 0 and "exited normally" in run.stdout


class Block:
    def __init__(self, line, language, words, text, made=None, shown=None):
        self.line = line
        self.made = made  # for a picture: the file that commands have made, and the one that the page shows
        self.shown = shown
        self.language = language
        self.options = dict(word.partition("=")[::2] for word in words.split())
        self.text = text


def read_blocks(page):
    """The fenced blocks and hidden commands of a page, in order."""
    blocks = []
    start, words, lines = 0, None, []
    text = page.read_text().split("\n")
    for number, line in enumerate(text, 1):
        match = FENCE.match(line)
        if words is None and (made := PICTURE.match(line)):
            shown = SHOWN.match(text[number]) if number < len(text) else None
            if not shown:
                raise PageError(f"line {number}: no picture follows")
            blocks.append(Block(number, "picture", "", "", made[1], page.parent / shown[1]))
        elif words is None and (match or line == "<!--sh"):
            start, words, lines = number, match.groups() if match else ("sh", "hidden"), []
        elif words is not None and line == ("-->" if words[1] == "hidden" else "```"):
            blocks.append(Block(start, words[0], words[1], "\n".join(lines) + "\n"))
            words = None
        elif words is not None:
            lines.append(line)
    if words is not None:
        raise PageError(f"line {start}: the block has no end")
    return blocks


def prose(page):
    """The text of a page without its blocks."""
    return re.sub(r"^```.*?^```$|^<!--sh$.*?^-->$", "", page.read_text(), flags=re.M | re.S)


def anchors(page):
    """Names of the headings of a page, as links write them."""
    headings = re.findall(r"^#+ (.*)$", prose(page), flags=re.M)
    return {"#" + re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-") for text in headings}


def check_links(page):
    for path, anchor in LINK.findall(prose(page)):
        if path.startswith(("http:", "https:")):
            continue
        target = page.parent / path if path else page
        if not target.exists():
            raise PageError(f"the link to {path} leads nowhere")
        if anchor and target.suffix == ".md" and anchor not in anchors(target):
            raise PageError(f"the link to {path}{anchor} leads nowhere")


def to_pattern(expected):
    """A regular expression for the whole output."""
    pattern = ""
    for line in expected.splitlines():
        if line == "...":
            pattern += r"(?:.*\n)*?"
        else:
            pattern += ".*".join(re.escape(part) for part in line.split("...")) + r"\s*?\n"
    return re.compile(pattern)


class Shell:
    """One bash for a page."""

    def __init__(self, folder, repository, prefix):
        environment = dict(os.environ, PATH=f"{prefix}/bin:{os.environ['PATH']}", NO_COLOR="1",
                           CMAKE_PREFIX_PATH=str(prefix), LC_ALL="C.UTF-8", GUIDE_REPOSITORY=str(repository),
                           GUIDE_PREFIX=str(prefix), CCACHE_BASEDIR=str(folder))
        self.folder = folder
        reader, writer = os.pipe()
        self.status = os.fdopen(reader)
        self.process = subprocess.Popen(["bash", "-c", f"exec 3>&{writer}; exec bash --norc"], cwd=folder,
                                        stdin=subprocess.PIPE, env=environment, text=True, pass_fds=[writer])
        os.close(writer)
        self.timer = threading.Timer(300.0, self.process.kill)
        self.timer.start()

    def run(self, text):
        """@return exit status and output."""
        block, output = self.folder / ".block", self.folder / ".output"
        block.write_text(text)
        self.process.stdin.write(RUN_BLOCK.format(block=block, output=output))
        self.process.stdin.flush()
        status = self.status.readline()
        printed = output.read_text(errors="replace")
        if not status:
            raise PageError(f"the shell has ended:\n{printed}")
        return int(status), printed

    def close(self):
        self.timer.cancel()
        self.process.stdin.close()
        self.process.wait()
        self.status.close()


def check_picture(block, shell, makes_pictures):
    made = pathlib.Path(shell.run("pwd")[1].strip()) / block.made
    try:
        if makes_pictures:
            pictures.make(made, block.shown)
        pictures.check(made, block.shown)
    except pictures.PictureError as problem:
        raise PageError(problem) from problem


def check_block(block, shell, repository, printed, makes_pictures):
    """@return what the block has printed, LEFT_OUT, or None."""
    options = block.options
    if block.language == "picture":
        check_picture(block, shell, makes_pictures)
    elif "untested" in options:
        if not options["untested"]:
            raise PageError("untested= needs a reason")
    elif "from" in options:
        source = (repository / options["from"]).read_text()
        if ("\n" + block.text) not in ("\n" + source):
            raise PageError(f"differs from {options['from']}")
    elif "file" in options:
        file = shell.folder / options["file"]
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(block.text)
    elif block.language == "sh" and "needs" in options and not can_be_had(options["needs"]):
        print(f"  line {block.line} is left out: this system has no {options['needs']} that works", flush=True)
        return LEFT_OUT
    elif block.language == "sh":
        status, printed = shell.run(block.text)
        if status != int(options.get("fails", 0)):
            raise PageError(f"exit status {status}, it printed:\n{printed}")
        return printed
    elif block.language == "text" and printed is not None:
        if printed is not LEFT_OUT and not to_pattern(block.text).fullmatch(printed.rstrip("\n") + "\n"):
            raise PageError(f"expected\n{block.text}\nfound\n{printed}")
    else:
        raise PageError("nothing checks this block: it needs file=, from= or untested=")
    return None


def check_page(page, repository, prefix, makes_pictures=False):
    """@return the text of an error, or an empty one; and the time, s."""
    began = time.monotonic()
    error = ""
    with tempfile.TemporaryDirectory(prefix="guide-") as name:
        folder = pathlib.Path(name)
        for part in ("examples", "experiments"):
            shutil.copytree(repository / part, folder / part)
        shell = Shell(folder, repository, prefix)
        line = 1
        try:
            printed = None
            for block in read_blocks(page):
                line = block.line
                printed = check_block(block, shell, repository, printed, makes_pictures)
            line = 1
            check_links(page)
        except (PageError, OSError) as problem:
            error = f"{page}:{line}: {problem}"
        shell.close()
    return error, time.monotonic() - began


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--pictures"]
    makes_pictures = len(arguments) < len(sys.argv) - 1
    repository, prefix = (pathlib.Path(argument).resolve() for argument in arguments[:2])
    pages = [pathlib.Path(name).resolve() for name in arguments[2:]]
    pages = pages or sorted((repository / "doc/guide").glob("*.md"))
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        checks = pool.map(lambda page: check_page(page, repository, prefix, makes_pictures), pages)
        for page, (error, seconds) in zip(pages, checks):
            print(f"  {page.name}: {seconds:.0f} s" if not error else error, flush=True)
            failed += bool(error)
    print(f"{failed} of {len(pages)} pages failed" if failed else f"{len(pages)} pages do what they say")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
