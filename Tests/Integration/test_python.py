"""Tests the Python package."""
import json
import os
import pathlib
import pickle
import shutil
import signal
import subprocess
import sys
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


@pytest.mark.parametrize("name", ["bar.modal", "bar.glb"])
def test_a_saved_object_comes_back(idiophone, bar, tmp_path, name):
    bar.save(tmp_path / name)
    again = idiophone.load(tmp_path / name)
    assert numpy.array_equal(bar.shapes, again.shapes) and again.name == "bar"
    assert numpy.array_equal(bar.eigenvalues, again.eigenvalues)


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
                                   (numpy.eye(3), [[0, 1, 2**40]], "does not exist"),
                                   (numpy.eye(3), [[0, 1, 1.5]], "fraction"),
                                   (numpy.eye(2), [[0, 1, 0]], r"vertices are not \[N,3\]"),
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
                       (lambda: mesh.save(tmp_path / "bar.stl"), "bar.stl"),
                       (lambda: idiophone.fit([(numpy.zeros((9, 2)), RATE, 0.1)]), "recording 0.*one channel"),
                       (lambda: idiophone.fit([(numpy.zeros(9600), 0, 0.1)]), "recording 0.*rate"),
                       (lambda: idiophone.fit([(numpy.zeros(9600), RATE, (0, 1))]), "place is not 3 numbers"),
                       (lambda: idiophone.material_from_recording([0.0] * 9600, RATE), "silent"),
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
        signal.raise_signal(signal.SIGINT)
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
    impulse, point = (0, 0, -0.001), numpy.zeros(3)
    for act, fault in ((lambda: world.strike(1, impulse, point), "no body 1"),
                       (lambda: world.strike(0, (0, 0, numpy.nan), point), "out of range"),
                       (lambda: world.strike(0, (0, -1), point), "impulse is not 3 numbers"),
                       (lambda: world.strike(0, impulse), "point or a vertex"),
                       (lambda: world.strike(0, impulse, point, vertex=0), "point or a vertex"),
                       (lambda: world.strike(0, impulse, vertex=10**6), "vertex"),
                       (lambda: world.place(0, point, (0, 0, 0, 2)), "unit quaternion"),
                       (lambda: world.place(0, numpy.zeros((3, 3))), "position is not 3 numbers"),
                       (lambda: world.listen((0, 0, 0), (0, 1, 0)), "no listener"),
                       (lambda: world.render(2**63), "frames")):
        with pytest.raises(ValueError, match=fault):
            act()
    with pytest.raises(BufferError):
        for _ in range(100):
            world.strike(0, impulse, point)
    assert not world.silent and world.render(64).any()


def test_a_long_render_can_be_interrupted(idiophone, bar):
    world = idiophone.World([bar])

    def interrupt():
        while world.seconds == 0:
            pass
        signal.raise_signal(signal.SIGINT)
    threading.Thread(target=interrupt).start()
    with pytest.raises(KeyboardInterrupt):
        world.render(2**27)


def test_threads_that_render_one_world_share_its_samples(idiophone, bar):
    def struck():
        world = idiophone.World([bar])
        world.strike(0, (0, 0, -0.01), vertex=int(bar.shape_vertices[0]))
        return world

    def render():
        for _ in range(50):
            shares.append((world.render(480).astype(float) ** 2).sum())
    world, shares = struck(), []
    threads = [threading.Thread(target=render) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sum(shares) == pytest.approx((struck().render(100 * 480).astype(float) ** 2).sum(), rel=1e-9)


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


def test_meshes_materials_and_objects_go_to_other_processes(idiophone, bar):
    again = pickle.loads(pickle.dumps(bar))
    assert numpy.array_equal(again.shapes, bar.shapes) and numpy.array_equal(again.decays, bar.decays)
    mesh = idiophone.Mesh(numpy.eye(3), [[0, 1, 2]])
    assert numpy.array_equal(pickle.loads(pickle.dumps(mesh)).vertices, mesh.vertices)
    glass = idiophone.Material("Glass")
    glass.density = 3000
    assert pickle.loads(pickle.dumps(glass)).density == 3000


PROGRAM = """
import idiophone
import numpy as np
version: str = idiophone.__version__
mesh: idiophone.Mesh = idiophone.load_mesh("bell.obj", unit="mm")
bell = idiophone.analyse(mesh, "Brass", progress=lambda done, step: print(f"{done:.0%} {step}"))
samples = idiophone.strike(bell, impulse=(0, 0, -0.02), point=np.zeros(3))[:, 0]
found, words = idiophone.material_from_recording(samples, 48000, mesh=mesh)
world = idiophone.World([bell, (bell, 0.5)])
world.place(1, bell.vertices[0], (0, 0, 0, 1))
world.strike(1, (0, 0, -0.01), point=bell.vertices[0], contact_time=0.0005)
loudest: float = float(world.render(480).max()) + found.density
world.render("all")
"""


def test_type_checkers_find_the_fault_of_a_program(idiophone, tmp_path):
    (tmp_path / "program.py").write_text(PROGRAM)
    site = str(pathlib.Path(idiophone.__file__).parents[1])
    said = subprocess.run([sys.executable, "-m", "mypy", "--strict", "program.py"], cwd=tmp_path,
                          env={**os.environ, "PYTHONPATH": site}, capture_output=True, text=True).stdout
    assert 'expected "int"' in said and "Found 1 error" in said, said


def test_it_works_without_the_metadata_that_debians_package_lacks(idiophone, console, tmp_path):
    for folder in pathlib.Path(idiophone.__file__).parents[1].glob("idiophone*"):
        if not folder.name.endswith(".dist-info"):
            shutil.copytree(folder, tmp_path / folder.name)
    said = subprocess.run([sys.executable, "-c", "import idiophone; print('Idiophone', idiophone.__version__)"],
                          cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(tmp_path)}, check=True,
                          capture_output=True, text=True).stdout
    assert said == subprocess.run([console, "--version"], check=True, capture_output=True, text=True).stdout


@pytest.mark.skipif(sys.platform != "linux", reason="wheels are built for Linux only")
def test_the_wheel_brings_its_library_and_all_licences(idiophone):
    site = pathlib.Path(idiophone.__file__).parents[1]
    (about,) = site.glob("idiophone-*.dist-info")
    assert "manylinux" in (about / "WHEEL").read_text()
    notices = (about / "licenses/THIRD-PARTY").read_text()
    assert "AFFERO" in (about / "licenses/LICENSE").read_text() and "\nnanobind" in notices
    brought = {path.name.split("-")[0] for path in site.glob("idiophone.libs/*")}
    assert brought <= {"libhwy", "libc++", "libc++abi", "libunwind"}  # the last three with the preset clang
    assert "\nHighway" in notices and "\nLLVM 16" in notices


def test_everything_is_documented(idiophone):
    for name in idiophone.__all__:
        named = getattr(idiophone, name)
        assert named.__doc__, name
        members = vars(named).items() if isinstance(named, type) else ()
        for member, value in members:
            assert member.startswith("_") or value.__doc__, f"{name}.{member}"
