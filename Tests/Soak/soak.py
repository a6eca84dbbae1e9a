#!/usr/bin/env python3
"""Runs what finds faults with time: every fuzz target for SOAK_SECONDS, an hour unless set, and a day of
music at random, or the same share of it.

build/soak keeps what there is between calls: log.tsv with a line for each run, the inputs that each
target has come by, and those that failed. A run is cut into slices, so that a call which ends early
loses minutes at most. The next call goes on where this one stopped; once every program has had its
time, it begins another round.

    soak.py [PROGRAM...]    all of them, unless some are named ("music", "preset", "mesh_ply")

Of a fuzz target a run is an input, of the music it is an hour of it. Seconds are the processor's, so that
what runs beside other work counts for what it got.
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
    """What a program did while it ran."""

    seconds: int  # of the processor, at least one
    runs: int
    finding: str  # a file, or ""


class Total(typing.NamedTuple):
    """Of all runs of a program in the log."""

    seconds: int
    runs: int
    findings: list  # of which the files are still there


class FuzzTarget:
    """One of the libFuzzer programs of Tests/Fuzz, built in the preset `fuzz`. Its rounds go by seconds.

    Of three slices' time one slice's goes to inputs of up to `longest` bytes, which pass what the readers
    of presets, materials, tunings and scenes allow; the others are left to libFuzzer, for which 4096
    are enough unless a seed is longer."""

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
        """Tries inputs behind so many seconds in earlier slices and calls, as a Run, with the file of one that failed or that says why nothing ran."""
        grown, findings = KEPT / "corpus" / self.name, KEPT / "findings"
        for folder in (grown, findings):
            folder.mkdir(parents=True, exist_ok=True)
        dictionary = ROOT / f"Tests/Fuzz/dictionaries/{self.name}.dict"
        output = KEPT / f"{self.name}.txt"
        with output.open("wb") as file:
            # In a session of its own, so that only this script is told to stop, and passes it on.
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
    """Hours of music in one processor, after each of which everything must be as it was. Its rounds go by
    these hours, which are its runs."""

    unit = "runs"
    name = "music"
    hours_of_day = 24
    slice_length = hours_of_day  # a long session in one process is what is tried

    @classmethod
    def round_length(cls, seconds):
        return max(1, round(cls.hours_of_day * seconds / 3600))

    def run(self, wanted, before):
        """Plays so many hours, as a Run, with the file that says what went wrong."""
        KEPT.mkdir(parents=True, exist_ok=True)
        hours, output = KEPT / "music.hours", KEPT / "music.txt"
        logged = len(hours.read_text().splitlines()) if hours.exists() else 0
        with output.open("wb") as file:
            code, used = wait(subprocess.Popen([MUSIC, hours, str(wanted)], stdout=file,
                                               stderr=file, start_new_session=True))
        played = len(hours.read_text().splitlines()) - logged if hours.exists() else 0
        return Run(used, played, "" if code == 0 or Stop.asked else keep(output))


def keep(output):
    """The output of a program that failed, where the next run does not write over it."""
    now = datetime.datetime.now().strftime("%Y%m%d-%H%M%S")
    kept = KEPT / "findings" / f"{output.stem}-{now}.txt"
    kept.parent.mkdir(parents=True, exist_ok=True)
    return str(output.replace(kept))


class Stop:
    """Whether a signal has asked the soak to end, and the program that runs meanwhile."""

    asked = False
    process = None

    @classmethod
    def ask(cls, *_):
        cls.asked = True
        if cls.process is not None:
            cls.process.terminate()


def wait(process):
    """(exit code, seconds of the processor)"""
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
    """Lines of time, program, seconds, runs and finding; totals are sums of them."""

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
        """Of what the program's rounds go by."""
        return getattr(self.total(program.name), program.unit)


def soak(program, left, log):
    """Runs the program for so many seconds or hours in slices; what it finds ends that early."""
    while left > 0 and not Stop.asked:
        ran = program.run(min(left, program.slice_length), log.total(program.name).seconds)
        log.add(program.name, ran)
        if ran.finding:
            print(f"{program.name}: {ran.finding}", flush=True)
            return
        left -= getattr(ran, program.unit)


def all_programs():
    """What has a name and can run for some seconds."""
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
