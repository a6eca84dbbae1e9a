#!/usr/bin/env python3
"""Every *Test.cpp is a source of its folder's CMakeLists.txt: one that is not would never fail.

    built.py TESTS_FOLDER
"""
import pathlib
import re
import sys


def sources(folder):
    """What the folder's CMakeLists.txt names outside comments."""
    lists = folder / "CMakeLists.txt"
    return set(re.sub("#.*", "", lists.read_text()).split()) if lists.exists() else set()


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
