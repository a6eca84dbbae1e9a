"""Tests the notes of the effect, Idiophone Resonator, in DawDreamer, which sends MIDI to effects."""
import dawdreamer
import numpy

from performance import SAMPLE_RATE, strongest_hz

LOWEST_KEY_HZ, C6_KEY, C6_HZ = 349.23, 84, 1046.5  # of the xylophone that it opens with


def effect_on(sound, vst3):
    """Returns an engine that plays the sound through the effect, and the effect."""
    engine = dawdreamer.RenderEngine(SAMPLE_RATE, 512)
    source = engine.make_playback_processor("source", sound)
    effect = engine.make_plugin_processor("effect", str(vst3))
    engine.load_graph([(source, []), (effect, ["source"])])
    return engine, effect


def impulse_at(sample):
    samples = numpy.zeros((2, 3 * SAMPLE_RATE), numpy.float32)
    samples[:, sample] = 0.5
    return samples


def rest(sound):
    """Returns what rings longer than the overtones."""
    return sound[:, SAMPLE_RATE // 4:]


def test_the_lowest_key_resonates_before_any_note(vst3):
    engine, effect = effect_on(impulse_at(0), vst3)
    assert effect.get_latency_samples() == 0
    engine.render(2)
    assert abs(strongest_hz(rest(engine.get_audio())) / LOWEST_KEY_HZ - 1) < 0.01


def test_a_note_strikes_and_chooses_the_key_that_resonates(vst3):
    engine, effect = effect_on(impulse_at(SAMPLE_RATE), vst3)
    effect.add_midi_note(C6_KEY, 100, 0.1, 0.2)
    engine.render(3)
    sound = engine.get_audio()
    struck, pressed = rest(sound[:, :SAMPLE_RATE]), rest(sound[:, SAMPLE_RATE:])
    for part in (struck, pressed):
        assert part.any()
        assert abs(strongest_hz(part) / C6_HZ - 1) < 0.01
