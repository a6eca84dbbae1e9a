"""Tests the VST3 in pedalboard, whose host code is its own.

Tests use stereo only: pedalboard cannot change the number of channels of a plugin without inputs.
"""
import numpy
import pedalboard
import pytest

from performance import (IDENTICAL, PRESET, SAMPLE_RATE, Note, Performance, assert_equal_sound,
                         assert_sounds, level, onset, seconds, within)

BLOCK = 480
# After loading, pedalboard plays middle C until something sounds, but at most this long. A
# xylophone has no middle C.
LOADING_SECONDS = 0.1
POSITIONS = (0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0)


@pytest.fixture
def load(vst3):
    return lambda: pedalboard.load_plugin(str(vst3), initialization_timeout=LOADING_SECONDS)


def render(plugin, performance, frames, reset=True, block=BLOCK):
    return render_events(plugin, performance.midi_events(), frames, reset, block)


def render_events(plugin, events, frames, reset, block=BLOCK):
    messages = [(message, seconds(sample)) for sample, message in events]
    return plugin(messages, duration=seconds(frames), sample_rate=SAMPLE_RATE,
                  num_channels=2, buffer_size=block, reset=reset)


def change(plugin):
    """Moves the sound's parameters off their defaults, to values that each of them accepts."""
    for position, parameter in enumerate(sound_parameters(plugin)):
        parameter.raw_value = (0.3, 0.55, 0.7)[position % 3]
    plugin.preset_level_db, plugin.volume_db, plugin.contact = -5, -3, "Strike"  # so that it is heard


def sound_parameters(plugin):
    return [parameter for name, parameter in plugin.parameters.items()
            if name not in ("bypass", "program")]


def test_it_renders_the_song_as_the_console_does(load, song, console_render):
    plugin = load()
    assert plugin.parameters["program"].string_value == PRESET
    assert plugin.reported_latency_samples == 0
    assert_equal_sound(render(plugin, song, console_render.shape[1]), console_render)


@pytest.mark.parametrize("block", (1, 64, 100, 512, 2048, 8192))
def test_blocks_of_any_size_render_the_same(load, block):
    plugin, scale = load(), Performance.scale()
    expected = render(plugin, scale, SAMPLE_RATE)
    assert_equal_sound(render(plugin, scale, SAMPLE_RATE, block=block), expected, IDENTICAL)


def test_playing_piece_by_piece_equals_one_bounce(load):
    plugin, events = load(), Performance.scale().midi_events()
    bounce = render_events(plugin, events, SAMPLE_RATE, reset=True)
    lengths, pieces, start = numpy.random.default_rng(1), [], 0
    while start < SAMPLE_RATE:
        end = min(start + int(lengths.integers(1, 3000)), SAMPLE_RATE)
        pieces.append(render_events(plugin, within(events, start, end), end - start,
                                    reset=start == 0))
        start = end
    assert_equal_sound(numpy.concatenate(pieces, axis=1), bounce, IDENTICAL)


@pytest.mark.parametrize("block", (64, 100, 512, 8192))
def test_a_note_sounds_from_its_exact_sample_on(load, block):
    plugin = load()
    for sample in (0, 1, 63, 64, 99, 100, 511, 512, 4001):
        note = Performance([Note(sample, sample + 2000, 84, 100)])
        assert onset(render(plugin, note, 8000, block=block)) == sample


def test_every_parameter_moves_through_its_range_while_notes_sound(load):
    plugin = load()
    assert len(plugin.parameters) > 15
    performance, quiet = Performance.scale(), Performance([])
    for name, parameter in plugin.parameters.items():
        resting = parameter.raw_value
        for position in POSITIONS:
            parameter.raw_value = position
            audio = render(plugin, performance, SAMPLE_RATE // 8, reset=False)
            assert numpy.isfinite(audio).all(), f"{name} at {position}"
        assert parameter.raw_value > 0.95, f"{name} did not follow"
        parameter.raw_value = resting
        assert numpy.isfinite(render(plugin, quiet, 4096, reset=False)).all(), name
    assert_sounds(render(plugin, performance, SAMPLE_RATE))


def test_loudness_is_matched_while_it_plays_though_no_message_loop_runs(load):
    plugin, scale = load(), Performance.scale()

    def decibels(reset):
        return level(render(plugin, scale, SAMPLE_RATE, reset=reset))

    own = decibels(reset=True)
    plugin.mallet = "Yarn"
    decibels(reset=False)
    assert decibels(reset=False) < own - 15
    plugin.match_loudness = True
    decibels(reset=False)  # the gain glides
    matched = decibels(reset=False)
    assert matched > own - 5
    assert abs(matched - decibels(reset=True)) < 0.5


@pytest.mark.parametrize("reset", (False, True))
def test_a_chosen_program_changes_everything_at_once_though_no_message_loop_runs(load, reset):
    def loaded(program):
        plugin = load()
        render(plugin, Performance([]), 4800)  # from now on it is offline
        plugin.program = program
        return plugin

    expected = {"program": "Vibraphone", "mallet": "Hard rubber", "preset_level_db": "-21.1"}
    plugin = loaded("Vibraphone")
    shown = {name: plugin.parameters[name].string_value for name in expected}
    assert shown == expected
    sound = render(plugin, Performance.scale(), SAMPLE_RATE, reset)
    assert {name: plugin.parameters[name].string_value for name in expected} == expected

    plugin.program = "Marimba"
    plugin.program = "Vibraphone"
    assert_equal_sound(render(plugin, Performance.scale(), SAMPLE_RATE, reset=True), sound)
    plugin.preset_level_db = -30
    assert level(render(plugin, Performance.scale(), SAMPLE_RATE, reset=True)) < level(sound) - 8


def test_a_restored_state_is_equal_byte_for_byte_and_sounds_the_same(load):
    first = load()
    untouched = first.raw_state
    change(first)
    saved = first.raw_state
    assert saved != untouched, "the state does not tell what was changed"

    second = load()
    second.raw_state = saved
    assert second.raw_state == saved
    assert [p.string_value for p in second.parameters.values()] == [
        p.string_value for p in first.parameters.values()]

    scale, frames = Performance.scale(), SAMPLE_RATE
    render(first, Performance([]), frames)
    expected = render(first, scale, frames)
    assert_equal_sound(render(second, scale, frames), expected)


def test_a_state_of_random_bytes_does_no_harm(load):
    plugin = load()
    state = plugin.raw_state
    noise = numpy.random.default_rng(1)
    for length in (0, 1, 7, 64, 4096):
        plugin.raw_state = noise.bytes(length)
    plugin.raw_state = state[:len(state) // 2]
    assert_sounds(render(plugin, Performance.scale(), SAMPLE_RATE))
