#!/usr/bin/env python3
"""Figures and tables of docs/scenes.md, all from what the console performs.

    python3 docs/plot_scenes.py build/release/Source/Console/idiophone [SECTION...]

A SECTION, as the markers of the page name it, makes that one alone; all take some minutes. Needs
numpy and matplotlib. Draws docs/images/scenes/*.svg and replaces the tables between the markers.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import wave

import numpy as np

from plot_benchmarks import DOCS, plt, replace_between_markers, table  # and its look

IMAGES = DOCS / "images" / "scenes"
SCENES = DOCS.parent / "Resources" / "Scenes"
PAGE = DOCS / "scenes.md"
RATE = 48000


class Performance:
    """A scene as the console performs it."""

    def __init__(self, console, scene, *options):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            if isinstance(scene, dict):
                (folder / "scene.json").write_text(json.dumps(scene))
                scene = folder / "scene.json"
            sound, frames, impacts = (folder / n for n in ("s.wav", "frames.json", "impacts.jsonl"))
            subprocess.run([console, "scene", scene, "-o", sound, "--bit-depth", "16",
                            "--stats", frames, "--impulses", impacts, *options],
                           check=True, capture_output=True)
            with wave.open(str(sound)) as file:
                samples = np.frombuffer(file.readframes(file.getnframes()), "<i2")
            self.left = samples[::2] / 32768
            self.figures = json.loads(frames.read_text())
            self.impacts = [json.loads(line) for line in impacts.read_text().splitlines()]

    def impulses_on(self, name):
        """(seconds, Ns)"""
        own = [i for i in self.impacts if i["object"] == name]
        return (np.array([i["time"] for i in own]),
                np.array([np.linalg.norm(i["impulse"]) for i in own]))


def save(figure, name):
    figure.tight_layout()
    figure.savefig(IMAGES / f"{name}.svg", metadata={"Date": None})
    plt.close(figure)


def envelope(axes, sound, points=800):
    """The waveform as its extremes."""
    step = max(len(sound) // points, 1)
    rows = sound[:len(sound) // step * step].reshape(-1, step)
    seconds = (np.arange(len(rows)) + 0.5) * step / RATE
    axes.fill_between(seconds, rows.min(1), rows.max(1), linewidth=0)


def spectrum(sound, seconds=0.25):
    onset = np.flatnonzero(np.abs(sound) > 0.01 * np.abs(sound).max())[0]
    part = sound[onset:onset + int(seconds * RATE)]
    levels = np.abs(np.fft.rfft(part * np.hanning(len(part)), 1 << 16))
    return np.fft.rfftfreq(1 << 16, 1 / RATE), 20 * np.log10(levels + 1e-6)


def landings(console):
    scene = json.loads((SCENES / "03-cylinder-off-a-table.json").read_text())
    scene["bodies"][2].update(velocity=[0, 0, 0], spin=[0, 0, 0])
    figure, axes = plt.subplots()
    for name, along in (("in the middle", 0), ("3 cm from the edge", 0.57)):
        scene["bodies"][2]["at"] = [along, 0, 0.79]
        hz, levels = spectrum(Performance(console, scene, "--seconds", "0.5", "--set",
                                          "tau=0.01").left)
        shown = (hz > 30) & (hz < 2000)
        axes.semilogx(hz[shown], levels[shown], label=name)
    axes.set_xlabel("Hz")
    axes.set_ylabel("dB")
    axes.legend()
    save(figure, "landings")


def rolling(console):
    performance = Performance(console, "Cylinder off a table")
    figure, (strikes, sound) = plt.subplots(2, 1, sharex=True)
    for name, shown in (("long-table", "table"), ("floor", "floor")):
        seconds, impulses = performance.impulses_on(name)
        strikes.vlines(seconds, 1e-4, np.maximum(impulses, 1e-4),
                     "C0" if name == "floor" else "C1", label=f"on the {shown}")
    strikes.set_yscale("log")
    strikes.set_ylabel("Ns")
    strikes.legend(fontsize=7)
    envelope(sound, performance.left)
    sound.set_ylabel("left ear")
    sound.set_xlabel("s")
    save(figure, "rolling")
    seconds, _ = performance.impulses_on("long-table")
    # Impacts within a millisecond of each other are one setting down.
    set_down = seconds[1:][np.diff(seconds) > 0.001]
    steps = 1000 * np.diff(set_down[(set_down >= 0.2) & (set_down < 1)])
    return table(("rolling on the table", "mean, ms", "s.d., ms"),
                 [("here", f"{steps.mean():.1f}", f"{steps.std(ddof=1):.1f}"),
                  ("the paper's", "about 17", "about 10")])


def rings(console):
    settings = (("every mode", ("tau=0.001", "compression=0", "budget=16384")),
                ("compression and truncation", ("tau=2", "compression=1", "budget=16384")),
                ("and quality scaling", ("tau=2", "compression=1", "budget=300")))
    figure, axes = plt.subplots()
    rows = []
    for name, values in settings:
        options = [word for value in values for word in ("--set", value)]
        performance = Performance(console, "A hundred rings", "--seconds", "2", *options)
        modes = performance.figures["modes_mixed"]
        axes.plot(0.01 * (np.arange(len(modes)) + 0.5), modes, label=name)
        rows.append((name, f"{np.mean(modes):.0f}", max(modes)))
    axes.set_xlabel("s")
    axes.set_ylabel("modes mixed")
    axes.legend(fontsize=7)
    save(figure, "rings")
    return table(("setting", "modes mixed, mean", "at most"), rows)


def scenes(console):
    rows = []
    for file in sorted(SCENES.glob("*.json")):
        scene = json.loads(file.read_text())
        song = DOCS.parent / "Resources" / "Songs" / "TheEntertainer.mid"
        options = ["--midi", song, "--seconds", "10"] if "notes" in scene else []
        if scene["name"] == "A hundred rings":
            options = ["--seconds", "3"]
        performance = Performance(console, scene["name"], *options)
        figure, (counts, sound) = plt.subplots(2, 1, sharex=True, figsize=(7, 2.8))
        impacts = np.array(performance.figures["impacts_of_frame"])
        counts.step(0.01 * np.arange(len(impacts)), impacts, where="post", linewidth=0.6)
        counts.set_ylabel("impacts\nin 10 ms")
        envelope(sound, performance.left)
        sound.set_xlabel("s")
        save(figure, file.stem[3:])
        figures = performance.figures
        rows.append((f"[{scene['name']}](images/scenes/{file.stem[3:]}.svg)",
                     f"{figures['seconds']:.1f}", figures["bodies_most"], figures["impacts"],
                     max(figures["modes_mixed"])))
    return table(("scene", "s", "bodies", "impacts", "modes at most"), rows)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    console, wanted = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2:]
    IMAGES.mkdir(parents=True, exist_ok=True)
    for section in landings, rolling, rings, scenes:
        if wanted and section.__name__ not in wanted:
            continue
        if content := section(console):
            PAGE.write_text(replace_between_markers(PAGE.read_text(), section.__name__, content))


if __name__ == "__main__":
    main()
