"""Tests the song in Resources/Songs: it matches its script, and a xylophone can play it."""
import importlib.util
import sys

import mido
import pytest


@pytest.fixture(scope="module")
def script(songs):
    sys.dont_write_bytecode = True
    specification = importlib.util.spec_from_file_location("script", songs / "the_entertainer.py")
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def test_the_midi_file_matches_its_script(script, songs):
    assert script.song() == (songs / "TheEntertainer.mid").read_bytes()


def test_every_note_lies_on_the_three_octaves(song):
    assert song.notes
    assert {note.key for note in song.notes} <= set(range(72, 109))


def test_velocities_are_musical(song):
    velocities = {note.velocity for note in song.notes}
    assert min(velocities) >= 55 and max(velocities) <= 115 and len(velocities) > 4


def test_at_most_four_mallets_strike_at_once(song):
    starts = [note.start for note in song.notes]
    assert max(map(starts.count, starts)) <= 4


def test_it_has_introduction_and_first_strain_twice(songs):
    file = mido.MidiFile(songs / "TheEntertainer.mid")
    metas = {message.type: message for message in mido.merge_tracks(file.tracks) if message.is_meta}
    assert (metas["time_signature"].numerator, metas["time_signature"].denominator) == (2, 4)
    assert metas["key_signature"].key == "C"
    assert 72 <= mido.tempo2bpm(metas["set_tempo"].tempo) <= 80
    assert all(track.name for track in file.tracks)
    bars = 4 + 16 + 16
    length = max(sum(message.time for message in track) for track in file.tracks)
    assert bars - 1 < length / (2 * file.ticks_per_beat) <= bars


def test_the_strain_opens_with_its_tune(script):
    names = "D6 D#6 E6 C7 E6 C7 E6 C7 C7 D7 D#7 E7 C7 D7 E7 B6 D7 C7".split()
    sixteenth, bar = script.SIXTEENTH_TICKS, 8 * script.SIXTEENTH_TICKS
    top = {}
    for start, _, note, _ in script.notes_of(script.MELODY):
        top[start] = max(note, top.get(start, 0))
    tune = [note for start, note in sorted(top.items()) if start >= 4 * bar - 2 * sixteenth]
    assert tune[:len(names)] == [script.midi_note(name) for name in names]
