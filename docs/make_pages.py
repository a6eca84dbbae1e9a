#!/usr/bin/env python3
"""The manual's pages of parameters and presets, from what the program says of them, and of mallets,
from the rack that is built into it: `./dev pages`.

    python3 docs/make_pages.py build/release/Source/Console/idiophone
"""
import json
import pathlib
import re
import subprocess
import sys

FOLDER = pathlib.Path(__file__).parent / "manual"
RACK = pathlib.Path(__file__).parents[1] / "Resources/Mallets/mallets.json"

PARAMETERS = """# Parameters

Every parameter that a host can automate. The window and the host show the name. Presets, scenes and `idiophone render
--set` take the id. If a range ends with *0 to 100*, the window shows 0 to 100 until you press *Units*. Hosts, presets and
the console use the units. `./dev pages` writes this page.
"""
GROUP = """
## {group}

| name | id | from, to | at first | what it does |
|---|---|---|---|---|
"""
PRESETS = """# Presets

The factory presets by program number. Many hosts show the first as 1. Keys are MIDI notes; 60 is middle C. If the keys of
a preset have pitches, other keys from 21 to 108 play the nearest object,
[resized](../presets.md#keys-without-an-object). Each sound is six notes, or three where keys are held, at a peak of −3 dBFS.
[Presets](../presets.md) describes the files. `./dev pages` writes this page, `docs/make_preset_sounds.py` the sounds,
`docs/make_preset_pictures.sh` the pictures.

| program | | preset | keys | what it is |
|---|---|---|---|---|
"""
MALLETS = """# Mallets

Choose a mallet on the Strike page, or set the parameter `mallet`: `idiophone render --set mallet=Yarn ...`. A softer or
heavier mallet touches the object for longer and sounds duller. [Presets](../presets.md#mallets) has the formula, and
explains how to add a mallet. The table has the order of the parameter's choices, after *Custom*. `./dev pages` writes
this page.

| mallet | mass, g | radius, mm | E* of the head, MPa | force exponent | source of the figures |
|---|---|---|---|---|---|
"""


def parameter_row(parameter, earlier):
    choices = ", ".join(parameter.get("choices", []))
    reach = choices or parameter["range_text"]
    if choices in earlier:
        reach = f"as `{earlier[choices]}`"
    elif choices:
        earlier[choices] = parameter["id"]
    if parameter["id"] == "material":
        reach = "Own, Custom, or one of the [materials](../materials.md)"
    if parameter["physical"]:
        reach += "; 0 to 100"
    return (f"| {parameter['name']} | `{parameter['id']}` | {reach} | {parameter['default_text']} | "
            f"{parameter['description']} |\n")


def parameters_page(parameters):
    groups, earlier = {}, {}
    for parameter in parameters:
        groups.setdefault(parameter["group"], []).append(parameter_row(parameter, earlier))
    return PARAMETERS + "".join(GROUP.format(group=group) + "".join(rows)
                                for group, rows in groups.items())


def file_name(preset):
    """The name of a preset's picture and sound, without ending."""
    return re.sub("[^a-z0-9]", "-", preset["name"].lower())


def preset_row(preset):
    keys, name = preset["keyMap"], preset["name"]
    return (f"| {preset['program']} | ![{name}](../../Resources/Pictures/{file_name(preset)}.png) | "
            f"[{name}](sounds/presets/{file_name(preset)}.ogg) | "
            f"{keys['lowestNote']} to {keys['highestNote']} | {preset['description']} |\n")


def presets_page(presets):
    return PRESETS + "".join(map(preset_row, presets))


def mallet_row(mallet):
    return (f"| {mallet['name']} | {mallet['mass_kg'] * 1e3:g} | {mallet['head_radius_m'] * 1e3:g} | "
            f"{mallet['effective_modulus_pa'] * 1e-6:g} | {mallet['force_exponent']:g} | {mallet['source']} |\n")


def mallets_page(mallets):
    return MALLETS + "".join(map(mallet_row, mallets))


def pages(console):
    """The text of each page, by its file."""
    def said(list_name):
        return json.loads(subprocess.run([console, list_name, "--json"], check=True,
                                         capture_output=True).stdout)
    rack = json.loads(RACK.read_text(encoding="utf-8"))
    return {FOLDER / "parameters.md": parameters_page(said("parameters")),
            FOLDER / "presets.md": presets_page(said("presets")),
            FOLDER / "mallets.md": mallets_page(rack["mallets"])}


if __name__ == "__main__":
    for file, text in pages(pathlib.Path(sys.argv[1]).resolve()).items():
        file.write_text(text, encoding="utf-8")
