#!/usr/bin/env python3
"""Checks that a shared library exports the functions that its header declares, and nothing else.

    exported_names.py LIBRARY HEADER
"""
import re
import subprocess
import sys


def main(library, header):
    with open(header, encoding="utf-8") as file:
        declared = set(re.findall(r"IDIOPHONE_API[^;(]*?\b(idiophone_\w+)\s*\(", file.read()))
    listed = subprocess.run(["nm", "-D", "--defined-only", library],
                            check=True, capture_output=True, text=True).stdout
    exported = {line.split()[2].split("@")[0] for line in listed.splitlines()
                if line.split()[1] != "A"}
    for name in sorted(declared ^ exported):
        print(f"{name} is {'declared' if name in declared else 'exported'} only")
    print(f"{len(declared)} functions")
    return 0 if declared and declared == exported else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
