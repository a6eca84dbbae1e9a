#!/usr/bin/env python3
"""Compares our eigensolver with SciPy's on the same matrices, for the same modes, on one thread.

    eigensolver.py PROGRAM [--case MODEL:ROWS:MODES]... [--repetitions N] [--folder F] [--json FILE]

PROGRAM is the built eigensolver_benchmark. Both solve each case in turn, each time in a new
process. Ours runs solveModes for the band that holds MODES modes (zero modes included). SciPy runs
scipy.sparse.linalg.eigsh(K, k, M, sigma=-(2 pi 20 Hz)^2) with defaults. The minima of processor
time, wall time and memory count. Memory is the peak minus the amount before the process read the
matrices. Fails if an eigenvalue differs by more than 1e-6.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

LOWEST_HZ = 20
TOLERANCE = 1e-6
DEFAULT_CASES = ["shell:3000:300", "tetrahedra:3000:300", "shell:13000:300", "tetrahedra:13000:300",
                 "shell:13000:50", "tetrahedra:13000:50"]
ONE_THREAD = {**os.environ, **dict.fromkeys(
    ["OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"], "1")}


def read_matrix(folder, name):
    import numpy as np
    from scipy import sparse
    starts = np.fromfile(folder / f"{name}.starts", np.int32)
    rows = np.fromfile(folder / f"{name}.rows", np.int32)
    values = np.fromfile(folder / f"{name}.values", np.float64)
    size = len(starts) - 1
    lower = sparse.csc_matrix((values, rows, starts), shape=(size, size))
    return (lower + sparse.tril(lower, -1).T).tocsc()


def peak_megabytes():
    import resource
    unit = 2**20 if sys.platform == "darwin" else 2**10
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / unit


def solve_with_scipy(folder, modes):
    """Solves in a process of its own and prints the same line as the C++ program's `solve`."""
    import numpy as np
    from scipy.sparse.linalg import eigsh
    at_start = peak_megabytes()
    stiffness, mass = read_matrix(folder, "stiffness"), read_matrix(folder, "mass")
    wall, processor = time.perf_counter(), time.process_time()
    eigenvalues, _ = eigsh(stiffness, modes, mass, sigma=-(2 * np.pi * LOWEST_HZ) ** 2)
    wall, processor = time.perf_counter() - wall, time.process_time() - processor
    np.sort(eigenvalues).tofile(folder / "scipy.f64")
    print(json.dumps({"rows": stiffness.shape[0], "modes": modes, "wall_s": wall,
                      "processor_s": processor, "megabytes": peak_megabytes() - at_start}))


def run(command):
    done = subprocess.run(command, capture_output=True, text=True, env=ONE_THREAD)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: {done.stderr.strip()}")
    return done.stdout


def largest_difference(folder, zero_modes):
    """Returns the largest relative difference of eigenvalues; infinite if their numbers differ."""
    import numpy as np
    ours = np.fromfile(folder / "eigenvalues.f64")
    theirs = np.fromfile(folder / "scipy.f64")[zero_modes:]
    return float(np.max(np.abs(ours / theirs - 1))) if len(ours) == len(theirs) else float("inf")


def measure(program, case, repetitions, folder):
    model, rows, modes = case.split(":")
    folder = folder / case.replace(":", "-")
    run([program, "write", model, rows, modes, folder])
    ours, theirs = [], []
    for _ in range(repetitions):
        ours.append(json.loads(run([program, "solve", folder])))
        theirs.append(json.loads(run([sys.executable, __file__, "--scipy", folder, modes])))
    least = {name: [min(one[name] for one in runs) for runs in (ours, theirs)]
             for name in ("wall_s", "processor_s", "megabytes")}
    return {"case": case, "rows": ours[0]["rows"], "modes": int(modes),
            "ours": {name: pair[0] for name, pair in least.items()},
            "scipy": {name: pair[1] for name, pair in least.items()},
            "ratios": {name: pair[0] / pair[1] for name, pair in least.items()},
            "largest_difference": largest_difference(folder, ours[0]["zero_modes"])}


def row(result):
    both = [f"{result['ours'][name]:.3g} / {result['scipy'][name]:.3g} = "
            f"{result['ratios'][name]:.2f}" for name in ("wall_s", "processor_s", "megabytes")]
    model = result["case"].split(":")[0]
    return (f"| {model} | {result['rows']:,} | {result['modes']} | " + " | ".join(both)
            + f" | {result['largest_difference']:.1e} |")


def main():
    if len(sys.argv) == 4 and sys.argv[1] == "--scipy":
        return solve_with_scipy(pathlib.Path(sys.argv[2]), int(sys.argv[3]))
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--case", action="append", metavar="MODEL:ROWS:MODES")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--folder", type=pathlib.Path)
    parser.add_argument("--json", type=pathlib.Path)
    chosen = parser.parse_args()
    results = []
    with tempfile.TemporaryDirectory() as scratch:
        folder = chosen.folder or pathlib.Path(scratch)
        print("| model | n | k | wall, s | processor, s | memory, MB | eigenvalues differ by |\n"
              "|---|---|---|---|---|---|---|")
        for case in chosen.case or DEFAULT_CASES:
            results.append(measure(chosen.program.resolve(), case, chosen.repetitions, folder))
            print(row(results[-1]), flush=True)
    document = json.dumps({"results": results}, indent=1)
    if chosen.json:
        chosen.json.write_text(document + "\n")
    else:
        print(document)
    wrong = [one["case"] for one in results if not one["largest_difference"] <= TOLERANCE]
    return f"Eigenvalues differ by more than {TOLERANCE}: {', '.join(wrong)}" if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
