#!/usr/bin/env python3
"""Prepares the pages of the site for mkdocs:

- copies the pages of the repository, with the same paths; home.md of this folder becomes index.md, README.md about.md;
- makes links to files that are no pages links to copies of these files, and links to folders links to their READMEs;
- writes a page for each kind of plug-in, with what argos3 --query says about each;
- completes mkdocs.yml.

    stage_pages.py REPOSITORY ARGOS3 OUT     the program argos3; OUT gets docs/ and mkdocs.yml
"""
import html
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import textwrap

here = pathlib.Path(__file__).resolve().parent
README = pathlib.PurePosixPath("README.md")
HOME = pathlib.PurePosixPath("home.md")  # as if it were in the root of the repository
LINK = re.compile(r"(!?\[[^\]]*\]\()([^)\s]+)(\))")
KINDS = {
    "actuators": "Actuators", "sensors": "Sensors", "entities": "Entities", "robot_types": "Types of robots in XML",
    "physics_engines": "Physics engines", "dynamics3d_add_ons": "Add-ons of dynamics3d", "media": "Media",
    "visualizations": "Visualizations and outputs", "overlays": "Overlays", "fields": "Fields",
    "built_in_metrics": "Built-in metrics", "controllers": "Controllers", "loop_functions": "Loop functions",
    "elements": "Other elements of experiment files",
}


def pages_of(repository):
    listed = subprocess.run(
        ["git", "-c", f"safe.directory={repository}", "ls-files", "--cached", "--others", "--exclude-standard", "--", "*.md"],
        cwd=repository, check=True, capture_output=True, text=True).stdout.split("\n")
    return sorted({pathlib.PurePosixPath(path) for path in listed
                   if path and not path.startswith(".github/") and (repository / path).is_file()})


def target_of(page):
    # mkdocs makes an index.md of every README.md
    return {README: pathlib.PurePosixPath("about.md"), HOME: pathlib.PurePosixPath("index.md")}.get(page, page)


class Stage:
    def __init__(self, repository, docs):
        self.repository, self.docs = repository, docs
        self.pages = [page for page in pages_of(repository) if page != pathlib.PurePosixPath("scripts/site/home.md")]
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

    def convert(self, page, source=None):
        in_code, lines = False, []
        for line in (source or self.repository / page).read_text(encoding="utf-8").split("\n"):
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


def query(argos3):
    result = subprocess.run([argos3, "-n", "-q", "all", "--json"], check=True, capture_output=True, text=True,
                            env={**os.environ, "NO_COLOR": "1", "ARGOS_PLUGIN_PATH": ""})
    return json.loads(result.stdout)["plugins"]


def cell(text):
    """Text as a cell of a table."""
    return " ".join(html.escape(text, quote=False).replace("|", "\\|").split())


def describe_interface(interface):
    lines = ["", f"**C++** `{interface['class']}`, in", "", "```cpp", f"#include <{interface['header']}>", "```", ""]
    if interface["link"]:
        lines += [f"Link `{interface['link']}`. {cell(interface['text'])}", ""]
    tables = [("Method", interface["methods"])]
    tables += [(f"`{kind['name']}`", kind["fields"]) for kind in interface["types"]]
    for title, entries in tables:
        if entries:
            lines += [f"| {title} | |", "|---|---|"]
            lines += [f"| `{cell_code(entry['code'])}` | {cell(entry['text'])} |" for entry in entries]
            lines.append("")
    return lines


def cell_code(code):
    return " ".join(code.replace("|", "\\|").split())


def prose_of(text):
    return html.escape(text, quote=False).replace("*", "\\*").replace("_", "\\_")


def describe_manual(manual, has_table):
    """A manual, whose headings are lines of capitals, as headings, text, and blocks of what is indented.

    @param has_table  a table has the attributes.
    """
    lines = [""]
    for part in re.split(r"\n\s*\n(?=\S)", manual.strip("\n")):
        text, _, rest = part.partition("\n ") if not part.startswith(" ") else ("", "", part[1:])
        if has_table and text.startswith("ATTRIBUTES"):
            continue
        if text.isupper():
            lines += [f"**{cell(text).capitalize().replace('xml', 'XML')}**", ""]
        elif text:
            # elements are code
            words = re.split(r"(</?[a-z][^<>]*>)", text)
            lines += ["".join(f"`{word}`" if i % 2 else prose_of(word) for i, word in enumerate(words)), ""]
        if rest:
            block = textwrap.dedent(" " + rest).strip("\n")
            lines += ["```xml" if block.startswith("<") else "```text", block, "```", ""]
    return lines


def describe_plugin(plugin):
    lines = [f"## {plugin['label']} {{ #{anchor(plugin['label'])} }}", "", cell(plugin["brief"])]
    if plugin.get("interface", {}).get("class"):
        lines += describe_interface(plugin["interface"])
    if plugin.get("lua"):
        lines += ["", "**Lua**", "", "```text", *(entry["path"] for entry in plugin["lua"])]
        lines += ["", plugin["lua_text"].strip("\n")] if plugin["lua_text"] else []
        lines += ["```", ""]
    if plugin.get("robots"):
        fits = (f"[{fit['robot']}](entities.md#{anchor(fit['robot'])})" + (f" with `<{fit['needs']}>`" if fit["needs"] else "")
                for fit in plugin["robots"])
        lines += ["", "**Robots that it fits:** " + ", ".join(fits), ""]
    if plugin.get("devices"):
        for kind in ("sensor", "actuator"):
            fits = (f"[{device['label']}]({kind}s.md#{anchor(device['label'])})" for device in plugin["devices"]
                    if device["kind"] == kind)
            lines += ["", f"**{kind.capitalize()}s that fit:** " + ", ".join(fits), ""]
    if plugin.get("attributes"):
        lines += ["", "**XML**", "", "| Element | Attribute | Value | |", "|---|---|---|---|"]
        lines += [f"| `{a['element']}` | `{a['name']}` | {cell(a['type'])}{', required' if a['required'] else ''} | {cell(a['text'])} |"
                  for a in plugin["attributes"]]
    return lines + describe_manual(plugin["manual"], bool(plugin.get("attributes")))


def write_plugins(argos3, docs):
    """@return the lines of the navigation."""
    navigation = []
    (docs / "plugins").mkdir()
    index = ["# Plug-ins", "", "What is provided, as `argos3 -q NAME` describes it."]
    plugins = query(argos3)
    unknown = {plugin["list"] for plugin in plugins} - KINDS.keys()
    if unknown:
        sys.exit(f"argos3 --query lists kinds of plug-ins that the site does not have: {', '.join(sorted(unknown))}")
    for kind, title in KINDS.items():
        entries = [plugin for plugin in plugins if plugin["list"] == kind]
        if not entries:
            sys.exit(f"argos3 --query lists no {kind}")
        page = [f"# {title}", ""]
        index += ["", f"## {title}", "", "| | |", "|---|---|"]
        for plugin in entries:
            index.append(f"| [{plugin['label']}]({kind}.md#{anchor(plugin['label'])}) | {cell(plugin['brief'])} |")
            page += describe_plugin(plugin)
        (docs / "plugins" / f"{kind}.md").write_text("\n".join(page), encoding="utf-8")
        navigation.append(f"      - {title}: plugins/{kind}.md")
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
    stage.convert(HOME, here / "home.md")
    if stage.problems:
        sys.exit("\n".join(stage.problems))
    shutil.copyfile(here / "site.css", docs / "site.css")
    navigation = "\n".join(write_plugins(argos3, docs))
    settings = (here / "mkdocs.yml").read_text(encoding="utf-8").replace(" PLUGINS", "\n" + navigation)
    (out / "mkdocs.yml").write_text(f"{settings}docs_dir: {docs}\nsite_dir: {out / 'site'}\n", encoding="utf-8")


main()
