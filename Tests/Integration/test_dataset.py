"""Tests examples/dataset.py on a Dask cluster of two worker processes."""
import os
import re
import signal
import subprocess
import sys

import dask
import distributed.comm
import pyarrow.parquet
import pytest

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the workers are killed by POSIX signals")

QUICK = ["--materials", "Glass,Bell bronze", "--elements", "100", "--radiation", "none", "--max-frequency", "20000"]

# Runs in each worker as it starts, perhaps twice. A mesh "killer" kills each worker that tries it. The first worker
# that has analysed "victim" dies as it has written the beginning of the file.
DEADLY = """
import idiophone, os, pathlib, resource, signal
signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
idiophone.healthy = getattr(idiophone, "healthy", idiophone.analyse)

def deadly(*arguments, name, **options):
    if name == "killer":
        os.kill(os.getpid(), signal.SIGKILL)
    body = idiophone.healthy(*arguments, name=name, **options)
    if name == "victim":
        try:
            pathlib.Path({marker!r}).touch(exist_ok=False)
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, resource.RLIM_INFINITY))
        except FileExistsError:
            pass
    return body
idiophone.analyse = deadly
"""


@pytest.fixture(scope="module")
def dataset(idiophone, sources):
    sys.path.insert(0, str(sources / "examples"))
    import dataset as module
    return module


@pytest.fixture(scope="module")
def cluster(dataset, tmp_path_factory):
    marker = tmp_path_factory.mktemp("marker") / "died"
    with dask.config.set({"distributed.scheduler.allowed-failures": 1,
                          "distributed.scheduler.worker-saturation": 1.0,
                          "distributed.worker.preload": [dataset.PRELOAD + DEADLY.format(marker=str(marker))]}):
        with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as started:
            yield started.scheduler_address


@pytest.fixture
def folder(idiophone, tmp_path):
    """A folder of four boxes, one of them in a folder of its own."""
    faces = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6],
             [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]
    meshes = tmp_path / "meshes"
    (meshes / "more").mkdir(parents=True)
    for number, name in enumerate(("bar.obj", "bar.ply", "more/bar.obj", "victim.ply")):
        length = 0.2 + 0.02 * number
        corners = [[x, y, z] for x in (0, length) for y in (0, 0.03) for z in (0, 0.01)]
        idiophone.Mesh(corners, faces).save(meshes / name)
    return tmp_path


@pytest.fixture
def run(dataset, cluster, folder, capfd):
    """Returns a function that runs dataset.py in the folder and returns how many objects it had to do."""
    def act(*options, expected=0):
        code = dataset.main([str(folder / "meshes"), "-o", str(folder / "out"), "--scheduler", cluster,
                             *QUICK, *options])
        assert code == expected
        return int(capfd.readouterr().out.split(" of ")[0])
    return act


def index_of(folder):
    return pyarrow.parquet.read_table(folder / "out/index.parquet").to_pylist()


def files_of(folder):
    """Returns when each object was written."""
    objects = folder / "out/objects"
    return {path.relative_to(objects).as_posix(): path.stat().st_mtime_ns for path in objects.rglob("*.modal")}


def check_index(idiophone, folder, rows, failures=0):
    """Checks that the index has so many rows and failures, and that its rows agree with the files."""
    index = index_of(folder)
    assert len(index) == len({(row["mesh"], row["material"]) for row in index}) == rows
    good = [row for row in index if not row["error"]]
    assert len(good) == rows - failures
    assert {row["file"] for row in good} <= set(files_of(folder))
    for row in good:
        path = folder / "out/objects" / row["file"]
        body = idiophone.load(path)
        assert (row["vertices"], row["faces"], row["modes"]) == (
            len(body.vertices), len(body.faces), len(body.frequencies))
        assert (row["lowest_hz"], row["lowest_decay_per_s"]) == (body.frequencies[0], body.decays[0])
        assert (row["mass_kg"], row["material"]) == (body.mass, body.material.name)
        assert row["bytes"] == path.stat().st_size and row["version"] == idiophone.__version__
    return index


def test_killed_workers_and_broken_meshes_lose_nothing(idiophone, folder, run):
    meshes, out = folder / "meshes", folder / "out"
    (meshes / "broken.obj").write_text("v 0 0 0\nf 1 2 3\n")
    (meshes / "killer.obj").write_bytes((meshes / "bar.obj").read_bytes())
    assert run() == 12
    index = check_index(idiophone, folder, 12, failures=4)
    errors = {(row["mesh"], row["error"]) for row in index if row["error"]}
    assert {mesh for mesh, _ in errors} == {"broken.obj", "killer.obj"}
    assert all(("died" in error) == (mesh == "killer.obj") for mesh, error in errors)
    assert len(files_of(folder)) == 8
    halves = list(out.rglob("*.part"))
    assert halves and all(half.stat().st_size <= 1000 for half in halves)

    before = files_of(folder)
    assert run() == 0
    assert files_of(folder) == before
    (meshes / "killer.obj").unlink()
    assert run("--retry") == 2  # the broken mesh, of two materials
    assert files_of(folder) == before
    assert not list(out.rglob("*.part"))


def test_only_what_changed_is_done_again(idiophone, folder, run):
    assert run() == 8
    before = files_of(folder)
    (folder / "meshes/bar.obj").write_bytes((folder / "meshes/more/bar.obj").read_bytes())
    assert run() == 2
    assert before.items() < files_of(folder).items()
    assert run("--max-frequency", "15000") == 8
    assert {row["parameters"].count('"max_frequency": 15000') for row in check_index(idiophone, folder, 8)} == {1}
    before = files_of(folder)
    lost = next(row["file"] for row in index_of(folder))
    (folder / "out/objects" / lost).unlink()
    assert run("--max-frequency", "15000") == 1
    assert {file for file, time in files_of(folder).items() if before[file] != time} == {lost}
    glass = idiophone.Material("Glass")
    for density in (2000, 3000):
        glass.name, glass.density = "My glass", density
        glass.save(folder / "own.json")
        assert run("--materials", str(folder / "own.json")) == 4
        check_index(idiophone, folder, 12)  # the other materials stay in it


def test_a_lost_index_is_made_of_the_files(idiophone, folder, run):
    run()
    before, index = files_of(folder), index_of(folder)
    assert all(row["seconds"] > 0 for row in index)
    (folder / "out/index.parquet").unlink()
    assert run() == 8
    assert files_of(folder) == before
    assert check_index(idiophone, folder, 8) == [{**row, "seconds": None} for row in index]


def interrupt():
    os.kill(os.getpid(), signal.SIGINT)


def lose_the_cluster():
    raise distributed.comm.CommClosedError("the stream is closed")


@pytest.mark.parametrize("end, code", [(interrupt, 130), (lose_the_cluster, 1)])
def test_what_is_done_is_kept_at_an_early_end(idiophone, folder, run, dataset, monkeypatch, end, code):
    def ended(futures):
        for count, future in enumerate(distributed.as_completed(futures)):
            if count == 3:
                end()
            yield future
    with monkeypatch.context() as patched:
        patched.setattr(dataset, "as_completed", ended)
        assert run(expected=code) == 8
    check_index(idiophone, folder, 3)
    assert run() == 5
    check_index(idiophone, folder, 8)


def test_a_worker_is_checked_before_it_works(idiophone, dataset, tmp_path):
    assert dataset.fault_of_worker(idiophone.__version__, (tmp_path,)) is None
    assert "instead of 0.0.0" in dataset.fault_of_worker("0.0.0", (tmp_path,))
    assert "does not see" in dataset.fault_of_worker(idiophone.__version__, (tmp_path, tmp_path / "none"))


def test_a_timeout_is_recorded_and_may_be_tried_again(idiophone, folder, run):
    run("--timeout", "0")
    assert {row["error"].startswith("It was not done after 0 s") for row in index_of(folder)} == {True}
    assert not files_of(folder)
    assert run() == 0
    assert run("--retry") == 8
    assert len(files_of(folder)) == 8
    check_index(idiophone, folder, 8)


def test_faults_in_the_command_end_it_with_a_sentence(dataset, folder, capfd):
    for options, fault in ((["--materials", "Unobtainium"], "no material 'Unobtainium'"),
                           (["--materials", "Glass,glass"], "the same name"),
                           (["--workers", "2", "--scheduler", "tcp://x"], "not allowed")):
        with pytest.raises(SystemExit, match="2"):
            dataset.main([str(folder / "meshes"), "-o", str(folder / "out"), *options])
        assert fault in capfd.readouterr().err
    with pytest.raises(SystemExit, match="2"):
        dataset.main([str(folder / "out"), "-o", str(folder / "out")])
    assert "no mesh in" in capfd.readouterr().err


def test_its_speed_is_measured_with_workers_of_its_own(idiophone, sources):
    site = os.path.dirname(os.path.dirname(idiophone.__file__))
    program = sources / "Tests/Benchmarks/dataset_speed.py"
    told = subprocess.run([sys.executable, program, "--meshes", "2", "--rounds", "1"],
                          capture_output=True, text=True, env={**os.environ, "PYTHONPATH": site})
    assert told.returncode == 0, told.stderr
    assert re.findall(r"^(\d) workers", told.stdout, re.MULTILINE) == ["1", "2"]
    assert re.search(r"two workers over one: \d", told.stdout)
