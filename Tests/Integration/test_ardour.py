"""Tests the plugin in Ardour 7: found, played by a MIDI track, saved with the session, exported.

Ardour changes no sample on the way to the file: faders at 0 dB do nothing, and a track of two
channels goes into a master of two without a panner's gains.
"""
import mido
import pytest

from ardour_host import Ardour
from performance import IDENTICAL, PRESET, SAMPLE_RATE, assert_equal_sound, assert_sounds


@pytest.fixture(scope="module")
def ardour(ardour_lua, ardour_scanner, vst3, lv2, tmp_path_factory):
    return Ardour(ardour_lua, ardour_scanner, tmp_path_factory.mktemp("home"), vst3, lv2)


@pytest.fixture
def song_file(songs):
    return songs / "TheEntertainer.mid"


def test_the_vst3_renders_the_song_as_the_console_does(ardour, song_file, console_render, tmp_path):
    session = tmp_path / "session"
    ardour.make_session(session, song_file, "VST3", PRESET)
    audio = ardour.render(session, console_render.shape[1])
    assert_sounds(audio)
    assert_equal_sound(audio, console_render, IDENTICAL)


def test_a_session_opens_with_the_program_and_the_values_it_was_saved_with(
        ardour, song_file, render_in_console, tmp_path):
    expected = render_in_console("Handbell", "let_ring=1", "strike_along=-100")
    session = tmp_path / "session"
    ardour.make_session(session, song_file, "VST3", "Handbell",
                        [("Let ring", "1"), ("Position", "0")])
    assert_equal_sound(ardour.render(session, expected.shape[1]), expected, IDENTICAL)


def test_an_octave_alone_sounds_on_the_vst3s_output_for_it(
        ardour, song_file, render_in_console, tmp_path):
    octave_5, frames = range(72, 84), 6 * SAMPLE_RATE
    part = tmp_path / "part.mid"
    song = mido.MidiFile(song_file)
    for track in song.tracks:
        silence_other_keys(track, octave_5)
    song.save(part)
    expected = render_in_console(PRESET, "spread=0", song=part)[:, :frames]
    session = tmp_path / "session"
    ardour.make_session(session, song_file, "VST3", PRESET,
                        [("Spread", "0"), ("Outputs", str(2 / 3))], output=5)
    audio = ardour.render(session, frames)
    assert_sounds(audio)
    assert_equal_sound(audio, expected, IDENTICAL)


def silence_other_keys(track, keys):
    """Takes the notes of other keys out of a track; the others keep their times."""
    kept, delay = [], 0
    for message in track:
        delay += message.time
        if message.type in ("note_on", "note_off") and message.note not in keys:
            continue
        kept.append(message.copy(time=delay))
        delay = 0
    track[:] = kept


def test_a_session_opens_with_the_program_of_the_lv2(
        ardour, song_file, render_in_console, tmp_path):
    expected = render_in_console("Handbell")
    session = tmp_path / "session"
    ardour.make_session(session, song_file, "LV2", "Handbell")
    assert_equal_sound(ardour.render(session, expected.shape[1]), expected, IDENTICAL)
