#!/usr/bin/env python3
"""Makes docs/realism.md and docs/images/realism/*.png: recorded notes beside Idiophone's.

    python3 docs/make_realism.py build/release/Source/Console/idiophone RECORDINGS

RECORDINGS is a folder of *.flac with recordings.json, the `source` of each file, and measure.py,
which measures both sides. It takes ten seconds. Needs numpy, scipy, matplotlib and soundfile. After
new objects or presets, check the constant MISSING against the new figures.
"""
import importlib.util
import json
import pathlib
import re
import sys
import tempfile
import textwrap

import numpy as np
import soundfile

from plot_benchmarks import DOCS, plt, table  # and its look
from rendering import NOTE_ON, Console

IMAGES = DOCS / "images" / "realism"
VELOCITY = 100
# Instrument in the file name: preset, top of the picture in Hz, window of its spectrograms in s.
INSTRUMENTS = {"marimba": ("Marimba", 4000, 0.024),
               "xylophone": ("Rosewood Xylophone", 12000, 0.012),
               "glockenspiel": ("Glockenspiel", 12000, 0.012)}
SEMITONES = {"C": 0, "D": 2, "E": 4, "F": 5, "G": 7, "A": 9, "B": 11}
CENTROID_FACTOR, T60_FACTOR, PARTIAL_DB = 1.4, 1.6, 6
SHOWN_SECONDS, SHOWN_DB = 0.5, 70

INTRO = """# Recorded notes beside Idiophone's

This page shows how close three factory presets come to recorded notes. It compares each recording with Idiophone's note
of the same key at velocity {velocity}. To make the page:

```bash
python3 docs/make_realism.py build/release/Source/Console/idiophone RECORDINGS
```

RECORDINGS is a folder of FLAC files with `recordings.json`, the source of each, and `measure.py`, which measures both
sides. It is not part of the project. The script renders each note at the sample rate and length of its recording.

{sources}

## How to read the tables

Each cell is *recording / Idiophone*. A bold figure misses its bound.

| column | what is measured | bound |
|---|---|---|
| T60 | decay time of the fundamental, from its first 20 dB of decay | a factor {t60} |
| centroid | spectral centroid of the first 20 ms | a factor {centroid} |
| rms at 50 ms | rms level of 50 to 70 ms over that of the first 20 ms | not checked |
| partials | the recording's three strongest partials above the fundamental: frequency over the fundamental's, then level re the fundamental in the first 0.25 s. Idiophone's level is its highest within 7 % of that frequency | {partial} dB |
| difference | energy of the difference of both spectrograms over the recording's in the first 0.5 s, after their levels are matched. At 0 dB they have nothing in common. −12 dB is close | not checked |

**{held} of {all} checks hold ({percent:.0f} %)**: {by_instrument}.
"""
INSTRUMENT = """
## {title}

Preset *{preset}*: {held} of {all} checks hold.

{table}

![Spectrograms of {instrument} notes: recordings on the left, Idiophone's on the right](images/realism/{instrument}.png)

The colour shows the level re each sound's own maximum, over {range} dB. The windows are {window:.0f} ms long.
"""
MISSING = """
## What is missing

In the presets:

- The marimba's F♯5 and C6 decay faster than the recordings, because the sound font loops there.
- The xylophone's partial at 3 decays two to three times as fast as recorded, because the cords damp it too. C7's
  partial at 8.4 is too weak.
- The xylophone's F♯3 and C4 are below the preset's lowest bar, F4. The preset resizes that bar for them.
- The glockenspiel's recordings start with about 20 ms of broadband noise, a knock. Idiophone's notes have only the
  click of the bar's body, which is shorter.

In the recordings:

- The maker of the sound font transposed and edited some notes.
- The marimba's C3 and C4 are probably one sample. Their partials have the same ratios, and both change abruptly, at
  0.28 s and at 0.14 s. The xylophone's F♯6 and C7 are probably one sample too: both have a faint line at 0.87 of the
  fundamental. A transposed note has the partials and decay of another bar.
- The marimba's F♯5 and C6 have faint partials at 2, 3 and 5 times the fundamental, to 0.1 %. No bar has such modes.
  They look like harmonics of distortion or of a transposed loop, so no preset imitates them.
- The strength and place of the strike, the mallet and the microphone are not known. The centroid depends on all four.

In the measure:

- A check looks only at the recording's partials. It does not notice additional partials of Idiophone's note. The column
  *difference* and the pictures show them.
- Another partial of Idiophone's note, or its skirt, may lie within 7 % of the recorded one. A check of a faint partial
  beside a loud one (the glockenspiel's G6 at 5.35) therefore says little.
- Idiophone's notes include the preset's room. The pictures show it as faint noise between 0.03 and 0.15 s.
"""


def load_measure(folder):
    spec = importlib.util.spec_from_file_location("measure", folder / "measure.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def key_of(name):
    """Instrument, note name and MIDI key of a file name like "marimba-Fs5", or None."""
    found = re.fullmatch(r"(\w+)-([A-G])(s?)(\d)", name)
    if not found or found[1] not in INSTRUMENTS:
        return None
    instrument, letter, sharp, octave = found.groups()
    return (instrument, letter + "♯" * len(sharp) + octave,
            12 * (int(octave) + 1) + SEMITONES[letter] + len(sharp))


def struck(measure, path):
    """Samples from the onset, after the same high pass as describe's, and the sample rate."""
    sound, rate = soundfile.read(path, always_2d=True)
    sound = measure.sosfiltfilt(measure.butter(2, 60, "high", fs=rate, output="sos"),
                                sound.mean(axis=1))
    return sound[max(0, measure.onset(sound) - int(0.0005 * rate)):], rate


def levels(measure, path):
    """Frequencies and levels in dB of the first 0.25 s, as describe takes them."""
    sound, rate = struck(measure, path)
    length, size = int(0.25 * rate), 1 << 18
    start = np.pad(sound[:length], (0, max(0, length - len(sound))))
    power = np.abs(np.fft.rfft(start * np.hanning(2 * length)[length:], size))
    return np.fft.rfftfreq(size, 1 / rate), 20 * np.log10(power + 1e-12)


def spectrogram(measure, path, window):
    """Levels in dB re their maximum, [frequency, time], and the step in Hz; window in seconds."""
    sound, rate = struck(measure, path)
    length, size, hop = round(window * rate), 4096, round(0.002 * rate)
    count = round(SHOWN_SECONDS * rate / hop)
    sound = np.pad(sound, (length // 2, count * hop + length))
    power = np.array([np.abs(np.fft.rfft(sound[k * hop:k * hop + length] * np.hanning(length), size))
                      for k in range(count)]).T
    return 20 * np.log10(power / power.max() + 1e-9), rate / size


def within(value, other, factor):
    return bool(value and other) and 1 / factor <= value / other <= factor


class Note:
    """One recording, the render of its key, and the figures of both."""

    def __init__(self, measure, console, recording, name, key, preset):
        self.name, self.recording = name, recording
        info = soundfile.info(recording)
        self.render = console.folder / f"{recording.stem}.wav"
        sound = console.render(preset, [(0, NOTE_ON, key, VELOCITY)], info.duration,
                               rate=info.samplerate)
        soundfile.write(self.render, sound, info.samplerate, subtype="FLOAT")
        hertz = 440 * 2 ** ((key - 69) / 12)
        self.real, self.ours = (measure.describe(str(path), hertz)
                                for path in (recording, self.render))
        self.difference = measure.difference_db(str(self.render), str(recording))
        self.cells, self.checks = [], []
        self._compare(*levels(measure, self.render))

    def _cell(self, real, ours, holds=None, lead=""):
        if holds is not None:
            self.checks.append(holds)
        self.cells.append(f"{lead}{real} / " + (ours if holds in (None, True) else f"**{ours}**"))

    def _compare(self, frequencies, decibels):
        def both(figure):
            return figure(self.real), figure(self.ours)

        def seconds(value):
            return f"{value:.2f}" if value else "–"
        real, ours = both(lambda sound: sound["t60"])
        self._cell(seconds(real), seconds(ours), within(ours, real, T60_FACTOR))
        real, ours = both(lambda sound: sound["centroid_hz"]["0-20ms"])
        self._cell(f"{real:.0f}", f"{ours:.0f}", within(ours, real, CENTROID_FACTOR))
        real, ours = both(lambda sound: sound["rms_db_re_peak"]["0.05"] - sound["rms_db_re_peak"]["0"])
        self._cell(f"{real:+.1f}", f"{ours:+.1f}")
        fundamental = decibels[np.argmin(np.abs(frequencies - self.ours["f0"]))]
        others = sorted((p for p in self.real["partials"] if p["ratio"] > 1.05),
                        key=lambda partial: -partial["db"])[:3]
        for partial in others:
            near = np.abs(frequencies / partial["hz"] - 1) < 0.07
            ours = decibels[near].max() - fundamental
            self._cell(f"{round(partial['db'])}", f"{round(ours)}",
                       bool(abs(ours - partial["db"]) <= PARTIAL_DB), f"{partial['ratio']:.2f}: ")
        self.cells += ["–"] * (3 - len(others)) + [f"{self.difference:.1f}"]

    def row(self):
        return (self.name, *(cell.replace("-", "−") for cell in self.cells))


def draw(measure, instrument, notes, highest, window):
    figure, panels = plt.subplots(len(notes), 2, figsize=(7, 1.5 * len(notes) + 0.6), sharex=True,
                                  sharey=True, squeeze=False, layout="constrained")
    for note, row in zip(notes, panels):
        for panel, path, side in zip(row, (note.recording, note.render),
                                     ("recording", "Idiophone")):
            shown, step = spectrogram(measure, path, window)
            shown = shown[:int(highest / step) + 1]
            drawn = panel.imshow(shown, origin="lower", aspect="auto", cmap="magma", vmin=-SHOWN_DB,
                                 vmax=0, interpolation="nearest",
                                 extent=(0, SHOWN_SECONDS, 0, len(shown) * step / 1000))
            panel.set_ylim(0, highest / 1000)
            panel.set_title(f"{note.name}, {side}", fontsize=9)
            panel.grid(False)
        row[0].set_ylabel("kHz")
    for panel in panels[-1]:
        panel.set_xlabel("s")
    figure.colorbar(drawn, ax=panels, label="dB", fraction=0.03, pad=0.02)
    figure.savefig(IMAGES / f"{instrument}.png", dpi=100, metadata={"Software": None},
                   pil_kwargs={"optimize": True})
    plt.close(figure)


def listed(words):
    return " and ".join(filter(None, (", ".join(words[:-1]), words[-1])))


def sources(compared, others, records):
    """Who made the recordings, and in one sentence which are left out."""
    made = {}
    for file in compared:
        made.setdefault(records[file.name]["source"], []).append(key_of(file.stem)[0])
    paragraphs = [" ".join(f"The recordings of the {listed(list(dict.fromkeys(instruments)))} are "
                           f"from {source}." for source, instruments in made.items())]
    if others:
        origin = "; ".join(dict.fromkeys(records[file.name]["source"] for file in others))
        names = listed([file.stem.replace("-", " ") for file in others])
        paragraphs.append("The other recordings are not compared, because their meshes and the places "
                          f"of the strikes are not at hand: {names}, from {origin}.")
    return "\n\n".join(textwrap.fill(paragraph, 120, break_on_hyphens=False)
                       for paragraph in paragraphs)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    folder = pathlib.Path(sys.argv[2])
    measure = load_measure(folder)
    records = {record["file"]: record
               for record in json.loads((folder / "recordings.json").read_text())}
    files = [folder / name for name in records if (folder / name).exists()]
    compared = [file for file in files if key_of(file.stem)]
    others = [file for file in files if not key_of(file.stem)]
    IMAGES.mkdir(parents=True, exist_ok=True)
    parts, scores = [], {}
    with tempfile.TemporaryDirectory() as scratch:
        console = Console(str(pathlib.Path(sys.argv[1]).resolve()), scratch)
        for instrument, (preset, highest, window) in INSTRUMENTS.items():
            notes = [Note(measure, console, file, name, key, preset)
                     for key, name, file in sorted((key_of(file.stem)[2], key_of(file.stem)[1], file)
                                                   for file in compared
                                                   if key_of(file.stem)[0] == instrument)]
            if not notes:
                continue
            checks = [check for note in notes for check in note.checks]
            scores[instrument] = sum(checks), len(checks)
            draw(measure, instrument, notes, highest, window)
            parts.append(INSTRUMENT.format(
                title=instrument.capitalize(), preset=preset, held=sum(checks), all=len(checks),
                instrument=instrument, range=SHOWN_DB, window=1000 * window,
                table=table(("note", "T60, s", "centroid, Hz", "rms at 50 ms, dB", "1st partial, dB",
                             "2nd partial, dB", "3rd partial, dB", "difference, dB"),
                            [note.row() for note in notes])))
    held, total = (sum(numbers) for numbers in zip(*scores.values()))
    intro = INTRO.format(
        velocity=VELOCITY, sources=sources(compared, others, records), t60=T60_FACTOR,
        centroid=CENTROID_FACTOR, partial=PARTIAL_DB, held=held, all=total,
        percent=100 * held / total,
        by_instrument=", ".join(f"{instrument} {good} of {count}"
                                for instrument, (good, count) in scores.items()))
    (DOCS / "realism.md").write_text(intro + "".join(parts) + MISSING, encoding="utf-8")
    print(f"{held} of {total} checks hold")


if __name__ == "__main__":
    main()
