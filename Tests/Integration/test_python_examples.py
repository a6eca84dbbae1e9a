"""Tests the examples of the Python package, the notebooks and the game, and the script of its figures."""
import base64
import importlib.util
import io
import os
import pathlib
import re
import subprocess
import sys

import nbclient
import nbformat
import numpy
import pytest
import soundfile

EXAMPLES = pathlib.Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def environment(idiophone, tmp_path_factory):
    """The environment of a program that imports the package."""
    return {**os.environ, "PYTHONPATH": str(pathlib.Path(idiophone.__file__).parents[1]),
            "IPYTHONDIR": str(tmp_path_factory.mktemp("ipython"))}


@pytest.mark.parametrize("notebook", sorted(path.stem for path in EXAMPLES.glob("*.ipynb")))
def test_a_notebook_is_stored_without_outputs_and_shows_plots_and_sounds(notebook, environment, tmp_path):
    book = nbformat.read(EXAMPLES / f"{notebook}.ipynb", as_version=4)
    cells = [cell for cell in book.cells if cell.cell_type == "code"]
    assert not any(cell.outputs or cell.execution_count for cell in cells)
    nbclient.NotebookClient(book, kernel_name="python3").execute(cwd=tmp_path, env=environment)
    shown = [output.data for cell in cells for output in cell.outputs if "data" in output]
    assert any("image/png" in data for data in shown)
    sounds = re.findall(r"data:audio/wav;base64,([^\"]*)", "".join(data.get("text/html", "") for data in shown))
    assert sounds
    for sound in sounds:
        samples, rate = soundfile.read(io.BytesIO(base64.b64decode(sound)))
        assert rate == 48000 and abs(samples).max() > 0.1


@pytest.mark.skipif(sys.platform == "win32", reason="processor times are those of POSIX")
def test_the_figures_compare_with_the_console_and_with_real_time(environment, sources, console):
    """Does not check times, because they depend on the machine."""
    told = subprocess.run([sys.executable, sources / "Tests/Benchmarks/python_package.py", console, "--rounds", "1",
                           "--vertices", "30", "--max-frequency", "1000"],
                          check=True, env=environment, capture_output=True, text=True).stdout
    figures = re.findall(r"(?:ratio |: )([\d.]+)(?: times faster than real time)?$", told, re.MULTILINE)
    assert len(figures) == 8 and min(map(float, figures)) > 0


def test_boxes_that_are_thrown_about_are_heard(environment, sources, tmp_path):
    sound = tmp_path / "boxes.f32"
    subprocess.run([sys.executable, EXAMPLES / "boxes.py", sources / "Resources/Objects/clave.modal", "1"],
                   check=True, env={**environment, "SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "disk",
                                    "SDL_DISKAUDIOFILE": str(sound)})
    samples = numpy.fromfile(sound, "<f4")
    assert len(samples) > 48000 and numpy.isfinite(samples).all()
    assert abs(samples).max() > 0.01


def test_boxes_fall_to_the_ground_and_rest_there_in_silence(idiophone):
    specification = importlib.util.spec_from_file_location("boxes", EXAMPLES / "boxes.py")
    game = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(game)

    class Recorder:
        hits = []

        def strike(self, body, impulse, point, contact_time):
            self.hits.append((impulse, point))
    space, boxes = game.make_space(half_width=0.1, half_height=0.012, mass=0.1)
    game.report_impacts(space, boxes, Recorder(), half_depth=0.0125)
    for _ in range(5 * 240):
        space.step(game.STEP_SECONDS)
    impulse, point = Recorder.hits[0]
    assert impulse[2] > 0.1 and abs(point[2]) < 0.01  # the ground pushes the first box upwards
    total = len(Recorder.hits)
    for _ in range(240):
        space.step(game.STEP_SECONDS)
    assert len(Recorder.hits) == total
