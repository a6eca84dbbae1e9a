"""Tests soak.py with programs that only record their runs."""
import contextlib
import io
import os
import pathlib
import re
import tempfile
import unittest
from unittest import mock

import soak


class Program:
    unit = "seconds"

    def __init__(self, name, finding=""):
        self.name, self.finding, self.seconds = name, finding, []
        self.slice_length = 300

    def round_length(self, seconds):
        return seconds

    def run(self, seconds, before):
        self.seconds.append(seconds)
        return soak.Run(seconds, 10 * seconds, self.finding)


class StoppedProgram(Program):
    def run(self, seconds, before):
        soak.Stop.asked = True
        return super().run(seconds, before)._replace(seconds=0)


class Soak(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for patch in (mock.patch.object(soak, "KEPT", self.folder),
                      mock.patch.object(soak.signal, "signal")):
            patch.start()
            self.addCleanup(patch.stop)

    def soak(self, *programs, each, names=()):
        soak.Stop.asked = False
        told = io.StringIO()
        with mock.patch.object(soak, "all_programs", lambda: programs), \
                mock.patch.dict(os.environ, SOAK_SECONDS=str(each)), \
                contextlib.redirect_stdout(told):
            self.code = soak.main(names)
        return told.getvalue()

    def test_each_program_gets_its_time_in_slices_and_then_another_round(self):
        a, b = Program("a"), Program("b")
        for _ in range(2):
            self.soak(a, b, each=700)
            self.assertEqual(self.code, 0)
        self.assertEqual(a.seconds, 2 * [300, 300, 100])
        self.assertEqual(b.seconds, a.seconds)
        self.assertEqual(soak.Log().total("a"), (1400, 14000, []))

    def test_the_next_call_continues_where_the_last_one_stopped(self):
        a, stopped, c = Program("a"), StoppedProgram("b"), Program("c")
        self.soak(a, stopped, c, each=60)
        self.assertEqual((a.seconds, stopped.seconds, c.seconds), ([60], [60], []))
        b = Program("b")
        self.soak(a, b, c, each=60)
        self.assertEqual((a.seconds, b.seconds, c.seconds), ([60], [60], [60]))

    def test_a_new_program_catches_up_with_the_others(self):
        a, b = Program("a"), Program("b")
        self.soak(a, each=60)
        self.soak(a, b, each=60)
        self.assertEqual((a.seconds, b.seconds), ([60], [60]))

    def test_a_finding_ends_only_its_own_program(self):
        crash = self.folder / "a-crash"
        crash.touch()
        a, b = Program("a", str(crash)), Program("b")
        told = self.soak(a, b, each=700)
        self.assertEqual((a.seconds, b.seconds), ([300], [300, 300, 100]))
        self.assertIn(f"a: {crash}", told)
        self.assertEqual(self.code, 1)
        crash.unlink()  # fixed
        self.soak(b, each=700)
        self.assertEqual(self.code, 0)

    def test_a_named_program_runs_alone(self):
        a, b = Program("a"), Program("b")
        self.soak(a, b, each=60, names=["b"])
        self.assertEqual((a.seconds, b.seconds), ([], [60]))
        with self.assertRaisesRegex(SystemExit, "no program 'c', but a, b"):
            self.soak(a, b, each=60, names=["c"])

    def music(self, script):
        program = self.folder / "soak_music"
        program.write_text(f"#!/bin/sh\n{script}\n")
        program.chmod(0o755)
        patch = mock.patch.object(soak, "MUSIC", program)
        patch.start()
        self.addCleanup(patch.stop)
        return soak.Music()

    def test_music_plays_a_day_while_each_target_runs_an_hour(self):
        music, a = self.music('for i in $(seq "$2"); do echo hour >> "$1"; done'), Program("a")
        self.soak(music, a, each=600)
        self.assertEqual(soak.Log().total("music").runs, 4)
        self.soak(music, a, each=3600)
        self.assertEqual(soak.Log().total("music").runs, 24)
        self.soak(music, a, each=3600)
        self.assertEqual(soak.Log().total("music").runs, 48)
        self.assertEqual(sum(a.seconds), 7200)

    def test_failed_music_is_a_finding_and_its_hours_count(self):
        told = self.soak(self.music('echo hour >> "$1"; echo "It grew."; exit 1'), each=3600)
        total = soak.Log().total("music")
        self.assertEqual((total.runs, self.code), (1, 1))
        self.assertEqual(pathlib.Path(total.findings[0]).read_text(), "It grew.\n")
        self.assertIn(total.findings[0], told)

    def target(self, script, name="x"):
        program = self.folder / f"fuzz_{name}"
        program.write_text(f"#!/bin/sh\n{script}\n")
        program.chmod(0o755)
        return soak.FuzzTarget(program)

    def test_a_fuzz_target_reports_its_runs_and_the_failed_input(self):
        said = "stat::number_of_executed_units: 77"
        crash = self.folder / "findings/x-crash-1"
        self.assertEqual(self.target(f"echo {said}").run(1, 0)[1:], (77, ""))
        self.assertEqual(self.target(f"echo {said}; exit 72").run(1, 0)[1:], (77, ""))
        self.assertEqual(
            self.target(f"echo 'Test unit written to {crash}'; echo {said}; exit 77").run(1, 0)[1:],
            (77, str(crash)))
        _, runs, said = self.target("echo no; exit 1").run(1, 0)
        self.assertEqual(runs, 0)
        self.assertEqual(pathlib.Path(said).parent, self.folder / "findings")
        self.assertEqual(pathlib.Path(said).read_text(), "no\n")

    def test_one_slice_of_three_tries_long_inputs(self):
        for name, longest in ("x", 1 << 20), ("scene", 1 << 22), ("player_midi", 1 << 14):
            target = self.target('echo "$@"', name)
            said = []
            for before in (0, 301, 602, 899, 900, 1203, 1500):
                target.run(1, before)
                said.append((self.folder / f"{name}.txt").read_text())
            lengths = [re.search(r"-max_len=(\d+) -len_control=0 ", each) for each in said]
            self.assertEqual([each is not None for each in lengths],
                             [False, False, True, True, False, False, True])
            self.assertGreaterEqual(int(lengths[2].group(1)), longest)

    def test_calls_shorter_than_a_slice_also_try_long_inputs(self):
        target = self.target('echo "$@" >> ' + str(self.folder / "said"))
        soak.Log().add("x", soak.Run(550, 1, ""))
        for _ in range(2):
            soak.Log().add("x", soak.Run(25, 1, ""))
            soak.soak(target, 1, soak.Log())
        lengths = ["-max_len" in each for each in (self.folder / "said").read_text().splitlines()]
        self.assertEqual(lengths, [False, True])

    def test_seconds_are_processor_time(self):
        self.assertEqual(self.target("sleep 2").run(5, 0).seconds, 1)

    def test_music_reports_its_hours_and_keeps_the_output_of_a_failure(self):
        program = self.folder / "soak_music"
        program.write_text('#!/bin/sh\necho "hour 1" >> "$1"\necho "hour 2" >> "$1"\n'
                           '[ "$2" = 5 ] || { echo "It has grown."; exit 1; }\n')
        program.chmod(0o755)
        with mock.patch.object(soak, "MUSIC", program):
            self.assertEqual(soak.Music().run(5, 0)[1:], (2, ""))
            _, hours, said = soak.Music().run(6, 0)
        self.assertEqual(hours, 2)
        self.assertEqual(pathlib.Path(said).read_text(), "It has grown.\n")


if __name__ == "__main__":
    unittest.main()
