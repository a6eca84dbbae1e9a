#!/usr/bin/env python3
"""Measures examples/dataset.py: how much faster two workers are than one, and what objects cost.

    dataset_speed.py [--meshes 500] [--rounds 2]

One worker and two analyse the meshes in turn. The ratio is that of the shortest times of the whole
command, from its start to its end. The meshes are glass bars of 20 to 30 cm, taken as 400 elements
up to 8 kHz. Needs the packages that examples/dataset.py needs, and two cores that are free.
"""
import argparse
import pathlib
import subprocess
import sys
import tempfile
import time

import idiophone
import pyarrow.compute
import pyarrow.parquet

PROGRAM = pathlib.Path(__file__).resolve().parents[2] / "examples/dataset.py"
FACES = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6],
         [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]


def make_meshes(folder, count):
    folder.mkdir()
    for number in range(count):
        length = 0.2 + 0.1 * number / count
        corners = [[x, y, z] for x in (0, length) for y in (0, 0.03) for z in (0, 0.01)]
        idiophone.Mesh(corners, FACES).save(folder / f"bar{number:04}.ply")


def measure(meshes, workers):
    """Returns the seconds of the command, and the sums of the processor seconds and bytes of its objects."""
    with tempfile.TemporaryDirectory() as out:
        started = time.perf_counter()
        subprocess.run([sys.executable, PROGRAM, meshes, "-o", out, "--materials", "Glass", "--elements", "400",
                        "--max-frequency", "8000", "--workers", str(workers)],
                       check=True, stdout=subprocess.DEVNULL)
        seconds = time.perf_counter() - started
        index = pyarrow.parquet.read_table(pathlib.Path(out) / "index.parquet")
        if index["error"].null_count < len(index):
            sys.exit(f"An analysis failed: {index['error'].drop_null()[0]}")
        return seconds, *(pyarrow.compute.sum(index[column]).as_py() for column in ("seconds", "bytes"))


def main():
    parser = argparse.ArgumentParser(description="Measures examples/dataset.py with one worker and with two.")
    parser.add_argument("--meshes", type=int, default=500)
    parser.add_argument("--rounds", type=int, default=2)
    options = parser.parse_args()
    shortest = {}
    with tempfile.TemporaryDirectory() as folder:
        meshes = pathlib.Path(folder) / "meshes"
        make_meshes(meshes, options.meshes)
        for _ in range(options.rounds):
            for workers in (1, 2):
                figures = measure(meshes, workers)
                print(f"{workers} workers: {figures[0]:.1f} s, of which analysis {figures[1]:.1f} s of processor time",
                      flush=True)
                shortest[workers] = min(shortest.get(workers, figures), figures)
    _, processor, size = shortest[1]
    print(f"two workers over one: {shortest[1][0] / shortest[2][0]:.2f}\n"
          f"1,000 objects: {processor / options.meshes / 3.6:.2f} hours of one core, "
          f"{size / options.meshes / 1000:.1f} MB")


if __name__ == "__main__":
    main()
