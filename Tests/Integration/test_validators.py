"""Steinberg's validator, and pluginval where it is installed."""
import os
import re
import subprocess


FAILED_TEST = re.compile(r"^\[(.+)\]\n((?:[^\[\n].*\n)*)\[XXXXXXX Failed\]", re.MULTILINE)


def run(*command):
    return subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=900)


def assert_steinberg_passes(validator, vst3, fewest_tests, *options):
    result = run(validator, *options, vst3)
    summary = re.search(r"Result: (\d+) tests passed, (\d+) tests failed", result.stdout)
    assert summary, f"the validator came to no end:\n{result.stdout[-2000:]}{result.stderr[-2000:]}"
    passed, failed = map(int, summary.groups())
    assert failed == 0, FAILED_TEST.findall(result.stdout)
    assert passed >= fewest_tests
    assert result.returncode == 0, result.stderr[-2000:]


def test_steinbergs_validator_passes(validator, vst3):
    assert_steinberg_passes(validator, vst3, 47)


def test_steinbergs_validator_passes_its_extensive_tests(validator, vst3):
    assert_steinberg_passes(validator, vst3, 400, "-e")


def test_steinbergs_validator_finds_the_names_by_which_songs_know_a_vst3(validator, vst3, sources):
    """Its classes, and the numbers that JUCE makes of its parameters' ids: settings of JUCE move both.
    With IDIOPHONE_MAKE_GOLDEN set this version's are kept, for a release."""
    said = run(validator, vst3).stdout
    names = ["class " + name for name in re.findall(r"^\tcid = (\w+)$", said, re.MULTILINE)]
    names += ["parameter " + name
              for name in re.findall(r"Parameter \d+ \(id=(\d+)\): \[title=\"(?!MIDI CC)", said)]
    golden = sources / "Tests/Plugin/Golden"
    if os.environ.get("IDIOPHONE_MAKE_GOLDEN"):
        version = re.search(r"^\tversion = (\S+)$", said, re.MULTILINE).group(1)
        (golden / version / "vst3.txt").write_text("\n".join(names) + "\n")
    released = list(golden.glob("*/vst3.txt"))
    assert released
    for file in released:
        lines = file.read_text().splitlines()
        assert len(lines) >= 3 + 45
        assert set(lines) <= set(names), file


def test_pluginval_passes_at_strictness_10(pluginval, vst3):
    result = run(pluginval, "--strictness-level", 10, "--validate-in-process", "--validate", vst3)
    assert result.returncode == 0, result.stdout[-4000:] + result.stderr[-2000:]
