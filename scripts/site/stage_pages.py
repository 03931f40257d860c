#!/usr/bin/env python3
"""Prepares the pages of the site for mkdocs:

- copies the pages of the repository, with the same paths; README.md becomes index.md;
- makes links to files that are no pages links to copies of these files, and links to folders links to their READMEs;
- writes a page for each kind of plug-in, with what argos3 --query says about each;
- completes mkdocs.yml.

    stage_pages.py REPOSITORY ARGOS3 OUT     the program argos3; OUT gets docs/ and mkdocs.yml
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent
LINK = re.compile(r"(!?\[[^\]]*\]\()([^)\s]+)(\))")
KINDS = {
    "actuators": "Actuators", "sensors": "Sensors", "entities": "Entities", "physics_engines": "Physics engines",
    "dynamics3d_add_ons": "Add-ons of dynamics3d", "media": "Media", "visualizations": "Visualizations and outputs",
    "fields": "Fields", "loop_functions": "Loop functions",
}


def pages_of(repository):
    listed = subprocess.run(
        ["git", "-c", f"safe.directory={repository}", "ls-files", "--cached", "--others", "--exclude-standard", "--", "*.md"],
        cwd=repository, check=True, capture_output=True, text=True).stdout.split("\n")
    return sorted({pathlib.PurePosixPath(path) for path in listed
                   if path and not path.startswith(".github/") and (repository / path).is_file()})


def target_of(page):
    return pathlib.PurePosixPath("index.md") if str(page) == "README.md" else page


class Stage:
    def __init__(self, repository, docs):
        self.repository, self.docs = repository, docs
        self.pages = pages_of(repository)
        self.problems = []

    def resolve(self, page, link):
        """The link of a page, as it is from the page's place in docs/."""
        if re.match(r"[a-z]+:|#", link):
            return link
        path, hash_, anchor = link.partition("#")
        wanted = pathlib.PurePosixPath(os.path.normpath(page.parent / path))
        found = self.repository / wanted
        if found.is_dir():
            readme = wanted / "README.md"
            # a folder without a page of its own is shown by the page of its parent
            while readme not in self.pages:
                readme = readme.parent.parent / "README.md"
            wanted = readme
        elif wanted not in self.pages:
            if not found.is_file():
                self.problems.append(f"{page}: there is no {link}")
                return link
            target = self.docs / wanted
            # browsers show sources as text only if they do not know the type
            if target.suffix not in (".png", ".svg", ".gif", ".jpg", ".csv", ".webp"):
                wanted = wanted.with_name(wanted.name + ".txt")
                target = self.docs / wanted
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(found, target)
        return os.path.relpath(target_of(wanted), target_of(page).parent or ".") + hash_ + anchor

    def convert(self, page):
        in_code, lines = False, []
        for line in (self.repository / page).read_text(encoding="utf-8").split("\n"):
            if line.lstrip().startswith("```"):
                in_code = not in_code
                # marks for scripts/check_guide.sh come behind the language
                line = re.sub(r"^(\s*```\w*).*", r"\1", line)
            elif not in_code:
                line = LINK.sub(lambda m: m[1] + self.resolve(page, m[2]) + m[3], line)
                if re.match(r"([-*]|\d+\.) ", line) and lines and re.match(r"\S", lines[-1]) and \
                        not re.match(r"([-*]|\d+\.) ", lines[-1]) and not self.in_list(lines):
                    # Python's Markdown begins a list behind an empty line only
                    lines.append("")
            lines.append(line)
        target = self.docs / target_of(page)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text("\n".join(lines), encoding="utf-8")

    @staticmethod
    def in_list(lines):
        for line in reversed(lines):
            if not line.strip():
                return False
            if re.match(r"([-*]|\d+\.) ", line):
                return True
        return False


def query(argos3, word):
    result = subprocess.run([argos3, "-n", "-q", word], check=True, capture_output=True, text=True,
                            env={**os.environ, "NO_COLOR": "1", "ARGOS_PLUGIN_PATH": ""})
    return result.stdout


def write_plugins(argos3, docs):
    """@return the lines of the navigation."""
    navigation = []
    (docs / "plugins").mkdir()
    index = ["# Plug-ins", "", "What is provided, as `argos3 --query NAME` describes it."]
    for kind, title in KINDS.items():
        entries = re.findall(r"^   \[ (.+) \]\n      (.*)", query(argos3, kind), re.M)
        if not entries:
            continue
        page = [f"# {title}", ""]
        index += ["", f"## {title}", "", "| | |", "|---|---|"]
        for label, brief in entries:
            index.append(f"| [{label}]({kind}.md#{anchor(label)}) | {brief} |")
            # the description of this one among those whose names contain its name
            texts = re.split(r"^(?=\[ .+ \]$)", query(argos3, label.split(" ")[0]), flags=re.M)
            text = next((t for t in texts if t.startswith(f"[ {label} ]\n")), None)
            if text is None:
                sys.exit(f"argos3 --query {label.split(' ')[0]} does not describe [ {label} ], which --query {kind} lists")
            body = text.split("\n", 1)[1].strip("\n")
            page += [f"## {label} {{ #{anchor(label)} }}", "", "```text", body, "```", ""]
        (docs / "plugins" / f"{kind}.md").write_text("\n".join(page), encoding="utf-8")
        navigation.append(f"      - {title}: plugins/{kind}.md")
    if len(navigation) < 5:
        sys.exit("argos3 --query lists hardly any plug-ins; has its output changed?")
    (docs / "plugins" / "index.md").write_text("\n".join(index) + "\n", encoding="utf-8")
    return ["      - plugins/index.md", *navigation]


def anchor(label):
    return re.sub(r"[^a-z0-9]+", "-", label.lower()).strip("-")


def main():
    repository, argos3, out = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
    docs = out / "docs"
    docs.mkdir(parents=True)
    stage = Stage(repository, docs)
    for page in stage.pages:
        stage.convert(page)
    if stage.problems:
        sys.exit("\n".join(stage.problems))
    shutil.copyfile(here / "site.css", docs / "site.css")
    navigation = "\n".join(write_plugins(argos3, docs))
    settings = (here / "mkdocs.yml").read_text(encoding="utf-8").replace(" PLUGINS", "\n" + navigation)
    (out / "mkdocs.yml").write_text(f"{settings}docs_dir: {docs}\nsite_dir: {out / 'site'}\n", encoding="utf-8")


main()
