"""The LV2: its data files, whether lilv finds it, and how it sounds."""
import os
import re
import subprocess

import pytest

from lv2_host import Lv2Host
from performance import SAMPLE_RATE, assert_equal_sound, assert_sounds

BLOCK = 512

# What lv2_validate finds in every bundle that JUCE 8.0.6 writes, whatever the plugin says. P stands
# for the plugin's URI. Anything else is ours.
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
    """Where lilv looks: this bundle, and the specifications of the system."""
    folders = [str(lv2.parent), "/usr/lib/lv2", "/usr/local/lib/lv2", "/opt/homebrew/lib/lv2"]
    return os.environ | {"LV2_PATH": os.pathsep.join(folders)}


@pytest.fixture
def uri(lv2):
    return re.search(r"<(\S+)>\s+a lv2:Plugin", (lv2 / "manifest.ttl").read_text()).group(1)


def test_lv2_validate_finds_no_error_of_ours(lv2, uri):
    result = subprocess.run(["lv2_validate", *sorted(map(str, lv2.glob("*.ttl")))],
                            capture_output=True, text=True, timeout=120)
    text = result.stdout + result.stderr
    found = re.search(r"Found (\d+) errors? among (\d+) files", text)
    assert found and int(found.group(2)) > 0, text
    errors = [" ".join(error.split()).replace(uri, "P")
              for error in re.split(r"^error: ", result.stderr, flags=re.MULTILINE)[1:]]
    assert len(errors) == int(found.group(1)), text
    ours = [error for error in errors if not any(re.fullmatch(known, error) for known in JUCES_OWN)]
    assert not ours, "\n".join(ours)


def test_lilv_lists_it(environment, uri):
    listed = subprocess.run(["lv2ls"], env=environment, check=True, capture_output=True, text=True,
                            timeout=60).stdout.split()
    assert uri in listed


def test_it_renders_the_song_as_the_console_does(lv2, environment, uri, song, console_render):
    binary = next(path for ending in ("so", "dylib", "dll") for path in lv2.glob(f"*.{ending}"))
    host = Lv2Host(lv2, binary, uri, environment, SAMPLE_RATE, BLOCK)
    audio = host.render(song.midi_events(), console_render.shape[1])
    host.close()
    assert_sounds(audio)
    assert_equal_sound(audio, console_render)
