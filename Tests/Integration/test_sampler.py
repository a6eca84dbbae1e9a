"""Plays the samples of the marimba in a real sampler, and compares each note with the console's.

Polyphone imports the SFZ and writes a SoundFont, which FluidSynth plays. Both may scale the whole
instrument, so levels are compared relative to each other. Polyphone ignores `amp_veltrack`, so that
the SoundFont has the velocity curve of its standard (8.4.1), which is taken out here.
"""
import math
import os
import subprocess

import mido
import numpy
import pytest
import soundfile

RATE = 48000
SECONDS = 2.0
# Without spread, which makes each strike of the console a little different.
SETTINGS = ["--set", "room=0", "--set", "spread=0"]
# Soft notes come first, so that no loud one rings into them.
NOTES = [(key, velocity) for velocity in (51, 127) for key in (48, 60, 69, 78, 84)]


def song_of(notes, file):
    song = mido.MidiFile(ticks_per_beat=480)
    track = mido.MidiTrack()
    song.tracks.append(track)
    ticks = round(960 * SECONDS)  # at 120 beats a minute
    for key, velocity in notes:
        track.append(mido.Message("note_on", note=key, velocity=velocity))
        track.append(mido.Message("note_off", note=key, time=ticks))
    song.save(file)
    return file


def pieces(samples):
    length = round(RATE * SECONDS)
    return [samples[i * length:(i + 1) * length].mean(axis=1) for i in range(len(NOTES))]


def level(sound):
    return 10 * math.log10(numpy.mean(sound[:RATE // 2] ** 2))


def pitch(sound, near):
    """Returns the frequency of the strongest partial within a semitone, by its phase's advance."""
    window = numpy.hanning(RATE // 4)
    times = numpy.arange(len(window)) / RATE
    start, later = (sound[offset:offset + len(window)] * window for offset in (1000, 1400))
    grid = near * 2 ** (numpy.arange(-100, 101, 2) / 1200)
    spectrum = [abs(numpy.sum(start * numpy.exp(-2j * math.pi * hz * times))) for hz in grid]
    hz = grid[int(numpy.argmax(spectrum))]
    turn = numpy.exp(-2j * math.pi * hz * times)
    advance = numpy.angle(numpy.sum(later * turn) / numpy.sum(start * turn)
                          * numpy.exp(-2j * math.pi * hz * 400 / RATE))
    return hz + advance / (2 * math.pi * 400 / RATE)


@pytest.fixture(scope="module")
def played(console, tmp_path_factory):
    """Returns the notes as the sampler and as the console play them."""
    folder = tmp_path_factory.mktemp("sampler")
    samples = folder / "samples"
    subprocess.run([console, "sample", "Marimba", "-o", samples, "--keys", "48-84", "--velocities",
                    "5", "--every", "3", "--seconds", "3", *SETTINGS], check=True)
    # Polyphone converts without a window, but needs a home.
    environment = {**os.environ, "HOME": str(folder), "QT_QPA_PLATFORM": "offscreen"}
    subprocess.run(["polyphone", "-1", "-i", samples / "Marimba.sfz", "-d", folder, "-o", "font"],
                   check=True, env=environment, timeout=300)
    song = song_of(NOTES, folder / "song.mid")
    subprocess.run(["fluidsynth", "-ni", "-R", "0", "-C", "0", "-g", "1", "-r", str(RATE), "-O",
                    "float", "-T", "wav", "-F", folder / "sampler.wav", folder / "font.sf2", song],
                   check=True, env=environment, timeout=300)
    subprocess.run([console, "render", "--preset", "Marimba", "--midi", song, "-o",
                    folder / "console.wav", "--seconds", str(SECONDS * len(NOTES)), *SETTINGS,
                    "--set", "limiter=0"], check=True)
    return [pieces(soundfile.read(folder / f"{name}.wav", always_2d=True)[0])
            for name in ("sampler", "console")]


def soundfont_gain(velocity):
    return 40 * math.log10(velocity / 127)


def test_each_note_has_its_level_within_1_db(played):
    differences = [level(ours) - level(theirs) + soundfont_gain(velocity)
                   for (_, velocity), theirs, ours in zip(NOTES, *played)]
    print(*(f"{each:.2f}" for each in differences))
    assert max(differences) - min(differences) < 1, differences


def test_each_note_has_its_pitch_within_1_cent(played):
    for (key, _), theirs, ours in zip(NOTES, *played):
        near = 440 * 2 ** ((key - 69) / 12)
        cents = 1200 * math.log2(pitch(theirs, near) / pitch(ours, near))
        print(f"{key}: {cents:.3f} cents")
        assert abs(cents) < 1
