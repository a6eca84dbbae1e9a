"""Tests the LV2: its data files, lilv's listing, and its sound."""
import os
import re
import subprocess

import numpy
import pytest

from lv2_host import Lv2Host
from performance import (IDENTICAL, SAMPLE_RATE, Note, Performance, assert_equal_sound,
                         assert_sounds, onset, within)

BLOCK = 512

# The errors that lv2_validate finds in every bundle of JUCE 8.0.6. P stands for the plugin's URI.
# Any other error is ours.
JUCES_OWN = (
    r"Subject not in domain <\S+doap#Project> P \S+doap#(maintainer|release) \S+",
    r"Object not in range <\S+lv2core#ExtensionData> P:UI \S+#extensionData \S+ui#noUserResize",
    r"Object not in range <\S+lv2core#Feature> P:UI \S+#optionalFeature \S+options#interface",
    r"Subject not in domain <\S+lv2core#Port> P:\w+ \S+#portProperty "
    r"\S+#(toggled|enumeration|integer)",
    r"Use of undefined property \S+ P:Program \d+",
    r"Property <P:Program> has no label \S+ P:Program \d+",
)


@pytest.fixture
def environment(lv2):
    """Returns an environment in which lilv finds this bundle and the system's specifications."""
    folders = [str(lv2.parent), "/usr/lib/lv2", "/usr/local/lib/lv2", "/opt/homebrew/lib/lv2"]
    return os.environ | {"LV2_PATH": os.pathsep.join(folders)}


@pytest.fixture
def uri(lv2):
    return re.search(r"<(\S+)>\s+a lv2:Plugin", (lv2 / "manifest.ttl").read_text()).group(1)


def test_lv2_validate_finds_no_error_of_ours(lv2, uri):
    result = subprocess.run(["lv2_validate", *sorted(map(str, lv2.glob("*.ttl")))],
                            capture_output=True, text=True)
    text = result.stdout + result.stderr
    found = re.search(r"Found (\d+) errors? among (\d+) files", text)
    assert found and int(found.group(2)) > 0, text
    errors = [" ".join(error.split()).replace(uri, "P")
              for error in re.split(r"^error: ", result.stderr, flags=re.MULTILINE)[1:]]
    assert len(errors) == int(found.group(1)), text
    ours = [error for error in errors if not any(re.fullmatch(known, error) for known in JUCES_OWN)]
    assert not ours, "\n".join(ours)


def test_lilv_lists_it(environment, uri):
    listed = subprocess.run(["lv2ls"], env=environment, check=True, capture_output=True,
                            text=True).stdout.split()
    assert uri in listed


@pytest.fixture
def host(lv2, environment, uri):
    """Returns a function that makes instances; they are closed after the test."""
    hosts = []

    def make(block=BLOCK):
        hosts.append(Lv2Host(lv2, uri, environment, SAMPLE_RATE, block))
        return hosts[-1]
    yield make
    for one in hosts:
        one.close()


@pytest.fixture
def parameters(lv2, uri):
    text = (lv2 / "dsp.ttl").read_text()
    names = re.findall(r"^plug:(\w+)\n\ta lv2:Parameter", text, re.MULTILINE)
    assert len(names) > 15
    return [f"{uri}:{name}" for name in names]


def test_it_renders_the_song_as_the_console_does(host, song, console_render):
    audio = host().render(song.midi_events(), console_render.shape[1])
    assert_sounds(audio)
    assert_equal_sound(audio, console_render)


def test_blocks_of_changing_length_render_the_same(host):
    scale = Performance.scale().midi_events()
    lengths = numpy.random.default_rng(1).integers(0, BLOCK + 1, 400).tolist()
    assert_equal_sound(host().render(scale, SAMPLE_RATE, [1, 1, 0, 7, *lengths]),
                       host().render(scale, SAMPLE_RATE), IDENTICAL)


def test_blocks_longer_than_announced_render_the_same(host):
    scale = Performance.scale().midi_events()
    assert_equal_sound(host(block=64).render(scale, SAMPLE_RATE, [64, 16000, 65, 8192]),
                       host().render(scale, SAMPLE_RATE), IDENTICAL)


def test_a_bounce_equals_realtime_playback(host):
    scale, bounced, played = Performance.scale().midi_events(), host(), host()
    bounced.set_control("freeWheeling", 1)
    assert_equal_sound(bounced.render(scale, SAMPLE_RATE), played.render(scale, SAMPLE_RATE),
                       IDENTICAL)


@pytest.mark.parametrize("sample", (0, 1, 63, 64, 99, 100, 511, 512, 4001))
def test_a_note_sounds_from_its_exact_sample_on(host, sample):
    note = Performance([Note(sample, sample + 2000, 84, 100)]).midi_events()
    assert onset(host().render(note, 8000)) == sample
    assert onset(host(block=100).render(note, 8000)) == sample


def test_instances_do_not_affect_each_other(host):
    """Runs twenty instances in turn, block by block. Every other one plays nothing."""
    scale = Performance.scale().midi_events()
    hosts, blocks = [host() for _ in range(20)], SAMPLE_RATE // BLOCK
    rendered = [[] for _ in hosts]
    for start in range(0, blocks * BLOCK, BLOCK):
        now = within(scale, start, start + BLOCK)
        for position, one in enumerate(hosts):
            rendered[position].append(one.run(now if position % 2 == 0 else [], BLOCK))
    alone = host().render(scale, blocks * BLOCK)
    for position, pieces in enumerate(rendered):
        audio = numpy.concatenate(pieces, axis=1)
        if position % 2 == 0:
            assert_equal_sound(audio, alone, IDENTICAL)
        else:
            assert not audio.any()


def test_a_tempo_holds_until_the_host_sends_another(host, uri):
    """Hosts may send the tempo only when it changes."""
    notes, blocks = [(0, bytes((0x90, 84, 100)))], range(40)
    sixteenths = 8 / 15  # the last of nine choices, on a range for sixteen

    def played(told):
        one = host()
        for symbol, value in (("motor_depth", 1.0), ("motor_sync", sixteenths)):
            one.set_parameter(f"{uri}:{symbol}", value)
        rendered = []
        for number in blocks:
            if number in told:
                one.set_tempo(told[number])
            rendered.append(one.run(notes if number == 0 else [], BLOCK))
        return numpy.concatenate(rendered, axis=1)

    once = played({0: 120.0})
    assert_equal_sound(once, played(dict.fromkeys(blocks, 120.0)), IDENTICAL)
    assert numpy.abs(once - played({})).max() > 0.01 * numpy.abs(once).max()
    assert_equal_sound(played({0: 120.0, 20: 240.0}),
                       played({number: 120.0 if number < 20 else 240.0 for number in blocks}),
                       IDENTICAL)


def test_incoming_midi_is_not_sent_out(host):
    one = host()
    one.run([(3, bytes((0x90, 84, 100))), (9, bytes((0xb0, 64, 127)))], BLOCK)
    assert not [kind for kind in one.sent() if kind.endswith("MidiEvent")]


def test_a_disabled_plugin_is_silent_and_sounds_again_when_enabled(host):
    scale, one = Performance.scale().midi_events(), host()
    one.set_control("enabled", 0)
    assert not one.render(scale, SAMPLE_RATE).any()
    one.set_control("enabled", 1)
    assert_sounds(one.render(scale, SAMPLE_RATE))


def test_a_restored_state_is_equal_byte_for_byte_after_random_automation(host, parameters):
    first, second, values = host(), host(), numpy.random.default_rng(2)
    untouched = first.save()
    scale = Performance.scale().midi_events()
    for start in range(0, SAMPLE_RATE, BLOCK):
        for parameter in parameters:
            first.set_parameter(parameter, values.uniform())
        now = within(scale, start, start + BLOCK)
        assert numpy.isfinite(first.run(now, BLOCK)).all()
    saved = first.save()
    assert saved != untouched, "the state does not tell what was changed"
    second.restore(saved)
    assert second.save() == saved
