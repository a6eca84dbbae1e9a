"""Tests the effect, Idiophone Resonator, in pedalboard."""
import numpy
import pedalboard
import pytest

from performance import IDENTICAL, SAMPLE_RATE, assert_equal_sound, strongest_hz

BLOCK = 480
LOWEST_KEY_HZ = 349.23  # of the xylophone that it opens with


def noise(seconds=2.0, loudness=0.1):
    samples = numpy.random.default_rng(1).uniform(-loudness, loudness,
                                                  (2, int(seconds * SAMPLE_RATE)))
    return samples.astype(numpy.float32)


def impulse(seconds=2.0):
    samples = numpy.zeros((2, int(seconds * SAMPLE_RATE)), numpy.float32)
    samples[:, 100] = 0.5
    return samples


@pytest.fixture
def effect(vst3):
    """Returns a function that loads the effect with some parameters."""
    def load(**parameters):
        plugin = pedalboard.load_plugin(str(vst3))
        assert plugin.is_effect and not plugin.is_instrument
        for name, value in {"limiter": False, "radiation": 0, **parameters}.items():
            setattr(plugin, name, value)
        return plugin
    return load


def process(plugin, samples, block=BLOCK):
    return plugin.process(samples, SAMPLE_RATE, buffer_size=block, reset=True)


def test_silence_in_is_silence_out(effect):
    assert not process(effect(), numpy.zeros((2, SAMPLE_RATE), numpy.float32)).any()


def test_it_sounds_from_the_sample_that_comes_in(effect):
    plugin = effect()
    assert plugin.reported_latency_samples == 0
    sound = process(plugin, impulse())
    assert numpy.flatnonzero(sound.any(axis=0))[0] == 100


@pytest.mark.parametrize("block", (1, 64, 100, 512, 8192))
def test_blocks_of_any_size_sound_the_same(effect, block):
    samples = noise(0.5)
    assert_equal_sound(process(effect(), samples, block), process(effect(), samples), IDENTICAL)


def test_noise_gives_the_objects_spectrum(effect):
    assert abs(strongest_hz(process(effect(), impulse())) / LOWEST_KEY_HZ - 1) < 0.01
    hiss = noise(0.5)
    hiss = numpy.concatenate([hiss, numpy.zeros_like(hiss), numpy.zeros_like(hiss)], axis=1)
    response = process(effect(), impulse(hiss.shape[1] / SAMPLE_RATE))[0]
    came_out = process(effect(), hiss)[0]
    spectrum = numpy.fft.rfft(hiss.mean(axis=0))
    expected = numpy.fft.rfft(numpy.roll(response, -100) / 0.5) * spectrum
    difference = numpy.fft.irfft(expected) - came_out
    assert numpy.abs(difference).max() < 1e-3 * numpy.abs(came_out).max()


def test_dry_and_bypassed_sound_pass_unchanged(effect):
    samples = noise(0.5)
    assert_equal_sound(process(effect(dry_wet=0), samples), samples, IDENTICAL)
    assert_equal_sound(process(effect(bypass=True), samples), samples, IDENTICAL)
    wet, both = process(effect(), samples), process(effect(dry_wet=50), samples)
    assert_equal_sound(both, (wet + samples) / 2)
