#!/usr/bin/env python3
"""A sound of each factory preset for the manual's page of presets, rendered by the console.

    python3 docs/make_preset_sounds.py build/release/Source/Console/idiophone [PRESET...]

A PRESET makes that sound alone. Needs numpy and soundfile. Writes docs/manual/sounds/presets/*.ogg;
`./dev pages` lists them.
"""
import json
import pathlib
import sys
import tempfile

import numpy as np
import soundfile

from make_pages import file_name
from rendering import NOTE_OFF, NOTE_ON, PRESSURE, ROOT, Console

FOLDER = ROOT / "docs" / "manual" / "sounds" / "presets"
RATE = 44100
LONGEST_SECONDS = 7
PEAK = 10 ** (-3 / 20)
SILENCE_DB = -60  # below the peak
STRIKE = 0  # choice of the parameter "contact"
RISE = (0, 4, 7, 12, 7, 16)  # semitones above the first note
VELOCITIES = (70, 80, 90, 105, 60, 120)


def notes_of(key_map):
    """Six notes about the middle of the preset's own keys."""
    lowest, highest = key_map["lowestNote"], key_map["highestNote"]
    first = max(lowest, min((lowest + highest) // 2 - 8, highest - RISE[-1]))
    return [min(first + step, highest) for step in RISE]


def struck(notes, every):
    return [(k * every, NOTE_ON, note, velocity)
            for k, (note, velocity) in enumerate(zip(notes, VELOCITIES))]


def held(notes, seconds):
    events = []
    for k, note in enumerate(notes):
        events += [(k * seconds, NOTE_ON, note, 90), (k * seconds + 0.01, PRESSURE, 90),
                   ((k + 0.95) * seconds, NOTE_OFF, note, 0)]
    return events


def phrase(preset):
    """A scene's bodies fall once, keys that are held play three notes, others six."""
    notes = notes_of(preset["keyMap"])
    if preset["keyMap"]["kind"] == "scene":
        return struck(notes[:1], 0)
    if preset["parameters"]["contact"] != STRIKE:
        return held(notes[:3], 1.6)
    return struck(notes, 0.35)


def cut(sound):
    """Without the silence at the end, faded out, at -3 dBFS."""
    sound = sound * PEAK / np.abs(sound).max()
    loud = np.flatnonzero(np.abs(sound).max(axis=1) > PEAK * 10 ** (SILENCE_DB / 20))
    sound = sound[:loud[-1] + 1]
    fade = min(len(sound), RATE // 2)
    sound[-fade:] *= np.linspace(1, 0, fade)[:, None] ** 2
    return sound


def write(console, preset):
    sound = cut(console.render(preset["name"], phrase(preset), LONGEST_SECONDS, RATE))
    path = FOLDER / (file_name(preset) + ".ogg")
    soundfile.write(path, sound, RATE, format="OGG", subtype="VORBIS")
    print(f"{path.name}: {len(sound) / RATE:.1f} s, {path.stat().st_size / 1000:.0f} kB")


def main(program, *wanted):
    FOLDER.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        console = Console(pathlib.Path(program).resolve(), folder)
        presets = json.loads(console.run("presets", "--json"))
        if not wanted:
            for old in FOLDER.glob("*.ogg"):
                old.unlink()
        for preset in presets:
            if not wanted or preset["name"] in wanted:
                write(console, preset)


if __name__ == "__main__":
    main(*sys.argv[1:])
