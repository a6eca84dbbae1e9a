"""Shared by the integration tests: the paths from CMake, the console's render, and the Python package."""
import pathlib
import subprocess
import sys

import pytest
import soundfile

from performance import PRESET, Performance


def pytest_addoption(parser):
    for name in ("sources", "build", "vst3", "lv2", "console", "validator", "pluginval", "songs", "ardour-lua",
                 "ardour-scanner"):
        parser.addoption(f"--{name}", help=f"path of the {name}")


def path_option(name):
    @pytest.fixture(scope="session")
    def path(pytestconfig):
        value = pytestconfig.getoption(f"--{name}")
        assert value, f"this test needs --{name}"
        path = pathlib.Path(value)
        assert path.exists(), f"{path} is not there: build it first"
        return path
    return path


sources, build = path_option("sources"), path_option("build")
vst3, lv2, console = path_option("vst3"), path_option("lv2"), path_option("console")
validator, pluginval = path_option("validator"), path_option("pluginval")
songs = path_option("songs")
ardour_lua, ardour_scanner = path_option("ardour-lua"), path_option("ardour-scanner")


@pytest.fixture(scope="session")
def song(songs):
    return Performance.from_midi_file(songs / "TheEntertainer.mid")


@pytest.fixture(scope="session")
def render_in_console(console, songs, tmp_path_factory):
    """Returns a function that renders a song in the console: [channels, frames], 48 kHz float."""
    def render(preset, *assignments, song=songs / "TheEntertainer.mid"):
        wave = tmp_path_factory.mktemp("console") / "song.wav"
        changes = [argument for assignment in assignments for argument in ("--set", assignment)]
        subprocess.run([console, "render", "--preset", preset, *changes, "-o", wave,
                        "--midi", song, "--sample-rate", "48000"],
                       check=True)
        assert soundfile.info(wave).subtype == "FLOAT"
        samples, rate = soundfile.read(wave, dtype="float32", always_2d=True)
        assert rate == 48000
        return samples.T
    return render


@pytest.fixture(scope="session")
def console_render(render_in_console):
    return render_in_console(PRESET)


@pytest.fixture(scope="session")
def idiophone(build, sources, tmp_path_factory):
    """Builds the Python package on the installed library, on Linux as a wheel, and imports it."""
    prefix, site = tmp_path_factory.mktemp("prefix"), tmp_path_factory.mktemp("site")
    made = tmp_path_factory.mktemp("made")

    def run(*command):
        result = subprocess.run(command, capture_output=True, text=True)
        assert result.returncode == 0, result.stdout + result.stderr
    run("cmake", "--install", build, "--component", "development", "--prefix", prefix)
    package = [sources, "--no-build-isolation", "--config-settings", "cmake.source-dir=Source/Python",
               "--config-settings", f"cmake.define.CMAKE_PREFIX_PATH={prefix}", "--config-settings", f"build-dir={made}"]
    if sys.platform == "linux":
        run(sources / "Source/Python/make_wheels.sh", "-l", prefix, "-o", made, sys.executable)
        package = made.glob("*.whl")
    run(sys.executable, "-m", "pip", "install", "--no-deps", "--target", site, *package)
    sys.path.insert(0, str(site))
    import idiophone as imported
    assert imported.__file__.startswith(str(site))
    return imported
