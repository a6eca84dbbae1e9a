#!/usr/bin/env python3
"""Figures, sounds and tables of docs/contact-sounds.md, all from what the console renders.

    python3 docs/plot_contact_sounds.py build/release/Source/Console/idiophone [SECTION...]

A SECTION, as the markers of the page name it, makes that one alone; all take two minutes. Needs
numpy, matplotlib, soundfile and pyloudnorm. Draws docs/images/contact-sounds/*.svg, writes
docs/sounds/*.flac and gesture.mid, and replaces the tables between the markers of the page.
"""
import json
import sys
import tempfile

import numpy as np
import pyloudnorm

from plot_benchmarks import DOCS, plt, replace_between_markers, table  # and its look
from rendering import (CONTROL, NOTE_OFF, NOTE_ON, PRESSURE, RATE, ROOT, Console,
                       standard_midi_file, write_flac)

IMAGES = DOCS / "images" / "contact-sounds"
SOUNDS = DOCS / "sounds"
SPEED, PLACE = 1, 74
RACK = ("Yarn", "Soft rubber", "Medium rubber", "Hard rubber", "Wood", "Hard plastic", "Brass")
MATERIALS = ("Rosewood", "Padauk", "Wood", "Ceramic", "Glass", "Plastic", "Iron", "Polycarbonate",
             "Steel", "Tin", "Aluminium")
# A contact is seen best on an object that decays soon, heard at the struck place.
PROBE = {"material": "Custom", "gamma": 1000, "tau": 0.001, "compression": 0, "budget": 16384,
         "radiation": 0, "spread": 0, "level": 0}
ROSEWOOD = {"young": 12.5, "density": 850, "eta": 0.235}
STEEL = {"young": 200, "density": 7850, "eta": 0.03}


def save(figure, name, below=0.0):
    figure.tight_layout(rect=(0, below, 1, 1))
    figure.savefig(IMAGES / f"{name}.svg", metadata={"Date": None}, dpi=160)
    plt.close(figure)


def keep(name, parts, rate=RATE):
    write_flac(SOUNDS / f"{name}.flac", parts, rate)


def even(sound):
    return sound / np.abs(sound).max()


def decibels(power):
    return 10 * np.log10(np.maximum(power, 1e-30))


def power_of(sound):
    return np.mean(np.square(sound))


def density(signal, rate=RATE, length=16384):
    """One-sided power spectral density by Welch's method: frequencies and units² / Hz."""
    window = np.hanning(length)
    blocks = [np.abs(np.fft.rfft(window * signal[at:at + length])) ** 2
              for at in range(0, len(signal) - length + 1, length // 2)]
    return (np.fft.rfftfreq(length, 1 / rate),
            2 * np.mean(blocks, axis=0) / rate / np.sum(window * window))


def spectrum(signal, rate=RATE):
    """Energy spectrum of a whole sound."""
    return np.fft.rfftfreq(len(signal), 1 / rate), np.abs(np.fft.rfft(signal)) ** 2


def in_bands(frequencies, power, fraction, lowest=40, highest=20000, total=False):
    """Means, or sums, of power in bands of 1/fraction octave, where there is a line in them."""
    centres = 1000 * 2 ** (np.arange(-6 * fraction, 5 * fraction) / fraction)
    centres = centres[(centres >= lowest) & (centres <= highest)]
    edges = np.searchsorted(frequencies, np.outer([2 ** (-0.5 / fraction), 2 ** (0.5 / fraction)],
                                                  centres))
    found = [(centre, (np.sum if total else np.mean)(power[low:high]))
             for centre, low, high in zip(centres, *edges) if high > low]
    return np.array(found).T


def centroid(sound):
    frequencies, power = spectrum(sound.mean(axis=1))
    return np.sum(frequencies[1:] * power[1:]) / np.sum(power[1:])


def struck_force(sound, answer, rate):
    """The force in newtons whose pulses made the sound. A pulse is smooth, the answer begins with
    a step, of which a sampled spectrum counts half."""
    answer = answer.copy()
    answer[0] /= 2
    length = 2 * len(sound)
    through = np.fft.rfft(answer, length) / rate
    frequencies = np.fft.rfftfreq(length, 1 / rate)
    heard = np.fft.rfft(sound, length) / (1 + (frequencies / 60000) ** 16)
    floor = 1e-12 * np.abs(through).max() ** 2
    return np.fft.irfft(heard * through.conj() / (np.abs(through) ** 2 + floor))[:len(sound)]


def held_force(sound, answer, length=16384):
    """Spectral density of a held contact's force, which is one impulse a sample."""
    padded = 2 * len(sound)
    through = np.fft.rfft(answer, padded) / RATE
    floor = 1e-14 * np.abs(through).max() ** 2
    force = np.fft.irfft(np.fft.rfft(sound, padded) * through.conj() /
                         (np.abs(through) ** 2 + floor))
    return density(force[RATE:len(sound) - RATE], length=length)


BAR = ROOT / "Resources" / "Objects" / "xylophone-72.modal"
PLATE = ROOT / "Resources" / "Objects" / "plate.modal"
STRUCK_RATE = 384000


def strikes(console, velocity, count=1, seconds=0.25, surface=ROSEWOOD, **parameters):
    """The forces of one strike after another on the C5 bar, [count, samples]."""
    vertex, place = console.vertex(BAR, (0.02, 0.005, 0))
    preset = console.preset("01-rosewood-xylophone.json", BAR, [console.relative(BAR, place)],
                            (60,), strike_along=0)
    settings = {**PROBE, **surface, **parameters}
    sound = console.render(preset, [(k * seconds, NOTE_ON, 60, velocity) for k in range(count)],
                           count * seconds, STRUCK_RATE, **settings)[:, 0]
    answer = console.answer(BAR, vertex, seconds, STRUCK_RATE, **PROBE, **surface)
    return np.array([struck_force(strike, answer, STRUCK_RATE)
                     for strike in sound.reshape(count, -1)])


def contact_milliseconds(force):
    """A raised cosine is twice as long as it is above half of its height."""
    top = np.argmax(force)
    half = force[top] / 2
    before = np.flatnonzero(force[:top] < half)[-1] if (force[:top] < half).any() else 0
    after = top + np.flatnonzero(force[top:] < half)[0]

    def crossing(k):
        return k + (half - force[k]) / (force[k + 1] - force[k])
    return 2000 * (crossing(after - 1) - crossing(before)) / STRUCK_RATE


def mallet_force(console):
    figure, panels = plt.subplots(1, 2)
    rows = []
    milliseconds = 1000 * np.arange(round(0.25 * STRUCK_RATE)) / STRUCK_RATE
    for number, mallet in enumerate(RACK):
        surface = STEEL if mallet == "Brass" else ROSEWOOD
        row = [mallet, "steel" if mallet == "Brass" else "rosewood"]
        times = []
        for speed in 0.3, 1, 3:
            force = strikes(console, 127, surface=surface, mallet=mallet, mallet_speed=speed)[0]
            times.append(f"{contact_milliseconds(force):.2f}")
            if speed == 1:
                newtons = force.max()
                for panel, shown in zip(panels, (RACK[:4], RACK[4:])):
                    if mallet in shown:
                        panel.plot(milliseconds, force, "--" if mallet in ("Soft rubber",
                                   "Hard plastic") else "-", color=f"C{number}",
                                   label=f"{mallet} on steel" if mallet == "Brass" else mallet)
        rows.append((*row, " / ".join(times), f"{newtons:.0f}"))
    for panel, end in zip(panels, (6, 0.5)):
        panel.set_xlim(0, end)
        panel.set_ylim(0)
        panel.set_xlabel("ms")
        panel.set_ylabel("N")
        panel.legend()
    save(figure, "mallet-force")
    return table(("mallet", "on", "contact ms at 0.3 / 1 / 3 m/s", "peak N at 1 m/s"), rows)


def mallet_centroid(console):
    velocities = (16, 32, 48, 64, 80, 96, 112, 127)
    scenes = (("C4 bar (C5 at twice its size)", "Rosewood Xylophone", 72, {"size": 2}),
              ("C6 bar", "Rosewood Xylophone", 84, {}), ("steel plate", "Steel Plate", 66, {}))
    figure, panels = plt.subplots(1, 3, figsize=(7, 3.9))
    rows = []
    for panel, (name, preset, note, changes) in zip(panels, scenes):
        steady = []
        for mallet in RACK:
            heights = [centroid(console.render(preset, [(0, NOTE_ON, note, velocity)], 32768 / RATE,
                                               mallet=mallet, spread=0, **changes))
                       for velocity in velocities]
            panel.semilogy(velocities, heights, "--" if mallet in ("Soft rubber", "Hard plastic")
                           else "-", label=mallet)
            steps = np.diff(heights)
            span = f"{min(heights):.0f} to {max(heights):.0f}"
            steady.append((mallet, span if (steps > 0).all() else f"{span}, **not steadily**"))
        rows.append(steady)
        panel.set_title(name, fontsize=9)
        panel.set_xlabel("velocity")
        panel.set_xticks((16, 64, 127))
        panel.set_ylim(100, 5000)
        panel.set_yticks((100, 200, 500, 1000, 2000, 5000), ("100", "200", "500", "1k", "2k", "5k"))
        panel.minorticks_off()
    panels[0].set_ylabel("spectral centroid, Hz")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="lower center", ncols=4,
                  fontsize=8)
    save(figure, "mallet-centroid", below=0.13)
    return table(("mallet", *(f"{scene[0]}, Hz" for scene in scenes)),
                 [(first[0], first[1], second[1], third[1]) for first, second, third in zip(*rows)])


def mallet_sounds(console):
    for name, preset, note, changes in (("mallets-bar", "Rosewood Xylophone", 72, {"size": 2}),
                                        ("mallets-plate", "Steel Plate", 66, {})):
        keep(name, [even(console.render(preset, [(0, NOTE_ON, note, 100)], 0.5, mallet=mallet,
                                        spread=0, **changes)) for mallet in RACK])


def collisions(force):
    """Onsets in ms after the first, and the share of the impulse that comes late."""
    strong = (force[1:-1] > force[:-2]) & (force[1:-1] >= force[2:])
    peaks = np.flatnonzero(strong & (force[1:-1] > 0.02 * force.max())) + 1
    apart = [peaks[0]]
    for peak in peaks[1:]:
        between = force[apart[-1]:peak].min()
        if between < 0.5 * min(force[peak], force[apart[-1]]):
            apart.append(peak)
    end = apart[0] + 2 * apart[0]
    pressed = np.maximum(force[:round(0.02 * STRUCK_RATE)], 0)
    return (np.array(apart) - apart[0]) / STRUCK_RATE * 1000, pressed[end:].sum() / pressed.sum()


def chatter(console):
    figure, panels = plt.subplots(3, 1, sharex=True, figsize=(7, 4.6))
    milliseconds = 1000 * np.arange(round(0.1 * STRUCK_RATE)) / STRUCK_RATE
    rows = []
    for panel, mallet in zip(panels, ("Hard plastic", "Brass")):
        single = strikes(console, 112, seconds=0.1, mallet=mallet)[0]
        trains = strikes(console, 112, 64, 0.1, mallet=mallet, chatter=100)
        panel.plot(milliseconds, single, color="0.6", label="chatter 0 %")
        for number, train in enumerate(trains[:3]):
            panel.plot(milliseconds, train, label=f"100 %, strike {number + 1}", linewidth=1)
        panel.legend(title=mallet, title_fontsize=9, fontsize=8)
        found = [collisions(train) for train in trains]
        counts, lasts = [len(onsets) for onsets, _ in found], [onsets[-1] for onsets, _ in found]
        seconds = [onsets[1] for onsets, _ in found]
        rows.append((mallet, f"{min(counts)} to {max(counts)}",
                     f"{min(seconds):.1f} to {max(seconds):.1f}, median {np.median(seconds):.1f}",
                     f"{max(lasts):.1f}",
                     f"{100 * np.mean([late for _, late in found]):.0f} %",
                     f"{trains.max() / single.max():.2f}"))
    pulses = strikes(console, 112, seconds=0.1, mallet="Brass", modal_pulse="On")[0]
    panels[2].plot(milliseconds, pulses, color="C4", label="modal pulse")
    panels[2].legend()
    panels[2].set_xlim(0, 16)
    panels[2].set_xlabel("ms")
    for panel in panels:
        panel.set_ylabel("N")
        panel.set_ylim(0)
    save(figure, "chatter-force")
    keep("chatter", [console.render("Steel Plate", [(0, NOTE_ON, 66, 112)], 0.75, mallet="Brass",
                                    spread=0, chatter=share) for share in (0, 100)] * 2)
    return table(("mallet", "collisions in each of 64 strikes", "second collision after, ms",
                  "last collision after at most, ms", "impulse after the first collision",
                  "highest force / that without chatter"), rows)


def mode_frequencies(console, thing, highest=np.inf):
    listed = json.loads(console.run("info", thing, "--json"))["modes"]
    return np.array([mode["frequency_hz"] for mode in listed if mode["frequency_hz"] < highest])


def at_modes(signal, modes, within=2):
    """Energy density of the highest line near each mode, four lines to a Hz or more."""
    frequencies, power = spectrum(np.pad(signal, (0, max(0, 4 * RATE - len(signal)))))
    low, high = np.searchsorted(frequencies, modes - within), np.searchsorted(frequencies,
                                                                              modes + within)
    return np.array([power[first:last].max() for first, last in zip(low, high)])


def modal_pulse(console):
    kinds = (("brass", {"mallet": "Brass"}),
             ("brass, chatter", {"mallet": "Brass", "chatter": 100}),
             ("medium rubber", {"mallet": "Medium rubber"}),
             ("brass, modal pulse", {"mallet": "Brass", "modal_pulse": "On"}))
    modes = mode_frequencies(console, PLATE, 20000)
    figure, axes = plt.subplots()
    rows, sounds = [], []
    for name, changes in kinds:
        sounds.append(sound := console.render("Steel Plate", [(0, NOTE_ON, 66, 112)], 1.5, spread=0,
                                              **changes))
        levels = at_modes(sound.mean(axis=1), modes)
        if len(sounds) == 1:
            reference = levels.max()
        if "chatter" not in changes:
            axes.semilogx(modes, decibels(levels / reference), ".", markersize=5, label=name)
        rows.append((name, f"{centroid(sound):.0f}",
                     f"{decibels(power_of(sound) / power_of(sounds[0])):.1f}"))
    frequency_axis(axes, 100, 20000)
    axes.set_xlabel("Hz (a dot for each mode of the plate)")
    axes.set_ylabel("dB re the loudest under brass")
    axes.set_ylim(-100, 5)
    axes.legend()
    save(figure, "modal-pulse")
    keep("modal-pulse", [even(sounds[0]), even(sounds[3])])
    return table(("steel plate, velocity 112", "centroid, Hz", "level, dB"), rows)


def shown(bands, reference):
    return bands[0], decibels(bands[1] / reference)


def thirds(sound):
    """Level in thirds of octaves of a steady sound, dB re full scale."""
    frequencies, power = density(sound.mean(axis=1), length=65536)
    return shown(in_bands(frequencies, power * frequencies[1], 3, 60, total=True), 1)


def frequency_axis(axes, lowest, highest):
    ticks = [(20, "20"), (50, "50"), (100, "100"), (200, "200"), (500, "500"), (1000, "1k"),
             (2000, "2k"), (5000, "5k"), (10000, "10k"), (20000, "20k")]
    ticks = [tick for tick in ticks if lowest <= tick[0] <= highest]
    axes.set_xticks(*zip(*ticks))
    axes.minorticks_off()
    axes.set_xlim(lowest, highest)
    axes.set_xlabel("Hz")


def position(console):
    mesh, wooden = console.folder / "table.obj", console.folder / "table.modal"
    console.run("mesh", "plate", "--length", 1.2, "--width", 0.8, "--vertices", 600, "-o", mesh)
    console.run("analyse", mesh, "--material", "Wood", "--thickness", 0.03, "--max-frequency", 2500,
                "-o", wooden)
    modes = mode_frequencies(console, wooden, 1000)
    figure, panels = plt.subplots(3, 1, sharex=True, sharey=True, figsize=(7, 4.6))
    rows, sounds = [], []
    for panel, (name, place) in zip(panels, (("middle", (0, 0, 0)), ("edge", (0, 0.4, 0)),
                                             ("corner", (0.6, 0.4, 0)))):
        def struck(seconds, place=place, **parameters):
            return console.strike(wooden, place, 100, seconds, mallet="Wood", radiation=100,
                                  spread=0, tau=0.001, compression=0, **parameters)
        sounds.append(struck(1.0)[0])
        # With so little damping the modes stand apart.
        sound, report = struck(8.0, material="Custom", young=11, density=750, gamma=2, eta=0.001)
        levels = at_modes(sound[:, 0], modes, 1)
        levels = decibels(levels / levels.max())
        panel.vlines(modes, -70, levels, color="C0", linewidth=1.5)
        panel.plot(modes, levels, "o", color="C0", markersize=3)
        x, y, _ = report["point_m"]
        panel.set_title(f"{name} ({100 * x:.0f}, {100 * y:.0f} cm)", loc="left", fontsize=9)
        panel.set_ylabel("dB")
        rows.append((name, int(np.sum(levels > -40)), int(np.sum(levels > -20)),
                     f"{modes[np.argmax(levels)]:.0f}"))
    panels[2].set_xlim(0, 1020)
    panels[2].set_ylim(-60, 5)
    panels[2].set_yticks((-60, -40, -20, 0))
    panels[2].set_xlabel("Hz (a line for each mode of the table)")
    save(figure, "position")
    keep("position", [even(sound) for sound in sounds])
    return table(("struck at",
                  f"of the {len(modes)} modes below 1 kHz, within 40 dB of the loudest",
                  "within 20 dB", "loudest mode, Hz"), rows)


SCRAPED = "07-scraped-plate.json"
HELD_RATE = 32000  # a scrape has nothing above 16 kHz and would be long in FLAC


def held(console, seconds, speed, pressure=127, preset="Scraped Plate", **parameters):
    """A key of the scraped plate held at one speed and pressure, left and right."""
    events = [(0, CONTROL, SPEED, speed), (0, NOTE_ON, 60, 127), (0.001, PRESSURE, pressure)]
    return console.render(preset, events, seconds, **parameters)


def held_forces(console, *runs, probe={**PROBE, **STEEL}, length=16384):
    """Spectral densities in N²/Hz of what presses on the plate's edge, one for each run."""
    vertex, place = console.vertex(PLATE, (-0.07, 0.09, 0))
    path = [console.relative(PLATE, place), [0, 0.9, 0]]
    preset = console.preset(SCRAPED, PLATE, path, (60, 61))
    answer = console.answer(PLATE, vertex, 10, RATE, **probe)
    return [held_force(held(console, 32, preset=preset, **{**probe, **run})[:, 0], answer, length)
            for run in runs]


def newtons(force, lowest=30, highest=20000):
    frequencies, power = force
    return np.sqrt(np.sum(power[(frequencies > lowest) & (frequencies < highest)]) * frequencies[1])


def surface_density(frequencies, speed_ratio):
    """The preset's surface as docs/surfaces.md has it: ω^β through the reson, to a factor."""
    surface = json.loads((ROOT / "Presets" / SCRAPED).read_text())["surface"]
    damping = surface["reson_damping_per_s"] * speed_ratio
    rotation = 2 * np.pi * surface["reson_frequency_hz"] * speed_ratio
    omega = 2 * np.pi * frequencies
    reson = 1 / ((1j * omega + damping) ** 2 + rotation ** 2)
    return omega ** surface["spectrum_exponent"] * np.abs(reson) ** 2


def force_and_sound_axes(panels):
    units = ("force, dB re 1 N²/Hz", -100), ("sound, dBFS per 1/3 octave", -120)
    for panel, (unit, lowest) in zip(panels, units):
        frequency_axis(panel, 50, 20000)
        panel.set_xticks((100, 1000, 10000), ("100", "1k", "10k"))
        panel.set_ylabel(unit)
        panel.set_ylim(lowest)
        panel.legend()


def scrape(console):
    speeds = ((64, "0.50 m/s"), (127, "1.00 m/s"))
    forces = held_forces(console, *({"speed": wheel} for wheel, _ in speeds))
    figure, panels = plt.subplots(1, 2)
    rows = []
    for number, ((wheel, name), force) in enumerate(zip(speeds, forces)):
        frequencies, power = force
        band = (frequencies > 40) & (frequencies < 16000)
        model = surface_density(frequencies[band], wheel / 127)
        model *= np.sum(power[band]) / np.sum(model)
        panels[0].semilogx(*shown(in_bands(*force, 6), 1), color=f"C{number}", label=name)
        panels[0].semilogx(frequencies[band], decibels(model), ":", color="0.3", linewidth=1.2,
                           label="the surface's figures" if number else None)
        sound = held(console, 21, wheel)[RATE:]
        panels[1].semilogx(*thirds(sound),
                           color=f"C{number}", label=name)
        rows.append((name, f"{newtons(force):.2f}", f"{half_power(force):.0f}",
                     f"{decibels(power_of(sound)):.1f}", f"{centroid(sound):.0f}"))
    shift = speed_shift(*forces)
    force_and_sound_axes(panels)
    save(figure, "scrape-spectrum")
    keep("scrape", [held(console, 1.6, wheel, rate=HELD_RATE) for wheel, _ in speeds], HELD_RATE)
    return (table(("speed", "force, N rms", "median frequency of the force, Hz",
                   "sound, dBFS rms", "centroid of the sound, Hz"), rows) +
            f"\n\nShifted by the ratio of the speeds, the two force spectra differ by at most "
            f"{shift:.1f} dB.\nThe comparison is in thirds of octaves from 100 Hz to 3 kHz of the "
            f"slower one.")


def half_power(force):
    frequencies, power = force
    band = (frequencies > 30) & (frequencies < 20000)
    return frequencies[band][np.searchsorted(np.cumsum(power[band]), np.sum(power[band]) / 2)]


def speed_shift(slow, fast):
    """Greatest difference in thirds of octaves; of one sound read faster, density ∝ v · 1/v."""
    ratio = 127 / 64
    frequencies = slow[0]
    moved = np.interp(frequencies * ratio, *fast)
    low = in_bands(frequencies, slow[1], 3, 100, 3000)[1]
    high = in_bands(frequencies, moved, 3, 100, 3000)[1]
    return np.max(np.abs(decibels(high / low)))


def scrape_level(console):
    values = np.array((1, 2, 4, 8, 16, 32, 64, 96, 127))
    figure, panels = plt.subplots(1, 2, sharey=True)
    full = held(console, 11, 127)[RATE:]
    rows = []
    for panel, name, arguments, scale in (
            (panels[0], "pressure", lambda value: {"speed": 127, "pressure": value}, 5 / 127),
            (panels[1], "speed", lambda value: {"speed": value}, 1 / 127)):
        used = values[values >= 8] if name == "speed" else values
        runs = [arguments(int(value)) for value in used]
        forces = np.array([newtons(force, 1) for force in held_forces(console, *runs)])
        heard = np.array([decibels(power_of(held(console, 11, **run)[RATE:]) / power_of(full))
                          for run in runs])
        pressed = 2 * decibels(forces / forces[-1])
        panel.semilogx(used * scale, 10 * np.log10(used / 127), color="0.6",
                       label="√force" if name == "pressure" else "√speed")
        panel.semilogx(used * scale, pressed, "o", markersize=7, fillstyle="none",
                       label="scraping force")
        panel.semilogx(used * scale, heard, ".", label="sound")
        panel.set_xlabel("normal force, N" if name == "pressure" else "speed, m/s")
        panel.legend()
        rows.append(("normal force" if name == "pressure" else name,
                     f"{np.max(np.abs(pressed - 10 * np.log10(used / 127))):.2f}",
                     f"{np.max(np.abs(heard - 10 * np.log10(used / 127))):.2f}"))
    panels[0].set_ylabel("dB re full pressure and speed")
    for panel, ticks in zip(panels, ((0.05, 0.1, 0.2, 0.5, 1, 2, 5), (0.1, 0.2, 0.5, 1))):
        panel.set_xticks(ticks, [f"{tick:g}" for tick in ticks])
        panel.minorticks_off()
    save(figure, "scrape-level")
    return table(("over", "largest deviation of the force from √, dB", "of the sound, dB"), rows)


def roll(console):
    kinds = (("scrape", {}), ("roll", {"contact": "Roll"}),
             ("roll, coupled", {"contact": "Roll", "roll_coupling": 100}))
    figure, panels = plt.subplots(1, 2)
    rows, at_modes = [], []
    for name, changes in kinds:
        # Coupled to the modes that the plate has of itself, not to a probe's.
        force = held_forces(console, {"speed": 127, **changes}, length=65536,
                            probe={**PROBE, "material": "Own", "gamma": 1})[0]
        sound = held(console, 32, 127, **changes)[RATE:]
        frequencies, power = density(sound[:, 0], length=131072)
        at_modes.append([decibels(power[np.abs(frequencies - mode) < 2].sum())
                         for mode in mode_frequencies(console, PLATE)[:8]])
        panels[0].semilogx(*shown(in_bands(*force, 24), 1), label=name, linewidth=1)
        panels[1].semilogx(*thirds(sound), label=name)
        rows.append((name, f"{newtons(force):.2f}", f"{half_power(force):.0f}",
                     f"{decibels(power_of(sound)):.1f}", f"{centroid(sound):.0f}"))
    force_and_sound_axes(panels)
    save(figure, "roll-spectrum")
    keep("roll", [even(held(console, 0.9, 127, rate=HELD_RATE, **changes))
                  for _, changes in kinds], HELD_RATE)
    scraped, rolled, coupled = np.array(at_modes)
    below = [f"{min(scraped - level):.1f} to {max(scraped - level):.1f} dB"
             for level in (rolled, coupled)]
    return (table(("contact", "force, N rms", "median frequency of the force, Hz",
                   "sound, dBFS rms", "centroid of the sound, Hz"), rows) +
            f"\n\nIn bands of 4 Hz at the eight lowest modes the roll is {below[0]} below the "
            f"scrape, and the coupled roll {below[1]}.")


def bow_strokes():
    """Three strokes to and fro, each pressed harder, led along the edge; then let go."""
    events, end = [(0, NOTE_ON, 60, 64)], 3.2
    for seconds in np.arange(0, end, 0.01):
        stroke = abs(np.sin(np.pi * seconds / (end / 3)))
        events += [(seconds, PRESSURE, round(127 * (0.25 + 0.75 * seconds / end) * stroke ** 0.5)),
                   (seconds, CONTROL, SPEED, round(127 * stroke)),
                   (seconds, CONTROL, PLACE, round(64 - 63 * np.cos(np.pi * seconds / end)))]
    return [*events, (end, NOTE_OFF, 60, 0)]


def gesture(console):
    events, score = bow_strokes(), SOUNDS / "gesture.mid"
    score.write_bytes(standard_midi_file(events))
    sound = console.render("Scraped Plate", score, 5)
    figure, (above, below) = plt.subplots(2, 1, sharex=True, figsize=(7, 5),
                                          height_ratios=(3, 1.4))
    length, hop = 4096, 480
    mid = np.pad(sound.mean(axis=1), length // 2)
    window = np.hanning(length)
    blocks = np.array([np.abs(np.fft.rfft(window * mid[at:at + length])) ** 2
                       for at in range(0, len(mid) - length, hop)])
    frequencies = np.fft.rfftfreq(length, 1 / RATE)
    levels = decibels(blocks.T / blocks.max())
    seconds = hop * np.arange(len(blocks)) / RATE
    drawn = above.pcolormesh(seconds, frequencies[8:], levels[8:], vmin=-80, vmax=0,
                             cmap="magma", shading="nearest", rasterized=True)
    above.set_yscale("log")
    above.set_ylim(100, 12000)
    above.set_yticks((100, 200, 500, 1000, 2000, 5000, 10000),
                     ("100", "200", "500", "1k", "2k", "5k", "10k"))
    above.minorticks_off()
    above.set_ylabel("Hz")
    above.grid(False)
    figure.colorbar(drawn, ax=(above, below), label="dB", fraction=0.04, pad=0.02)
    for name, status, number in (("pressure (127: 5 N)", PRESSURE, None),
                                 ("CC1 speed (127: 1 m/s)", CONTROL, SPEED),
                                 ("CC74 place on the edge", CONTROL, PLACE)):
        lane = [(event[0], event[-1]) for event in events
                if event[1] == status and (number is None or event[2] == number)]
        below.plot(*zip(*lane), label=name)
    below.set_ylim(0, 130)
    below.set_yticks((0, 64, 127))
    below.set_xlim(0, 4)
    below.set_xlabel("s (the key is let go at 3.2)")
    below.set_ylabel("MIDI value")
    below.legend(fontsize=8, loc="upper center", bbox_to_anchor=(0.5, -0.45), ncols=3)
    figure.savefig(IMAGES / "gesture.svg", metadata={"Date": None}, dpi=120, bbox_inches="tight")
    plt.close(figure)
    keep("gesture", [console.render("Scraped Plate", score, 4, HELD_RATE)], HELD_RATE)


def side_over_mid(sound):
    return decibels(power_of(sound[:, 0] - sound[:, 1]) / power_of(sound.sum(axis=1)))


def radiation(console):
    modes = mode_frequencies(console, BAR, 12000)
    figure, axes = plt.subplots()
    rows = []
    for share, name in ((0, "near (0 %)"), (40, "40 %"), (100, "far (100 %)")):
        sound = console.render("Rosewood Xylophone", [(0, NOTE_ON, 72, 100)], 1, radiation=share,
                               spread=0)
        levels = decibels(at_modes(sound[:, 0], modes, 6))
        frequencies, power = spectrum(np.pad(sound[:, 0], (0, 3 * RATE)))
        drawn = np.geomspace(300, 12000, 1500)
        axes.semilogx(drawn, decibels(np.interp(drawn, frequencies, power)) - levels[0], label=name)
        rows.append((f"{share} %", f"{levels[0] - max(levels[1:]):+.1f}",
                     f"{modes[1 + np.argmax(levels[1:])]:.0f}", f"{centroid(sound):.0f}",
                     f"{decibels(power_of(sound)):.1f}"))
    frequency_axis(axes, 300, 12000)
    axes.set_ylabel("left channel, dB re the fundamental")
    axes.set_ylim(-70, 20)
    axes.legend()
    save(figure, "radiation-spectrum")
    chord = (72, 76, 79, 84)
    keep("radiation", [even(console.render(
        "Rosewood Xylophone", [(0.3 * k, NOTE_ON, note, 100) for k, note in enumerate(chord)], 1.7,
        radiation=share)) for share in (0, 100)])
    return table(("radiation", "fundamental over the strongest other mode, dB", "that mode, Hz",
                  "centroid, Hz", "level, dBFS rms"), rows)


def width(console):
    figure, axes = plt.subplots()
    notes = range(72, 109)
    rows = []
    for share, wide in ((40, 100), (40, 200), (100, 100)):
        apart = [side_over_mid(console.render("Rosewood Xylophone", [(0, NOTE_ON, note, 100)], 0.6,
                                              radiation=share, width=wide, spread=0))
                 for note in notes]
        axes.plot(notes, apart, ".-", label=f"radiation {share} %, width {wide} %")
        rows.append((f"{share} %", f"{wide} %", f"{max(apart):.1f}", f"{np.median(apart):.1f}",
                     f"{min(apart):.1f}"))
    axes.set_xticks((72, 84, 96, 108), ("C5", "C6", "C7", "C8"))
    axes.set_xlabel("key of the Rosewood Xylophone")
    axes.set_ylabel("side re mid, dB")
    axes.legend()
    save(figure, "radiation-width")
    return table(("radiation", "width", "side re mid: widest key, dB", "median", "narrowest"), rows)


def lufs(sound):
    """After a gain that keeps what is quiet above the standard's absolute gate of -70."""
    return pyloudnorm.Meter(RATE).integrated_loudness(30 * sound)


def phrase(lowest, highest):
    """The eight notes by which loudness is matched: Tests/Instrument/LoudnessMatchTest.cpp."""
    notes = [lowest + (highest - lowest) * k // 7 for k in range(8)]
    return ([(k / 2, NOTE_ON, note, 100) for k, note in enumerate(notes)] +
            [(k / 2 + 0.498, NOTE_OFF, note, 0) for k, note in enumerate(notes)])


def loudness(console):
    scenes = (("Rosewood Xylophone", phrase(72, 108)), ("Steel Plate", phrase(36, 96)))
    changes = [{"material": name} for name in MATERIALS] + [{"mallet": name} for name in RACK]
    names = [*MATERIALS, *RACK]
    names[names.index("Wood", len(MATERIALS))] = "Wood mallet"
    figure, panels = plt.subplots(2, 1, sharex=True, figsize=(7, 5.2))
    places = np.arange(len(names)) + 0.8 * (np.arange(len(names)) >= len(MATERIALS))
    columns = []
    for panel, (preset, events) in zip(panels, scenes):
        def measured(**parameters):
            return lufs(console.render(preset, events, 4.5, spread=0, **parameters)) - own
        own = 0.0
        own = measured()
        off = [measured(**change) for change in changes]
        on = [measured(**change, match_loudness="On") for change in changes]
        both = [(measured(material=material, mallet=mallet, match_loudness="On"), material, mallet)
                for material in MATERIALS for mallet in RACK]
        panel.axhspan(-2, 2, color="C2", alpha=0.2, linewidth=0, label="± 2 LU")
        panel.bar(places, off, 0.6, alpha=0.6, label="off")
        panel.plot(places, on, "o", color="C1", markersize=5, label="on")
        panel.set_ylabel("LU re the preset's own")
        panel.set_title(preset, loc="left", fontsize=9)
        columns.append((off, on, both))
    panels[0].legend(loc="lower left")
    panels[1].set_xticks(places, names, rotation=60, ha="right")
    save(figure, "loudness")
    struck = [(0, NOTE_ON, 48, 100), (0.25, NOTE_ON, 72, 100)]
    keep("loudness", [console.render("Steel Plate", struck, 0.5, material=material,
                                     match_loudness=match)
                      for match in ("Off", "On")
                      for material in ("Steel", "Rosewood", "Aluminium", "Plastic")])
    rows = [(name, *(f"{round(column[kind][k], 1) + 0.0:+.1f}" for column in columns
                     for kind in (0, 1))) for k, name in enumerate(names)]
    remarks = []
    for (preset, _), (_, on, both) in zip(scenes, columns):
        beyond = sorted((pair for pair in both if abs(pair[0]) > 2), key=lambda pair: -abs(pair[0]))
        remarks.append(
            f"**{preset}**: another material or mallet alone is off by at most "
            f"{max(map(abs, on)):.1f} LU. Of the {len(both)} pairs of material and mallet, "
            f"{len(beyond)} are off by more than 2 LU" +
            (": " + ", ".join(f"{material} under {mallet.lower()} {off:+.1f}"
                              for off, material, mallet in beyond) if beyond else "") + ".")
    return table(("", *(f"{preset}, {kind}" for preset, _ in scenes for kind in ("off", "on"))),
                 rows) + "\n\n" + "\n\n".join(remarks)


def loudness_octaves(console):
    """What one gain for all keys leaves where only some of them are played."""
    rows = []
    for preset, spans in (("Rosewood Xylophone", ((72, 84), (84, 96), (96, 108))),
                          ("Steel Plate", ((36, 48), (60, 72), (84, 96)))):
        for lowest, highest in spans:
            def measured(**parameters):
                return lufs(console.render(preset, phrase(lowest, highest), 4.5, spread=0,
                                           **parameters))
            own = measured()
            cells = []
            for choice, names in (("material", MATERIALS), ("mallet", RACK)):
                off = [measured(**{choice: name}, match_loudness="On") - own for name in names]
                beyond = [f"{name.lower()} {error:+.1f}" for name, error in zip(names, off)
                          if abs(error) > 2]
                cells.append(", ".join(beyond) or "–")
            rows.append((preset, f"{lowest} to {highest}", *cells))
    return table(("preset", "keys", "materials off by more than 2 LU", "mallets"), rows)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    for folder in IMAGES, SOUNDS:
        folder.mkdir(parents=True, exist_ok=True)
    page = DOCS / "contact-sounds.md"
    text = page.read_text()
    with tempfile.TemporaryDirectory() as folder:
        console = Console(sys.argv[1], folder, room=0)
        for show in (mallet_force, mallet_centroid, mallet_sounds, chatter, modal_pulse, position,
                     scrape, scrape_level, roll, gesture, radiation, width, loudness,
                     loudness_octaves):
            if len(sys.argv) > 2 and show.__name__ not in sys.argv[2:]:
                continue
            if figures := show(console):
                text = replace_between_markers(text, show.__name__, figures)
    page.write_text(text)


if __name__ == "__main__":
    main()
