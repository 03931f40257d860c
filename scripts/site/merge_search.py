#!/usr/bin/env python3
"""Adds the API reference to the search of the pages:

    merge_search.py TAGFILE SITE     Doxygen's tag file; the folder with search/search_index.json and api/
"""
import json
import pathlib
import sys
import xml.etree.ElementTree as ElementTree


def main():
    site = pathlib.Path(sys.argv[2])
    index_file = site / "search" / "search_index.json"
    index = json.loads(index_file.read_text(encoding="utf-8"))
    added = 0
    for compound in ElementTree.parse(sys.argv[1]).getroot():
        kind = compound.get("kind")
        name, file = compound.findtext("name"), compound.findtext("filename")
        if kind not in ("class", "struct", "group") or not file or "<" in name:
            continue
        if not file.endswith(".html"):
            file += ".html"
        if not (site / "api" / file).is_file():
            sys.exit(f"{file} of the tag file is not in {site}/api")
        members = [member.findtext("name") for member in compound.findall("member")]
        title = compound.findtext("title") or name.removeprefix("argos::")
        text = "API reference. " + " ".join(dict.fromkeys(m for m in members if m and not m.startswith("~")))
        index["docs"].append({"location": f"api/{file}", "title": title, "text": text})
        added += 1
    index_file.write_text(json.dumps(index, ensure_ascii=False), encoding="utf-8")
    print(f"  the search finds {added} classes, structs and groups of the API")


main()
