"""Tests the Python package."""
import json
import os
import signal
import subprocess
import threading

import numpy
import pytest
import soundfile

RATE = 48000


@pytest.fixture(scope="session")
def bar_file(console, tmp_path_factory):
    path = tmp_path_factory.mktemp("bar") / "bar.obj"
    subprocess.run([console, "mesh", "bar", "-o", path], check=True, capture_output=True)
    return path


@pytest.fixture(scope="session")
def bar(idiophone, bar_file):
    return idiophone.analyse(idiophone.load_mesh(bar_file), "Glass", name="bar", max_frequency=22000)


def test_it_analyses_as_the_console_does(idiophone, bar, bar_file, console, tmp_path):
    path = tmp_path / "bar.modal"
    subprocess.run([console, "analyse", bar_file, "-o", path, "--material", "Glass",
                    "--max-frequency", "22000"], check=True, capture_output=True)
    other = idiophone.load(path)
    assert len(bar.eigenvalues) > 20
    for name in ("eigenvalues", "shapes", "shape_vertices", "vertices", "faces", "decays",
                 "frequencies"):
        assert numpy.array_equal(getattr(bar, name), getattr(other, name)), name
    assert bar.mass == other.mass and bar.material.name == "Glass"


def test_a_saved_object_comes_back(idiophone, bar, tmp_path):
    bar.save(tmp_path / "bar.modal")
    again = idiophone.load(tmp_path / "bar.modal")
    assert numpy.array_equal(bar.shapes, again.shapes) and again.name == "bar"


def test_impacts_sound_bit_for_bit_as_in_the_console(idiophone, bar, console, tmp_path):
    bar.save(tmp_path / "bar.modal")
    impacts = [{"time": 0.1 * k, "impulse": [0, 0.001 * k, -0.01], "vertex": int(bar.shape_vertices[7 * k]),
                "contact_time": 0.0003 * k} for k in range(5)]
    impacts.append({"time": 0.33, "point": [0.02, 0.004, 0.1], "impulse": [0, 0, -0.004]})
    lines = [json.dumps({"object": "bar.modal", **impact}) for impact in impacts]
    (tmp_path / "hits.jsonl").write_text("\n".join(lines))
    subprocess.run([console, "render", "--impulses", "hits.jsonl", "-o", "hits.wav", "--seconds", "1",
                    "--set", "limiter=0"], check=True, capture_output=True, cwd=tmp_path)
    heard = soundfile.read(tmp_path / "hits.wav", dtype="float32", always_2d=True)[0]
    sound = idiophone.render([bar], [{"body": 0, **impact} for impact in impacts], seconds=1)
    assert sound.shape == (RATE, 2) and abs(sound).max() > 1e-3
    assert numpy.array_equal(sound, heard)


def test_a_strike_rings_at_the_objects_frequencies(idiophone, bar):
    sound = idiophone.strike(bar)[:, 0]
    spectrum = abs(numpy.fft.rfft(sound))
    strongest = numpy.fft.rfftfreq(len(sound), 1 / RATE)[spectrum.argmax()]
    assert abs(bar.frequencies - strongest).min() < 5
    assert abs(sound[-10:]).max() < 1e-4 * abs(sound).max()


def test_arrays_are_views_that_outlive_their_object(idiophone, bar, tmp_path):
    bar.save(tmp_path / "bar.modal")
    shapes = idiophone.load(tmp_path / "bar.modal").shapes
    assert shapes.dtype == numpy.float32 and shapes.shape[1:] == (len(bar.eigenvalues), 3)
    assert not shapes.flags.writeable and not shapes.flags.owndata
    assert numpy.array_equal(shapes, bar.shapes)


def test_meshes_are_made_of_arrays(idiophone):
    mesh = idiophone.Mesh(numpy.eye(3), [[0, 1, 2]])
    assert mesh.vertices.shape == (3, 3) and mesh.faces.tolist() == [[0, 1, 2]]
    for vertices, faces, fault in ((numpy.eye(3), [[0, 1, 3]], "does not exist"),
                                   (numpy.full((3, 3), numpy.nan), [[0, 1, 2]], "not finite"),
                                   (numpy.eye(3), numpy.zeros((0, 3)), "no faces")):
        with pytest.raises(ValueError, match=fault):
            idiophone.Mesh(vertices, faces)


def test_a_fault_is_one_sentence(idiophone, bar_file, tmp_path):
    mesh = idiophone.load_mesh(bar_file)
    for act, fault in ((lambda: idiophone.load(tmp_path / "none.modal"), "none.modal"),
                       (lambda: idiophone.load_mesh(tmp_path / "none.obj"), "none.obj"),
                       (lambda: idiophone.load_mesh(bar_file, unit="furlong"), "furlong"),
                       (lambda: idiophone.Material("Unobtainium"), "Unobtainium"),
                       (lambda: idiophone.analyse(mesh, "Unobtainium"), "Unobtainium"),
                       (lambda: idiophone.analyse(mesh, method="guess"), "method"),
                       (lambda: idiophone.analyse(mesh, clamps=["w<0"]), "w<0"),
                       (lambda: idiophone.World([]), "no body")):
        with pytest.raises(ValueError, match=fault):
            act()


def test_a_material_may_be_changed_and_saved(idiophone, tmp_path):
    glass = idiophone.Material("glass")
    assert glass.name == "Glass" and "Glass" in idiophone.materials()
    glass.density, glass.name = 3000, "Heavy glass"
    glass.save(tmp_path / "heavy.json")
    assert idiophone.load_material(tmp_path / "heavy.json").density == 3000
    glass.density = -1
    with pytest.raises(ValueError):
        glass.save(tmp_path / "worse.json")


def test_progress_ends_the_work_with_its_exception(idiophone, bar_file):
    mesh, seen = idiophone.load_mesh(bar_file), []

    def stop(done, step):
        seen.append((done, step))
        if done > 0.1:
            raise KeyError("enough")
    with pytest.raises(KeyError, match="enough"):
        idiophone.analyse(mesh, progress=stop)
    assert 0 <= seen[0][0] <= seen[-1][0] < 1 and seen[0][1]


def test_an_interrupt_ends_the_work(idiophone, bar_file):
    mesh = idiophone.load_mesh(bar_file)

    def interrupt(done, step):
        os.kill(os.getpid(), signal.SIGINT)
    with pytest.raises(KeyboardInterrupt):
        idiophone.analyse(mesh, progress=interrupt)


def test_other_threads_run_meanwhile(idiophone, bar_file):
    mesh, counted, done = idiophone.load_mesh(bar_file), [0], threading.Event()

    def count():
        while not done.is_set():
            counted[0] += 1
    thread = threading.Thread(target=count)
    thread.start()
    at_steps = []
    idiophone.analyse(mesh, max_frequency=15000, progress=lambda *_: at_steps.append(counted[0]))
    done.set()
    thread.join()
    assert at_steps[-1] > at_steps[0]


def test_a_world_is_heard_from_where_the_listener_is(idiophone, bar):
    def energies(place):
        world = idiophone.World([bar, (bar, 0.5)])
        world.listen((0, 0, 0), (0, 1, 0))
        world.place(1, place)
        world.render(RATE // 5)  # arrive there
        world.strike(1, (0, 0, -0.01), point=place, contact_time=0.0002)
        return (world.render(RATE // 4).astype(float) ** 2).sum(axis=0)
    left, right, far = energies((-1, 0, 0)), energies((1, 0, 0)), energies((-4, 0, 0))
    assert left[0] > 1.2 * left[1] and right[1] > 1.2 * right[0]
    assert left.sum() > 8 * far.sum()


def test_a_world_says_what_it_cannot_do(idiophone, bar):
    world = idiophone.World([bar], listener=False, events=16)
    with pytest.raises(ValueError):
        world.strike(1, (0, 0, -1))
    with pytest.raises(ValueError):
        world.strike(0, (0, 0, numpy.nan))
    with pytest.raises(ValueError):
        world.listen((0, 0, 0), (0, 1, 0))
    with pytest.raises(BufferError):
        for _ in range(100):
            world.strike(0, (0, 0, -0.001))
    assert not world.silent and world.render(64).any()


def test_touches_sound_until_they_end(idiophone, bar):
    world = idiophone.World([bar])
    touch = world.begin_touch()
    world.touch(touch, 0, (0, 0, 0), force=5, slide=(0.5, 0, 0))
    assert world.render(RATE // 10).any()
    world.end_touch(touch)
    with pytest.raises(ValueError):
        world.touch(touch, 0, (0, 0, 0), force=5)
    world.set_damping(0, 500)
    world.render(RATE)
    assert world.silent


def test_materials_and_objects_come_from_recordings(idiophone, bar):
    low, high = bar.vertices.min(axis=0), bar.vertices.max(axis=0)
    corner = tuple(high)
    recording = numpy.ascontiguousarray(
        idiophone.strike(bar, point=corner, contact_time=0.0002, seconds=2)[:, 0])
    recording = numpy.concatenate([numpy.zeros(4800, numpy.float32), recording / abs(recording).max() / 2])
    mesh = idiophone.Mesh(bar.vertices.astype(float), bar.faces)
    found, words = idiophone.material_from_recording(recording, RATE, name="Found", mesh=mesh)
    assert found.name == "Found" and words
    speed = found.youngs_modulus / found.density
    assert abs(speed / (bar.material.youngs_modulus / bar.material.density) - 1) < 0.03
    fitted = idiophone.fit([(recording, RATE, tuple(map(float, corner)))], mass=0.2)
    assert abs(fitted.frequencies[0] / bar.frequencies[0] - 1) < 0.002


def test_it_is_typed_and_documented(idiophone):
    folder = os.path.dirname(idiophone.__file__)
    with open(os.path.join(folder, "_core.pyi"), encoding="utf-8") as file:
        assert "def analyse(" in file.read()
    assert os.path.exists(os.path.join(folder, "py.typed"))
    for name in idiophone.__all__:
        assert getattr(idiophone, name).__doc__, name
