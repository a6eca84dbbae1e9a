#!/usr/bin/env python3
"""The sound of Idiophone Resonator for the manual: a kit dry, then through two objects.

    python3 docs/make_effect_sound.py build/release/Source/Console/idiophone EFFECT.vst3

Needs numpy, soundfile and pedalboard. Writes docs/manual/sounds/resonator.flac.
"""
import sys
import tempfile

import numpy as np
import pedalboard

from rendering import NOTE_ON, ROOT, Console, write_flac

RATE = 32000
BEAT = 0.25  # seconds: an eighth at 120 a minute
BARS = ("x...x...x..xx...", "..h...h...h...hh", "t.tt.tt.t.tt.tt.")
THROUGH = ("Glass Bowls", "Steel Plate")


def pattern(notes):
    return [(step * BEAT / 2, NOTE_ON, note, 110 if step % 4 == 0 else 80)
            for note, bar in zip(notes, BARS) for step, sign in enumerate(bar) if sign != "."]


def main(program, effect):
    with tempfile.TemporaryDirectory() as folder:
        kit = Console(program, folder).render("Junkyard Kit", pattern((36, 42, 45)), 3.5, RATE)
    parts = [kit]
    for preset in THROUGH:
        plugin = pedalboard.load_plugin(effect)
        plugin.program = preset
        through = plugin.process(np.ascontiguousarray(kit.T, np.float32), RATE, reset=True).T
        parts.append(through * np.abs(kit).max() / np.abs(through).max())
    write_flac(ROOT / "docs" / "manual" / "sounds" / "resonator.flac", parts, RATE)


if __name__ == "__main__":
    main(*sys.argv[1:])
