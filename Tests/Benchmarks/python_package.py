#!/usr/bin/env python3
"""Compares the Python package with the console, and its renders with real time (docs/python.md).

    python_package.py CONSOLE [--rounds N] [--vertices N] [--max-frequency HZ]

Analyses a bowl in child processes, the console's and Python's by turns, from the start of the process to the written
file. Then renders 100 strikes on 100 objects of the factory. Everything runs on one core. Processor times are those of
user and system.
"""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import idiophone

OBJECTS = pathlib.Path(__file__).parents[2] / "Resources/Objects"
RATE, BODIES = 48000, 100
ANALYSE = """
import idiophone, sys
mesh, output, frequency = sys.argv[1:]
idiophone.analyse(idiophone.load_mesh(mesh), max_frequency=float(frequency)).save(output)
"""


def spent(command):
    """Returns the processor and wall seconds of a child process."""
    begin = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"{command[0]} failed")
    return usage.ru_utime + usage.ru_stime, time.monotonic() - begin


def compare_analyses(console, vertices, frequency, rounds):
    with tempfile.TemporaryDirectory() as folder:
        mesh, output = f"{folder}/bowl.obj", f"{folder}/bowl.modal"
        subprocess.run([console, "mesh", "bowl", "--vertices", str(vertices), "-o", mesh], check=True,
                       stdout=subprocess.DEVNULL)
        commands = {"console": [console, "analyse", mesh, "-o", output, "--max-frequency", str(frequency)],
                    "Python": [sys.executable, "-c", ANALYSE, mesh, output, str(frequency)]}
        times = {name: [] for name in commands}
        for turn in range(rounds):
            for name in sorted(commands, reverse=turn % 2 == 1):
                times[name].append(spent(commands[name]))
        print(f"analysis of {len(idiophone.load_mesh(mesh).vertices)} vertices, {rounds} rounds")
    for which, kind in enumerate(("processor", "wall")):
        for word, middle in (("median", statistics.median), ("minimum", min)):
            console_seconds, python_seconds = (middle([each[which] for each in times[name]])
                                               for name in ("console", "Python"))
            print(f"  {kind} time, {word}: console {console_seconds:.2f} s, Python {python_seconds:.2f} s, "
                  f"ratio {python_seconds / console_seconds:.3f}")


def strikes(objects, rounds):
    """Returns `rounds` strikes on each object, spread over ten seconds."""
    return [{"body": body, "impulse": (0, 0, -0.001), "vertex": int(objects[body].shape_vertices[0]),
             "contact_time": 0.0003, "time": 10 * (turn * BODIES + body) / (rounds * BODIES)}
            for turn in range(rounds) for body in range(BODIES)]


def render(objects, impacts):
    return len(idiophone.render(objects, impacts, seconds=10))


def play_world(objects, impacts):
    world = idiophone.World(objects)
    world.listen(position=(0, -2, 1), towards=(0, 0, 0))
    for body in range(BODIES):
        world.place(body, (0.3 * (body % 10) - 1.5, 0.3 * (body // 10), 0))
    for impact in impacts:
        world.strike(**impact)
    return sum(len(world.render(512)) for _ in range(10 * RATE // 512))


def compare_renders(rounds):
    objects = [idiophone.load(path) for path in sorted(OBJECTS.glob("*.modal"))[:BODIES]]
    print(f"10 s of {BODIES} objects with {sum(len(each.eigenvalues) for each in objects)} modes, {rounds} rounds")
    for count in (1, 100):
        impacts = strikes(objects, count)
        for name, act in (("render", render), ("World with a listener", play_world)):
            speeds = []
            for _ in range(rounds):
                begin = time.process_time()
                frames = act(objects, impacts)
                speeds.append(frames / RATE / (time.process_time() - begin))
            print(f"  {len(impacts)} strikes, {name}: {statistics.median(speeds):.0f} times faster than real time")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("console")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--vertices", type=int, default=5000)
    parser.add_argument("--max-frequency", type=float, default=44000)
    arguments = parser.parse_args()
    if hasattr(os, "sched_setaffinity"):  # not on macOS
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})
    compare_renders(arguments.rounds)
    compare_analyses(arguments.console, arguments.vertices, arguments.max_frequency, arguments.rounds)


if __name__ == "__main__":
    main()
