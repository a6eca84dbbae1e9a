"""Runs Steinberg's validator, and pluginval if it is installed."""
import re
import subprocess


FAILED_TEST = re.compile(r"^\[(.+)\]\n((?:[^\[\n].*\n)*)\[XXXXXXX Failed\]", re.MULTILINE)


def run(*command):
    return subprocess.run(list(map(str, command)), capture_output=True, text=True)


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


def test_pluginval_passes_at_strictness_10(pluginval, vst3):
    result = run(pluginval, "--strictness-level", 10, "--validate-in-process", "--validate", vst3)
    assert result.returncode == 0, result.stdout[-4000:] + result.stderr[-2000:]
