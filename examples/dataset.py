#!/usr/bin/env python3
"""Analyses a folder of meshes, each of several materials, on the workers of a Dask cluster.

    dataset.py MESHES -o OUT --materials Steel,Glass --workers 2
    dataset.py MESHES -o OUT --materials Steel,Glass --scheduler tcp://10.0.0.1:8786

OUT/objects gets a .modal file for each mesh and material, OUT/index.parquet a row, also for what
failed. Run the same command again to go on after an interruption: what is done is not done again.
docs/datasets.md describes the columns, Slurm, Kubernetes and the costs.
"""
import argparse
from concurrent.futures import CancelledError
import hashlib
import json
import math
import os
import pathlib
import re
import sys
import time

import dask
import idiophone
import pyarrow
import pyarrow.parquet
from distributed import Client, as_completed
from distributed.scheduler import KilledWorker

FORMATS = (".obj", ".off", ".ply", ".stl", ".gltf", ".glb")
SCHEMA = pyarrow.schema({
    "mesh": "string", "material": "string", "file": "string", "error": "string",
    "vertices": "int32", "faces": "int32", "modes": "int32", "lowest_hz": "float64",
    "lowest_decay_per_s": "float64", "mass_kg": "float64", "method": "string", "notes": "string",
    "bytes": "int64", "seconds": "float64", "version": "string", "parameters": "string", "key": "string"})
PARAMETERS = {"unit": str, "method": str, "thickness": float, "max_frequency": float, "elements": int,
              "radiation": str, "all_around": bool, "largest_part": bool}
SECONDS_BETWEEN_REPORTS = 10

# Each worker runs this as it starts. On a busy machine it may be slow to connect; the scheduler must not be as
# patient, because it would wait for the results of a worker that died. Ctrl-C is for the process that ends them.
PRELOAD = """
import dask, signal
dask.config.set({"distributed.comm.timeouts.connect": "10 minutes"})
signal.signal(signal.SIGINT, signal.SIG_IGN)
"""


def sha256(contents):
    return hashlib.sha256(contents).hexdigest()


def material_of(source):
    """Returns the Material of the library, or of a JSON file."""
    return idiophone.load_material(source) if source.endswith(".json") else idiophone.Material(source)


def find_jobs(folder, materials, parameters):
    """Yields a job, the first columns of its row, for each mesh below the folder and each material.

    `materials` are sources by name. A job's key changes with the contents of mesh and material, the
    parameters and the version. The file's name has the key, so a file that exists is the result.
    """
    own = {name: sha256(pathlib.Path(source).read_bytes())
           for name, source in materials.items() if source.endswith(".json")}
    for path in sorted(folder.rglob("*")):
        if path.suffix.lower() not in FORMATS or not path.is_file():
            continue
        mesh, contents = path.relative_to(folder), sha256(path.read_bytes())
        for name, source in materials.items():
            job = {"mesh": mesh.as_posix(), "material": name, "version": idiophone.__version__,
                   "parameters": json.dumps(parameters, sort_keys=True)}
            inputs = json.dumps([job, contents, own.get(name)], sort_keys=True)
            job["key"] = sha256(inputs.encode())[:16]
            label = re.sub(r"\W+", "-", name)
            job["file"] = (mesh.parent / f"{mesh.stem}.{label}.{job['key']}.modal").as_posix()
            yield job


def work(job, materials, meshes, objects, timeout):
    """Makes the object of a job, unless its file exists, and returns its row. Runs on a worker."""
    started, processor = time.monotonic(), time.thread_time()
    path, row = objects / job["file"], dict(job)

    def check_time(done, step):
        if time.monotonic() - started > timeout:
            raise TimeoutError(f"It was not done after {timeout:g} s; it was at {done:.0%}: {step}.")
    try:
        if path.exists():
            body = idiophone.load(path)
        else:
            parameters = json.loads(job["parameters"])
            mesh = idiophone.load_mesh(meshes / job["mesh"], unit=parameters.pop("unit", None))
            body = idiophone.analyse(mesh, material_of(materials[job["material"]]), threads=1,
                                     name=pathlib.Path(job["mesh"]).stem, progress=check_time, **parameters)
            path.parent.mkdir(parents=True, exist_ok=True)
            body.save(path)  # under another name until it is complete
            row["seconds"] = time.thread_time() - processor
    except Exception as error:
        return {**row, "file": None, "error": str(error) or type(error).__name__}
    return {**row, "vertices": len(body.vertices), "faces": len(body.faces), "modes": len(body.eigenvalues),
            "lowest_hz": float(body.frequencies[0]), "lowest_decay_per_s": float(body.decays[0]),
            "mass_kg": body.mass, "method": body.method, "notes": body.notes, "bytes": path.stat().st_size}


def fault_of_worker(version, folders):
    """Returns why a worker cannot do the work, or None. Runs on a worker."""
    try:
        import idiophone  # not outside: a worker without it would die of the function
    except ImportError as error:
        return str(error)
    if idiophone.__version__ != version:
        return f"it has idiophone {idiophone.__version__} instead of {version}"
    return next((f"it does not see the folder {folder}" for folder in folders if not folder.is_dir()), None)


def read_index(path):
    """Returns the rows of earlier runs by mesh and material."""
    rows = pyarrow.parquet.read_table(path).to_pylist() if path.exists() else []
    return {(row["mesh"], row["material"]): row for row in rows}


def write_index(rows, path):
    beside = path.with_suffix(".part")
    ordered = [rows[name] for name in sorted(rows)]
    pyarrow.parquet.write_table(pyarrow.Table.from_pylist(ordered, SCHEMA), beside)
    os.replace(beside, path)


def is_done(job, row, objects, retry):
    if row is None or row["key"] != job["key"]:
        return False
    return not retry if row["error"] else (objects / row["file"]).exists()


def run(client, jobs, rows, index, **constants):
    """Does the jobs and keeps the index up to date."""
    futures = dict(zip(client.map(work, jobs, pure=False, **constants), jobs))
    done = failed = 0
    started = reported = time.monotonic()
    try:
        for future in as_completed(list(futures)):
            job = futures.pop(future)
            if isinstance(future.exception(), KilledWorker):
                row = {**job, "file": None, "error": "Every worker that tried it died, perhaps out of memory."}
            else:
                row = future.result()
            rows[job["mesh"], job["material"]] = row
            done, failed = done + 1, failed + ("error" in row)
            if time.monotonic() - reported > SECONDS_BETWEEN_REPORTS or not futures:
                reported = time.monotonic()
                minutes = (reported - started) / done * len(futures) / 60
                print(f"{done} of {len(jobs)} done, {failed} failed, about {minutes:.0f} min left", flush=True)
                write_index(rows, index)
    finally:
        write_index(rows, index)


def parse(arguments):
    parser = argparse.ArgumentParser(description="Analyses a folder of meshes on a Dask cluster.")
    parser.add_argument("meshes", type=pathlib.Path, help="folder of " + ", ".join(FORMATS))
    parser.add_argument("-o", "--out", type=pathlib.Path, required=True, help="folder of the results")
    parser.add_argument("--materials", default="Steel", help="names or JSON files, with commas between (Steel)")
    cluster = parser.add_mutually_exclusive_group()
    cluster.add_argument("--workers", type=int, help="processes on this machine (one for each core)")
    cluster.add_argument("--scheduler", metavar="ADDRESS", help="of a cluster that runs already")
    parser.add_argument("--timeout", type=float, default=math.inf, metavar="SECONDS", help="for one object")
    parser.add_argument("--retry", action="store_true", help="try again what failed before")
    of_analysis = parser.add_argument_group("as of idiophone.load_mesh and idiophone.analyse")
    for name, kind in PARAMETERS.items():
        how = {"action": "store_const", "const": True} if kind is bool else {"type": kind}
        of_analysis.add_argument("--" + name.replace("_", "-"), **how)
    options = parser.parse_args(arguments)
    options.parameters = {name: value for name in PARAMETERS if (value := getattr(options, name)) is not None}
    return parser, options


def connect(options):
    """Returns a client of the cluster that runs, or of one on this machine."""
    if options.scheduler:
        print(f"Waiting for the first worker of {options.scheduler}", flush=True)
        return Client(options.scheduler)
    dask.config.set({
        # One object at a time, so that a worker that dies does not put the blame on two.
        "distributed.scheduler.worker-saturation": 1.0,
        "distributed.worker.preload": [PRELOAD]})
    return Client(n_workers=options.workers, threads_per_worker=1, dashboard_address=None)


def main(arguments=None):
    parser, options = parse(arguments)
    meshes, out = options.meshes.resolve(), options.out.resolve()
    objects, index = out / "objects", out / "index.parquet"
    sources = [str(pathlib.Path(source).resolve()) if source.endswith(".json") else source
               for source in options.materials.split(",")]
    try:
        materials = {material_of(source).name: source for source in sources}
    except ValueError as error:
        parser.error(str(error))
    if len(materials) < len(sources):
        parser.error("two materials have the same name")
    jobs = list(find_jobs(meshes, materials, options.parameters))
    if not jobs:
        parser.error(f"there is no mesh in {meshes}")
    objects.mkdir(parents=True, exist_ok=True)
    rows = read_index(index)
    waiting = [job for job in jobs
               if not is_done(job, rows.get((job["mesh"], job["material"])), objects, options.retry)]
    print(f"{len(waiting)} of {len(jobs)} objects to do", flush=True)
    if not waiting:
        return 0
    for left in objects.rglob("*.part"):  # of workers that were killed
        left.unlink()
    try:
        with connect(options) as client:
            if fault := client.submit(fault_of_worker, idiophone.__version__, (meshes, objects)).result():
                sys.exit(f"A worker cannot do the work: {fault}")
            run(client, waiting, rows, index, materials=materials, meshes=meshes, objects=objects,
                timeout=options.timeout)
    except KeyboardInterrupt:
        print("Interrupted. The same command goes on from here.")
        return 130
    except (OSError, CancelledError) as error:
        print(f"The cluster or a disk failed: {error}. The same command goes on from here.")
        return 1
    print(f"{index} has {len(rows)} rows")
    return 0


if __name__ == "__main__":
    sys.exit(main())
