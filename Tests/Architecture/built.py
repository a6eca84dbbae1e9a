#!/usr/bin/env python3
"""Checks that every *Test.cpp is a source in its folder's CMakeLists.txt. Other files would
never run.

    built.py TESTS_FOLDER
"""
import pathlib
import re
import sys


def sources(folder):
    """Returns the words of the folder's CMakeLists.txt outside comments."""
    lists = folder / "CMakeLists.txt"
    return set(re.sub("#.*", "", lists.read_text(encoding="utf-8")).split()) if lists.exists() else set()


def left_out(tests):
    files = sorted(tests.rglob("*Test.cpp"))
    for file in files:
        if file.name not in sources(file.parent):
            yield f"{file.relative_to(tests)}: {file.parent.name}/CMakeLists.txt does not build it"
    if not files:
        yield f"{tests}: there are no tests"


if __name__ == "__main__":
    faults = list(left_out(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(faults) or "Every test is built.")
    sys.exit(1 if faults else 0)
