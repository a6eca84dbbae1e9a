#!/usr/bin/env python3
"""The sounds of the manual and the table that lists them, all rendered by the console.

    python3 docs/make_sounds.py build/release/Source/Console/idiophone [NAME...]

A NAME makes that sound alone; all take a minute. Needs numpy and soundfile. Writes
docs/manual/sounds/*.flac and, of all, docs/manual/sounds.md.
"""
import pathlib
import sys
import tempfile

from rendering import CONTROL, NOTE_OFF, NOTE_ON, PRESSURE, ROOT, Console, write_flac

MANUAL = ROOT / "docs" / "manual"
SONG = ROOT / "Resources" / "Songs" / "TheEntertainer.mid"
RATE = 32000  # Hz; what is above 16 kHz is not missed, and the files are smaller
HEAD = """# Sounds

Listen here to what the [manual](README.md) describes. Each file has a peak of −3 dBFS. The last column lists the preset
and the parameters of each part. This command makes all files and this page:

    python3 docs/make_sounds.py build/release/Source/Console/idiophone

[Contact sounds](../contact-sounds.md) has more sounds.

| sound | what you hear | preset and parameters |
|---|---|---|
"""


def strikes(notes, every=0.45, velocities=(100,), held=None):
    """Notes one after the other, let go after `held` seconds or not at all."""
    events = []
    for k, note in enumerate(notes):
        events.append((k * every, NOTE_ON, note, velocities[k % len(velocities)]))
        if held:
            events.append((k * every + held, NOTE_OFF, note, 0))
    return events


def bow(note):
    """Lightly, then harder, then faster; the object rings on."""
    return [(0, NOTE_ON, note, 40), (2, PRESSURE, 90), *((3 + k / 20, CONTROL, 1, 64 + 3 * k) for k in range(21)),
            (4.5, NOTE_OFF, note, 0)]


def scrape():
    """One second slow, one fast; then a second of pressing harder."""
    return [(0, CONTROL, 1, 30), (0, NOTE_ON, 60, 100), (0, PRESSURE, 40), (1, CONTROL, 1, 127),
            (2, CONTROL, 1, 60), *((2 + k / 20, PRESSURE, 40 + 4 * k) for k in range(20)),
            (3, NOTE_OFF, 60, 0)]


CHORD = (60, 64, 67, 72)
# name, what is heard, preset, events, seconds, and the parameters of each part
SOUNDS = (
    ("song", "the beginning of the factory song on xylophone, marimba and vibraphone",
     "Rosewood Xylophone", SONG, 3.5,
     ({"preset": "Rosewood Xylophone"}, {"preset": "Marimba"}, {"preset": "Vibraphone"})),
    ("velocity", "a plate, struck from soft to hard: it becomes louder and brighter", "Steel Plate",
     strikes([60] * 5, 0.6, (20, 45, 70, 100, 127)), 3.2, ({},)),
    ("place", "a wok, struck at its rim and then further down its side", "Wok",
     strikes([48, 56, 64, 72, 80]), 3, ({},)),
    ("mallets", "one bar under yarn, rubber, wood and brass", "Rosewood Xylophone", strikes([72]), 0.6,
     tuple({"mallet": name, "match_loudness": "On"}
           for name in ("Yarn", "Medium rubber", "Wood", "Brass"))),
    ("materials", "one plate of rosewood, plastic, glass, aluminium and steel", "Steel Plate",
     strikes([60]), 1.2, tuple({"material": name, "match_loudness": "On"}
                             for name in ("Rosewood", "Plastic", "Glass", "Aluminium", "Steel"))),
    ("size", "a handbell at twice, once and half its size", "Handbell", strikes([72]), 1.4,
     tuple({"keep_pitch": "Off", "size": size} for size in (2, 1, 0.5))),
    ("damping", "bells that ring on, then bells that are damped when their keys are released",
     "Tubular Bells", strikes(CHORD, 0.5, held=0.45), 2.8,
     ({"let_ring": "On"}, {"let_ring": "Off", "release": 0.3})),
    ("motor", "a vibraphone with its discs at rest, then turning", "Vibraphone",
     strikes(CHORD, 0.02), 3, ({"motor_depth": 0}, {"motor_depth": 90, "motor_speed": 4})),
    ("radiation", "a plate heard at the struck point, then as its whole surface radiates to both ears",
     "Steel Plate", strikes([48, 60, 72]), 2, ({"radiation": 0}, {"radiation": 100, "level": 6})),
    ("room", "stones without reverb, in a small room and in a hall", "Stones", strikes([72, 76, 79], 0.2),
     2, ({"room": 0}, {"room": 40, "room_decay": 0.6}, {"room": 60, "room_decay": 3})),
    ("scrape", "a point that scrapes a plate: slowly, fast, then with more force", "Scraped Plate",
     scrape(), 3.5, ({},)),
    ("bow", "a bowed bar of a vibraphone, then a rubbed glass: pressed lightly, harder, then moved faster",
     "Bowed Vibraphone", bow(69), 5.5, ({"preset": "Bowed Vibraphone"}, {"preset": "Rubbed Glass"})),
    ("truncation", "a plate with all audible modes, then with τ so high that its tail breaks off",
     "Steel Plate", strikes([60]), 2, ({"tau": 0.1}, {"tau": 100}, {"tau": 400})),
    ("dice", "dice that fall on the bars of a xylophone", "Dice on Rosewood",
     strikes([65, 72, 77, 84], 0.35), 3, ({},)),
    ("cylinder", "a cylinder that falls off a table and rolls away", "Falling Cylinder", strikes([60]),
     4, ({},)),
)


def said(value):
    return value if isinstance(value, str) else f"{value:g}"


def how(preset, parts):
    """In words that `render --preset … --set …` takes."""
    presets = [part["preset"] for part in parts if "preset" in part] or [preset]
    names = dict.fromkeys(name for part in parts for name in part if name != "preset")
    settings = [f"`{name}` " + ", ".join(dict.fromkeys(said(part.get(name, "–")) for part in parts))
                for name in names]
    return "; ".join([", ".join(presets), *settings])


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    folder = MANUAL / "sounds"
    folder.mkdir(exist_ok=True)
    rows = []
    with tempfile.TemporaryDirectory() as scratch:
        console = Console(pathlib.Path(sys.argv[1]).resolve(), scratch)
        for name, heard, preset, events, seconds, parts in SOUNDS:
            rows.append(f"| [{name}](sounds/{name}.flac) | {heard} | {how(preset, parts)} |\n")
            if len(sys.argv) > 2 and name not in sys.argv[2:]:
                continue
            write_flac(folder / f"{name}.flac",
                       [console.render(events=events, seconds=seconds, rate=RATE,
                                       **{"preset": preset, **part}) for part in parts], RATE)
    (MANUAL / "sounds.md").write_text(HEAD + "".join(rows))


if __name__ == "__main__":
    main()
