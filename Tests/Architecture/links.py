#!/usr/bin/env python3
"""Checks that every link in the docs leads to a file and, if it names a heading, to that heading.

    links.py ROOT
"""
import pathlib
import re
import sys


def anchors(page):
    """Returns the anchors of a page's headings: lower case, hyphens for spaces."""
    headings = re.findall(r"^#+ +(.*)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def broken(root):
    pages = [*root.glob("*.md"), *root.glob("docs/**/*.md")]
    for page in pages:
        for link in re.findall(r"\]\(([^)\s]+)\)", page.read_text(encoding="utf-8")):
            if link.startswith(("http:", "https:", "mailto:")):
                continue
            path, _, anchor = link.partition("#")
            target = page.parent / path if path else page
            if not target.exists() or anchor and anchor not in anchors(target):
                yield f"{page.relative_to(root)}: {link}"
    if len(pages) < 10:
        yield f"{root}: there are no pages"


if __name__ == "__main__":
    faults = list(broken(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(faults) or "Every link leads somewhere.")
    sys.exit(1 if faults else 0)
