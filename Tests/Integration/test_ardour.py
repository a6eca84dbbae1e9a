"""The VST3 in Ardour 7: scanned, played by a MIDI track, saved with the session, exported.

Ardour leaves every sample as it is on the way to the file: faders at 0 dB do not act, and a track of
two channels goes into a master of two without a panner's gains.
"""
import pytest

from ardour_host import Ardour
from performance import IDENTICAL, PRESET, assert_equal_sound, assert_sounds


@pytest.fixture(scope="module")
def ardour(ardour_lua, ardour_scanner, vst3, tmp_path_factory):
    return Ardour(ardour_lua, ardour_scanner, tmp_path_factory.mktemp("home"), vst3)


@pytest.fixture
def song_file(songs):
    return songs / "TheEntertainer.mid"


def test_it_renders_the_song_as_the_console_does(ardour, song_file, console_render, tmp_path):
    ardour.make_session(tmp_path / "session", song_file, PRESET)
    audio = ardour.render(tmp_path / "session", console_render.shape[1])
    assert_sounds(audio)
    assert_equal_sound(audio, console_render, IDENTICAL)


def test_a_session_opens_with_the_program_and_the_values_it_was_saved_with(
        ardour, song_file, render_in_console, tmp_path):
    expected = render_in_console("Handbell", "let_ring=1", "strike_along=-100")
    ardour.make_session(tmp_path / "session", song_file, "Handbell",
                        [("Let ring", "1"), ("Strike position along", "0")])
    audio = ardour.render(tmp_path / "session", expected.shape[1])
    assert_equal_sound(audio, expected, IDENTICAL)
