#!/usr/bin/env python3
"""Gives the factory presets their sound words, measured on one note: docs/presets.md#sound-words.

    python3 docs/sound_words.py build/release/Source/Console/idiophone

Prints the figures, and writes the words behind the other tags in Presets. Needs numpy and soundfile.
"""
import json
import pathlib
import re
import sys
import tempfile

import numpy as np

from rendering import NOTE_ON, RATE, ROOT, Console

SECONDS, VELOCITY = 12, 90
# Each word holds up to its bound, the last one above; no word: None.
BRIGHTNESS = (("dark", 1000), ("warm", 2800), ("clear", 4500), ("bright", np.inf))  # Hz
LENGTH = (("short", 1), ("ringing", 4), ("long", np.inf))  # s
ATTACK = (("soft", 2800), (None, 4600), ("hard", np.inf))  # Hz
WORDS = {word for words in (BRIGHTNESS, LENGTH, ATTACK) for word, _ in words}


def word(words, value):
    return next(name for name, bound in words if value < bound)


def centroid(sound, seconds):
    """The mean frequency of the beginning in Hz, weighted by amplitude."""
    part = sound[:round(seconds * RATE)]
    spectrum = np.abs(np.fft.rfft(part * np.hanning(2 * part.size)[part.size:]))
    frequencies = np.fft.rfftfreq(part.size, 1 / RATE)
    return (spectrum * frequencies).sum() / spectrum.sum()


def t60(sound):
    """Seconds to fall by 60 dB, from the slope between -5 and -25 dB of Schroeder's integral."""
    energy = np.cumsum(sound[::-1]**2)[::-1]
    decibels = 10 * np.log10(energy / energy[0] + 1e-20)
    return 3 * (np.argmax(decibels <= -25) - np.argmax(decibels <= -5)) / RATE


def measure(console, preset):
    """Brightness in Hz, length in s and attack in Hz of the middle key, without the room."""
    key_map = preset["keyMap"]
    ranges = [part["keyMap"] for part in key_map.get("parts", ())] or [key_map]
    middle = (min(keys["lowestNote"] for keys in ranges) +
              max(keys["highestNote"] for keys in ranges)) // 2
    sound = console.render(preset["name"], [(0, NOTE_ON, middle, VELOCITY)], SECONDS).mean(axis=1)
    sound = sound[np.argmax(np.abs(sound) > 0.01 * np.abs(sound).max()):]
    return centroid(sound, 0.5), t60(sound), centroid(sound, 0.02)


def write_tags(file, words):
    text = file.read_text(encoding="utf-8")
    tags = [tag for tag in json.loads(text)["tags"] if tag not in WORDS] + words
    lines = ",\n".join(f"        {json.dumps(tag)}" for tag in tags)
    file.write_text(re.sub(r'"tags": \[[^\]]*\]', f'"tags": [\n{lines}\n    ]', text, count=1),
                    encoding="utf-8")


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        console = Console(pathlib.Path(sys.argv[1]).resolve(), folder, room=0)
        for file in sorted((ROOT / "Presets").glob("*.json")):
            preset = json.loads(file.read_text(encoding="utf-8"))
            brightness, length, attack = measure(console, preset)
            words = [found for found in (word(BRIGHTNESS, brightness), word(LENGTH, length),
                                         word(ATTACK, attack)) if found]
            write_tags(file, words)
            print(f"{preset['name']:20} {brightness:5.0f} Hz {length:6.2f} s {attack:6.0f} Hz  "
                  f"{', '.join(words)}")
