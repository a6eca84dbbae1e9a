#!/usr/bin/env python3
"""Runs long searches for faults: each fuzz target for SOAK_SECONDS (default: an hour), and a day of
random music, or the same fraction of a day.

build/soak keeps results between calls: log.tsv with a line for each run, the inputs that each
target has found, and the inputs that failed. A run is cut into slices, so that a call that ends
early loses minutes at most. The next call continues where this one stopped. When every program has
had its time, it begins another round.

    soak.py [PROGRAM...]    all programs, or only those named ("music", "preset", "mesh_ply")

A run of a fuzz target is one input; a run of the music is one hour of it. Seconds are processor
time, so that other work on the machine does not count.
"""
import datetime
import os
import pathlib
import re
import resource
import signal
import subprocess
import sys
import typing

ROOT = pathlib.Path(__file__).resolve().parents[2]
KEPT = pathlib.Path(os.environ.get("SOAK_FOLDER", ROOT / "build/soak"))
BUILT = ROOT / "build/fuzz/Tests/Fuzz"
MUSIC = ROOT / "build/release/Tests/Soak/soak_music"

class Run(typing.NamedTuple):
    """The result of one slice of a program."""

    seconds: int  # processor time, at least 1
    runs: int
    finding: str  # path of a file, or ""


class Total(typing.NamedTuple):
    """The sums of all runs of a program in the log."""

    seconds: int
    runs: int
    findings: list  # files that still exist


class FuzzTarget:
    """A libFuzzer program of Tests/Fuzz, built in the preset `fuzz`. Its rounds are counted in
    seconds.

    One slice of three tries inputs of up to `longest` bytes, more than the readers of presets,
    materials, tunings and scenes allow. In the others libFuzzer chooses the length: at most 4096
    bytes unless a seed is longer."""

    unit = "seconds"
    interrupted = 72  # libFuzzer's exit code
    slice_length = 300
    longest = {"body": 1 << 12, "mesh_repair": 1 << 12, "player_midi": 1 << 14,
               "scene": (1 << 22) + (1 << 16), "state": 1 << 16}
    longest_file = (1 << 20) + (1 << 16)

    def __init__(self, program):
        self.program = program
        self.name = program.name.removeprefix("fuzz_")

    def length_options(self, before):
        if before // self.slice_length % 3 != 2:
            return []
        return [f"-max_len={self.longest.get(self.name, self.longest_file)}", "-len_control=0"]

    @staticmethod
    def round_length(seconds):
        return seconds

    def run(self, seconds, before):
        """Tries inputs after `before` seconds in earlier slices and calls, and returns a Run. Its
        finding is the input that failed, or the output that says why nothing ran."""
        grown, findings = KEPT / "corpus" / self.name, KEPT / "findings"
        for folder in (grown, findings):
            folder.mkdir(parents=True, exist_ok=True)
        dictionary = ROOT / f"Tests/Fuzz/dictionaries/{self.name}.dict"
        output = KEPT / f"{self.name}.txt"
        with output.open("wb") as file:
            # The program gets its own session, so that only this script gets a stop signal, and
            # passes it on.
            process = subprocess.Popen(
                [self.program, f"-max_total_time={seconds}", "-timeout=20", "-rss_limit_mb=2048",
                 "-print_final_stats=1", f"-artifact_prefix={findings}/{self.name}-",
                 *self.length_options(before),
                 *([f"-dict={dictionary}"] if dictionary.exists() else []),
                 grown, ROOT / f"Tests/Fuzz/corpus/{self.name}"],
                stdout=file, stderr=file, start_new_session=True)
            code, used = wait(process)
        said = output.read_text(errors="replace")
        runs = re.search(r"number_of_executed_units: (\d+)", said)
        written = re.search(r"Test unit written to (.*)", said)
        finding = ""
        if code not in (0, self.interrupted):
            finding = written.group(1) if written else keep(output)
        return Run(used, int(runs.group(1)) if runs else 0, finding)


class Music:
    """Hours of music in one processor; after each hour everything must be as before. Rounds and
    runs are counted in these hours."""

    unit = "runs"
    name = "music"
    hours_of_day = 24
    slice_length = hours_of_day  # tests a long session in one process

    @classmethod
    def round_length(cls, seconds):
        return max(1, round(cls.hours_of_day * seconds / 3600))

    def run(self, wanted, before):
        """Plays up to `wanted` hours and returns a Run. Its finding is the output of a failure."""
        KEPT.mkdir(parents=True, exist_ok=True)
        hours, output = KEPT / "music.hours", KEPT / "music.txt"
        logged = len(hours.read_text().splitlines()) if hours.exists() else 0
        with output.open("wb") as file:
            code, used = wait(subprocess.Popen([MUSIC, hours, str(wanted)], stdout=file,
                                               stderr=file, start_new_session=True))
        played = len(hours.read_text().splitlines()) - logged if hours.exists() else 0
        return Run(used, played, "" if code == 0 or Stop.asked else keep(output))


def keep(output):
    """Moves the output of a failed program to the findings, and returns its new path."""
    now = datetime.datetime.now().strftime("%Y%m%d-%H%M%S")
    kept = KEPT / "findings" / f"{output.stem}-{now}.txt"
    kept.parent.mkdir(parents=True, exist_ok=True)
    return str(output.replace(kept))


class Stop:
    """Notes that a signal asked the soak to end, and stops the running program."""

    asked = False
    process = None

    @classmethod
    def ask(cls, *_):
        cls.asked = True
        if cls.process is not None:
            cls.process.terminate()


def wait(process):
    """Waits for a process; returns (exit code, seconds of processor time)."""
    def children_seconds():
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        return used.ru_utime + used.ru_stime
    before = children_seconds()
    Stop.process = process
    if Stop.asked:
        process.terminate()
    code = process.wait()
    Stop.process = None
    return code, max(1, round(children_seconds() - before))


class Log:
    """The log file: lines of time, program, seconds, runs and finding. Totals are sums of them."""

    def __init__(self):
        KEPT.mkdir(parents=True, exist_ok=True)
        self.file = KEPT / "log.tsv"
        self.file.touch()

    def add(self, name, ran):
        now = datetime.datetime.now().isoformat(timespec="seconds")
        with self.file.open("a") as file:
            file.write(f"{now}\t{name}\t{ran.seconds}\t{ran.runs}\t{ran.finding}\n")

    def total(self, name):
        rows = [row for row in (line.split("\t") for line in self.file.read_text().splitlines())
                if row[1] == name]
        findings = sorted({row[4] for row in rows if row[4] and pathlib.Path(row[4]).exists()})
        return Total(sum(int(row[2]) for row in rows), sum(int(row[3]) for row in rows), findings)

    def done(self, program):
        """Returns the total in the unit of the program's rounds."""
        return getattr(self.total(program.name), program.unit)


def soak(program, left, log):
    """Runs the program for `left` seconds or hours in slices; a finding ends it early."""
    while left > 0 and not Stop.asked:
        ran = program.run(min(left, program.slice_length), log.total(program.name).seconds)
        log.add(program.name, ran)
        if ran.finding:
            print(f"{program.name}: {ran.finding}", flush=True)
            return
        left -= getattr(ran, program.unit)


def all_programs():
    """Returns the music, if built, and all fuzz targets."""
    targets = [FuzzTarget(program) for program in sorted(BUILT.glob("fuzz_*"))]
    return ([Music()] if MUSIC.exists() else []) + targets


def chosen(names):
    programs = {program.name: program for program in all_programs()}
    for name in names:
        if name not in programs:
            sys.exit(f"soak: there is no program '{name}', but {', '.join(programs) or 'none'}")
    return [programs[name] for name in names or programs]


def main(names):
    programs = chosen(names)
    each = int(os.environ.get("SOAK_SECONDS", 3600))
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, Stop.ask)

    log = Log()
    rounds = 1 + min(log.done(program) // program.round_length(each) for program in programs)
    for program in programs:
        left = rounds * program.round_length(each) - log.done(program)
        if left > 0 and not Stop.asked:
            print(f"{program.name}: {left} {'s' if program.unit == 'seconds' else 'h of it'}", flush=True)
            soak(program, left, log)

    print(f"\n{'program':16}{'hours':>8}{'runs':>14}  findings")
    totals = {program.name: log.total(program.name) for program in programs}
    for name, (seconds, runs, findings) in totals.items():
        print(f"{name:16}{seconds / 3600:8.2f}{runs:14}  {' '.join(findings)}")
    return 1 if any(findings for _, _, findings in totals.values()) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
