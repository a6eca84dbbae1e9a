#!/usr/bin/env python3
"""docs/manual/parameters.md, from the program's own table.

    python3 docs/make_parameters.py build/release/Source/Console/idiophone
"""
import json
import pathlib
import subprocess
import sys

PAGE = pathlib.Path(__file__).parent / "manual" / "parameters.md"
HEAD = """# Parameters

Everything that a host can automate. The name is what the window and the host show; the id is what presets, scenes and
`idiophone render --set` take. This page is made by `docs/make_parameters.py`.
"""
TABLE = """
## {group}

| name | id | from, to | at first | what it does |
|---|---|---|---|---|
"""


def row(parameter):
    reach = ", ".join(parameter.get("choices", [])) or parameter["range_text"]
    if parameter["id"] == "material":
        reach = "Own, Custom, or one of the [materials](../materials.md)"
    return (f"| {parameter['name']} | `{parameter['id']}` | {reach} | {parameter['default_text']} | "
            f"{parameter['description']} |\n")


def page(console):
    said = subprocess.run([console, "parameters", "--json"], check=True, capture_output=True)
    groups = {}
    for parameter in json.loads(said.stdout):
        groups.setdefault(parameter["group"], []).append(row(parameter))
    return HEAD + "".join(TABLE.format(group=group) + "".join(rows)
                          for group, rows in groups.items())


if __name__ == "__main__":
    PAGE.write_text(page(pathlib.Path(sys.argv[1]).resolve()))
