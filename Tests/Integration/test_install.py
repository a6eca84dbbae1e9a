"""Tests `cmake --install`: the plugins, the programs and their desktop files."""
import configparser
import json
import os
import re
import shutil
import subprocess
import xml.etree.ElementTree as xml

import numpy
import pedalboard
import pytest
from mido import Message

ID = "org.idiophone.Idiophone"


@pytest.fixture(scope="module")
def prefix(build, tmp_path_factory):
    folder = tmp_path_factory.mktemp("install") / "usr"
    subprocess.run(["cmake", "--install", build, "--prefix", folder], check=True,
                   capture_output=True)
    return folder


def run(program, *arguments, cwd):
    # The environment of a new user: no sources nearby and no settings.
    return subprocess.run([program, *map(str, arguments)], cwd=cwd, env={"HOME": str(cwd)},
                          capture_output=True, text=True, check=True).stdout


def test_nothing_of_other_projects_is_installed(prefix):
    programs = {path.name for path in (prefix / "bin").iterdir()}
    assert programs == {"idiophone", "idiophone-standalone"}
    assert {path.name for path in prefix.iterdir()} == {"bin", "include", "lib", "share"}
    assert {path.name for path in (prefix / "include").iterdir()} == {"idiophone", "idiophone.h"}
    assert {path.name for path in (prefix / "lib/cmake").iterdir()} == {"Idiophone"}


def test_the_console_finds_its_presets(prefix, songs, tmp_path):
    console = prefix / "bin/idiophone"
    assert "Rosewood Xylophone" in run(console, "presets", cwd=tmp_path)
    run(console, "render", "--preset", "Rosewood Xylophone", "--midi", songs / "TheEntertainer.mid",
        "-o", "song.wav", "--seconds", "2", cwd=tmp_path)
    assert (tmp_path / "song.wav").stat().st_size > 48000


def test_the_docs_are_installed_with_their_images(prefix):
    documents = prefix / "share/doc/idiophone"
    pages = list(documents.glob("**/*.md"))
    assert {documents / "README.md", documents / "docs/manual/README.md"} < set(pages)
    lost = [f"{page}: {link}" for page in pages
            for link in re.findall(r"\]\(([^)#\s]+)", page.read_text())
            if "://" not in link and not (page.parent / link).exists()]
    assert not lost
    assert (documents / "docs/manual/images/dropped.png").exists()


def test_no_installed_file_has_a_path_of_its_build(build, prefix, sources):
    if "CMAKE_BUILD_TYPE:STRING=Release" not in (build / "CMakeCache.txt").read_text():
        pytest.skip("only a release has no debug information")
    told = [str(path) for path in prefix.rglob("*") if path.is_file()
            and any(str(folder).encode() in path.read_bytes()
                    for folder in (build, sources / "build", sources / "Source"))]
    assert not told


def table_cells(page, heading, column=0):
    """Returns the cells of a column of the table below a heading."""
    text = page.read_text().split(f"## {heading}\n")[1].split("\n## ")[0]
    rows = [line.strip("| ").split("|") for line in text.splitlines() if line.startswith("|")]
    return [row[column].strip() for row in rows[2:]]


def test_every_package_has_the_licences_of_its_contents(prefix):
    for folder in ("idiophone", "idiophone-dev"):
        documents = prefix / "share/doc" / folder
        assert "AFFERO" in (documents / "copyright").read_text()
        notices = (documents / "THIRD-PARTY").read_text()
        for cell in table_cells(prefix / "share/doc/idiophone/docs/dependencies.md",
                                "In the program"):
            name = re.sub(r"\[(.*)\]\(.*\)", r"\1", cell).split(", in JUCE")[0]
            for each in re.split(", | headers| client", name):
                assert f"\n{each}" in notices or f", {each}" in notices or not each, each
        for each in ("LLVM 16", "wasi-libc"):  # in the WebAssembly module
            assert f"\n{each}" in notices, each
        for licence in ("GPL-3.0", "LGPL-3.0", "MPL-2.0", "Apache-2.0", "BSL-1.0"):
            assert f"\n{'=' * 80}\n{licence}\n{'=' * 80}\n" in notices


@pytest.mark.skipif(shutil.which("readelf") is None, reason="there is no readelf")
def test_the_page_of_dependencies_lists_every_shared_library(prefix):
    programs = [prefix / "bin/idiophone", prefix / "bin/idiophone-standalone",
                *prefix.glob("lib/*/Idiophone.*/**/*.so")]
    assert len(programs) == 4
    needed = set()
    for program in programs:
        told = subprocess.run(["readelf", "-d", program], check=True, capture_output=True,
                              text=True, env={"LC_ALL": "C"}).stdout
        needed |= set(re.findall(r"\(NEEDED\).*\[(.*?)\.so", told))
    cells = table_cells(prefix / "share/doc/idiophone/docs/dependencies.md",
                        "Shared libraries on Linux")
    listed = set(re.findall(r"`(.*?)`", " ".join(cells)))
    assert {"libX11", "libc"} < needed
    unlisted = {name for name in needed - listed if not name.startswith("ld-linux")}
    assert not unlisted


def test_the_installed_plugin_plays(prefix):
    plugin = pedalboard.load_plugin(str(prefix / "lib/vst3/Idiophone.vst3"))
    sound = plugin([Message("note_on", note=72, velocity=100, time=0)], 0.5, 48000)
    assert abs(sound).max() > 0.001
    for name in ("Idiophone", "Idiophone Resonator"):
        assert (prefix / f"lib/lv2/{name}.lv2/manifest.ttl").exists()
    assert (prefix / "lib/vst3/Idiophone Resonator.vst3").exists()


@pytest.fixture(scope="module")
def examples(prefix, sources, tmp_path_factory):
    """Builds the programs of docs/library with the installed package."""
    folder = tmp_path_factory.mktemp("examples")

    def cmake(*arguments):
        result = subprocess.run(["cmake", *arguments], capture_output=True, text=True)
        assert result.returncode == 0, result.stdout + result.stderr
    cmake("-S", sources / "docs/library", "-B", folder,
          f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Release")
    cmake("--build", folder)
    return folder


def test_a_program_on_the_library_analyses_as_the_console_does(prefix, examples, tmp_path):
    console = prefix / "bin/idiophone"
    run(console, "mesh", "bar", "-o", "bar.obj", cwd=tmp_path)
    run(console, "analyse", "bar.obj", "-o", "bar.modal", "--material", "Glass",
        "--max-frequency", "22000", cwd=tmp_path)
    run(examples / "mesh_to_modal", "bar.obj", "Glass", "mine.modal", cwd=tmp_path)
    told = [json.loads(run(console, "info", "--json", name, cwd=tmp_path))
            for name in ("bar.modal", "mine.modal")]
    assert len(told[0]["modes"]) > 20
    assert told[0]["modes"] == told[1]["modes"]


def test_a_game_loop_on_the_library_hears_its_impacts(examples, sources, tmp_path):
    sound = tmp_path / "bounce.f32"
    subprocess.run([examples / "game_loop", sources / "Resources/Objects/plate.modal", sound],
                   check=True)
    samples = numpy.fromfile(sound, "<f4")
    assert abs(len(samples) - 3 * 48000) < 480
    assert numpy.isfinite(samples).all()
    # The ball falls from 20 cm. The next impact comes after twice 0.8 of the fall time, and so on.
    fall = (2 * 0.2 / 9.81) ** 0.5
    first = numpy.flatnonzero(samples)[0] / 48000
    assert abs(first - fall) < 0.001
    def loudness(seconds):
        around = samples[int(48000 * seconds):][:240]
        return abs(around).max()
    assert loudness(fall + 0.001) > 2 * loudness(fall + 1.55 * fall)


def test_a_program_in_c_is_heard(prefix, examples, sources, tmp_path):
    plate = sources / "Resources/Objects/plate.modal"
    libraries = next(prefix.rglob("libidiophone.so")).parent
    flags = subprocess.run(["pkg-config", "--cflags", "--libs", "idiophone"], text=True, check=True,
                           env={**os.environ, "PKG_CONFIG_PATH": libraries / "pkgconfig"},
                           capture_output=True).stdout.split()
    subprocess.run(["cc", "-std=c99", sources / "docs/library/hit.c", "-o", tmp_path / "hit",
                    *flags], check=True)
    for program in (tmp_path / "hit", examples / "hit"):
        subprocess.run([program, plate, tmp_path / "hit.f32"], check=True,
                       env={"LD_LIBRARY_PATH": libraries})
        samples = numpy.fromfile(tmp_path / "hit.f32", "<f4")
        assert len(samples) == 2 * 48000 and numpy.isfinite(samples).all()
        assert abs(samples).max() > 1e-3


@pytest.mark.skipif(shutil.which("sdl2-config") is None, reason="there is no libsdl2-dev")
def test_boxes_that_are_thrown_about_are_heard(prefix, examples, sources, tmp_path):
    sound = tmp_path / "boxes.f32"
    subprocess.run([examples / "boxes", sources / "Resources/Objects/die.modal", "2"], check=True,
                   env={"LD_LIBRARY_PATH": next(prefix.rglob("libidiophone.so")).parent,
                        "SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "disk",
                        "SDL_DISKAUDIOFILE": sound})
    samples = numpy.fromfile(sound, "<f4")
    assert len(samples) > 48000 and numpy.isfinite(samples).all()
    assert abs(samples).max() > 0.01


def test_slides_and_rolls_on_the_library_are_heard_by_both_ears_and_differ(
        examples, sources, tmp_path):
    def slide(kind):
        sound = tmp_path / f"{kind}.f32"
        subprocess.run([examples / "slide", kind, sources / "Resources/Objects/plate.modal", sound],
                       check=True)
        samples = numpy.fromfile(sound, "<f4").reshape(-1, 2)
        assert len(samples) == 3 * 48000
        peak = abs(samples).max()
        assert 0.01 < peak < 20  # pascals
        for second in (0, 1):
            assert abs(samples[48000 * second:][:48000]).max(axis=0).min() > 0.2 * peak
        assert abs(samples[-4800:]).max() < 0.05 * peak
        assert numpy.corrcoef(samples.T)[0, 1] < 0.9999
        power = abs(numpy.fft.rfft(samples[:, 0])) ** 2
        return (power * numpy.fft.rfftfreq(len(samples), 1 / 48000)).sum() / power.sum()
    assert abs(slide("roll") / slide("scrape") - 1) > 0.2


def test_the_desktop_knows_the_standalone(prefix):
    entry = configparser.ConfigParser(interpolation=None)
    entry.optionxform = str
    entry.read(prefix / f"share/applications/{ID}.desktop")
    entry = entry["Desktop Entry"]
    assert (prefix / "bin" / entry["Exec"]).exists()
    assert (prefix / f"share/icons/hicolor/scalable/apps/{entry['Icon']}.svg").exists()
    metainfo = prefix / f"share/metainfo/{ID}.metainfo.xml"
    about = xml.parse(metainfo).getroot()
    assert about.findtext("id") == ID
    version = about.find("releases/release").get("version")
    said = subprocess.run([prefix / "bin/idiophone", "--version"], capture_output=True, text=True)
    assert re.search(r"[\d.]+", said.stdout).group() == version
    if appstream := shutil.which("appstreamcli"):
        subprocess.run([appstream, "validate", "--no-net", metainfo], check=True)
