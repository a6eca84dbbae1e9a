"""Tests the VST3 in DawDreamer, a host built on JUCE.

Run it without a display. DawDreamer opens a window when it loads a state, and an X server without a
window manager then ends the process (X error BadAtom). Tests use stereo only: when the number of
channels changes, DawDreamer asks for an input bus, even one without channels.
"""
import dawdreamer
import numpy
import pytest

from performance import (IDENTICAL, SAMPLE_RATE, Performance, assert_equal_sound, assert_sounds,
                         level, seconds)

BLOCK = 512


class Host:
    """An engine with one instance of the plugin."""

    def __init__(self, vst3, block=BLOCK):
        self.engine = dawdreamer.RenderEngine(SAMPLE_RATE, block)
        self.plugin = self.engine.make_plugin_processor("idiophone", str(vst3))
        self.engine.load_graph([(self.plugin, [])])

    def parameters(self):
        """Returns index and name of the parameters, without those JUCE adds for controllers."""
        return [(one["index"], one["name"]) for one in self.plugin.get_parameters_description()
                if not one["name"].startswith("MIDI CC ")]

    def stepped(self):
        """Returns the names of choices, switches and integers, which snap to the nearest value."""
        return {one["name"] for one in self.plugin.get_parameters_description()
                if one["isDiscrete"]}

    def index(self, name):
        return next(index for index, each in self.parameters() if each == name)

    def values(self):
        return [self.plugin.get_parameter_text(index) for index, _ in self.parameters()]

    def render(self, performance, frames):
        self.plugin.clear_midi()
        for note in performance.notes:
            self.plugin.add_midi_note(note.key, note.velocity, seconds(note.start),
                                      (note.end - note.start) / SAMPLE_RATE)
        self.engine.render(seconds(frames))
        return self.engine.get_audio()[:, :frames]

    def state(self, file):
        self.plugin.save_state(str(file))
        return file.read_bytes()


@pytest.fixture
def host(vst3):
    return lambda **options: Host(vst3, **options)


def test_it_renders_the_song_as_the_console_does(host, song, console_render):
    host = host()
    assert host.plugin.get_latency_samples() == 0
    assert_equal_sound(host.render(song, console_render.shape[1]), console_render)


@pytest.mark.parametrize("block", (1, 64, 100, 2048, 8192))
def test_blocks_of_any_size_render_the_same(host, block):
    scale = Performance.scale()
    assert_equal_sound(host(block=block).render(scale, SAMPLE_RATE),
                       host().render(scale, SAMPLE_RATE), IDENTICAL)


def test_the_hosts_tempo_does_not_change_the_sound(host):
    scale, restless = Performance.scale(), host()
    every_twentieth_of_a_beat = numpy.random.default_rng(1).uniform(30, 300, 200)
    assert restless.engine.set_bpm(every_twentieth_of_a_beat.astype(numpy.float32), 20)
    assert_equal_sound(restless.render(scale, SAMPLE_RATE), host().render(scale, SAMPLE_RATE),
                       IDENTICAL)


def test_automated_bypass_mutes_and_lets_modes_ring_on(host):
    scale, bypassed = Performance.scale(), host()
    on, off, fade = 20 * BLOCK, 50 * BLOCK, 2000
    automation = numpy.zeros(SAMPLE_RATE, numpy.float32)
    automation[on:off] = 1
    bypassed.plugin.set_automation(bypassed.index("Bypass"), automation)
    audio, expected = bypassed.render(scale, SAMPLE_RATE), host().render(scale, SAMPLE_RATE)
    assert expected[:, on + fade:off].any(axis=0).mean() > 0.9
    assert not audio[:, on + fade:off].any()
    for untouched in (slice(0, on), slice(off + fade, None)):
        assert_equal_sound(audio[:, untouched], expected[:, untouched], IDENTICAL)


def test_every_parameter_moves_through_its_range_while_notes_sound(host):
    host = host()
    parameters = host.parameters()
    assert len(parameters) > 15
    host.plugin.record_automation = True
    sweep = numpy.linspace(0, 1, SAMPLE_RATE)
    for index, name in parameters:
        resting = host.plugin.get_parameter(index)
        host.plugin.set_automation(index, sweep)
        audio = host.render(Performance.scale(), SAMPLE_RATE)
        assert numpy.isfinite(audio).all(), name
        followed = host.plugin.get_automation()[name]
        assert followed.min() < 0.05 and followed.max() > 0.95, f"{name} did not follow the sweep"
        host.plugin.set_automation(index, numpy.full(SAMPLE_RATE, resting))
    assert_sounds(host.render(Performance.scale(), SAMPLE_RATE))


def test_loudness_is_matched_while_the_mallet_is_automated(host):
    host = host()
    mallet = host.index("Mallet")
    change = numpy.full(3 * SAMPLE_RATE, host.plugin.get_parameter(mallet), numpy.float32)
    change[SAMPLE_RATE // 2:] = 1 / 7  # yarn, the first of the seven of the rack
    host.plugin.set_automation(mallet, change)
    later = Performance.scale(2 * SAMPLE_RATE)

    def decibels(matches):
        host.plugin.set_parameter(host.index("Match loudness"), matches)
        return level(host.render(later, 3 * SAMPLE_RATE)[:, 2 * SAMPLE_RATE:])

    assert decibels(1) > decibels(0) + 15


def test_a_restored_state_is_equal_byte_for_byte_and_sounds_the_same(host, tmp_path):
    first = host()
    untouched = first.state(tmp_path / "untouched")
    for position, (index, name) in enumerate(first.parameters()):
        if name not in ("Bypass", "Program", "Contact"):  # a rolled bar is faint
            first.plugin.set_parameter(index, (0.3, 0.55, 0.7)[position % 3])
    saved = first.state(tmp_path / "saved")
    assert saved != untouched, "the state does not tell what was changed"

    second = host()
    second.plugin.load_state(str(tmp_path / "saved"))
    assert second.state(tmp_path / "again") == saved
    assert second.values() == first.values()

    scale, frames = Performance.scale(), SAMPLE_RATE
    first.render(Performance([]), frames)
    expected = first.render(scale, frames)
    assert_equal_sound(second.render(scale, frames), expected)


def test_a_state_keeps_the_end_of_random_automation_byte_for_byte(host, tmp_path):
    first, random, last = host(), numpy.random.default_rng(2), {}
    for index, name in first.parameters():
        if name == "Program":  # a program sets the others
            continue
        steps = random.uniform(0, 1, SAMPLE_RATE // BLOCK + 1).astype(numpy.float32)
        first.plugin.set_automation(index, numpy.repeat(steps, BLOCK)[:SAMPLE_RATE])
        last[name] = steps[-1]
    assert numpy.isfinite(first.render(Performance.scale(), SAMPLE_RATE)).all()
    saved = first.state(tmp_path / "saved")

    second = host()
    second.plugin.load_state(str(tmp_path / "saved"))
    assert second.state(tmp_path / "again") == saved
    reached = {name: second.plugin.get_parameter(second.index(name)) for name in last}
    assert {name for name in last if abs(reached[name] - last[name]) > 1e-4} <= second.stepped()


def test_a_state_is_restored_after_random_values_and_programs(host, tmp_path):
    same, random = host(), numpy.random.default_rng(3)
    before, saved = same.values(), same.state(tmp_path / "saved")
    for _ in range(3):
        for index, name in same.parameters():
            if name != "Bypass":
                same.plugin.set_parameter(index, random.uniform())
        assert numpy.isfinite(same.render(Performance.scale(), SAMPLE_RATE)).all()
        assert same.values() != before
        same.plugin.load_state(str(tmp_path / "saved"))
        assert same.state(tmp_path / "again") == saved
        assert same.values() == before
