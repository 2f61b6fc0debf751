"""The package faster_sim against the program, on a small job."""

import doctest
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

import numpy

import faster_sim

SOURCE = Path(__file__).resolve().parents[2]
CONFIG = SOURCE / "configs" / "banana.yaml"
SMALL = {"workload.samples.count": 6, "accelerator.raster_cores": 2}
DEPTH = "accelerator.fifos.edge_token.depth"


class PackageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls._folder = tempfile.TemporaryDirectory()
        cls.folder = Path(cls._folder.name)
        cls.path = cls.folder / "banana.events"
        cls.events = faster_sim.record(CONFIG, cls.path, **SMALL)

    @classmethod
    def tearDownClass(cls) -> None:
        cls._folder.cleanup()

    def test_a_what_if_is_what_a_run_takes(self) -> None:
        retimed = self.events.whatif({DEPTH: 16})
        run = faster_sim.run(CONFIG, **SMALL, **{DEPTH: 16})
        self.assertNotEqual(run.total_cycles, self.events.summary["total_cycles"])
        self.assertEqual(retimed.total_cycles, run.total_cycles)
        self.assertEqual(retimed.milliseconds, run.milliseconds)
        for name in ("samples", "fifos", "loops"):
            numpy.testing.assert_array_equal(getattr(retimed, name), getattr(run, name))
        self.assertEqual(retimed.samples["sample"].tolist(), list(range(6)))

    def test_names_may_be_written_as_python_writes_them(self) -> None:
        self.assertEqual(self.events.whatif(accelerator__raster_cores=1).total_cycles,
                         self.events.whatif({"accelerator.raster_cores": 1}).total_cycles)

    def test_a_matrix_has_a_row_for_each_configuration(self) -> None:
        depths = [1, 2, 4, 8]
        table = self.events.whatif_matrix([{DEPTH: depth} for depth in depths])
        self.assertEqual(table[DEPTH].tolist(), depths)
        each = [self.events.whatif({DEPTH: depth}) for depth in depths]
        self.assertEqual(table["total_cycles"].tolist(), [one.total_cycles for one in each])
        self.assertEqual(table["deadlocked"].tolist(), [one.deadlocked for one in each])

    def test_keys_that_a_row_does_not_name_are_as_recorded(self) -> None:
        table = self.events.whatif_matrix([{}, {"accelerator.raster_cores": 1}])
        self.assertEqual(table["accelerator.raster_cores"].tolist(), [2, 1])
        self.assertEqual(table["total_cycles"][0], self.events.summary["total_cycles"])

    def test_a_deadlock_is_a_result(self) -> None:
        stuck = {"accelerator.fifos.fragment_depth.depth": 1, "accelerator.fifos.fragment_index.depth": 1}
        retimed = self.events.whatif(stuck)
        run = faster_sim.run(CONFIG, **SMALL, **stuck)
        self.assertTrue(retimed.deadlocked and run.deadlocked)
        self.assertIn("waits", retimed.deadlock_report)
        self.assertEqual(retimed.summary["deadlock"], run.summary["deadlock"])
        self.assertTrue(self.events.whatif_matrix([stuck])["deadlocked"][0])

    def test_bad_input_is_said_in_the_tool_s_line(self) -> None:
        with self.assertRaisesRegex(faster_sim.InputError, "did you mean accelerator.raster_cores"):
            self.events.whatif({"accelerator.raster_core": 1})
        with self.assertRaisesRegex(ValueError, "did you mean accelerator.raster_cores"):
            faster_sim.run(CONFIG, **{"accelerator.raster_core": 1})
        with self.assertRaisesRegex(faster_sim.InputError, "nowhere.events"):
            faster_sim.load_events(self.folder / "nowhere.events")
        with self.assertRaises(faster_sim.InputError):
            self.events.whatif_matrix([{"workload.samples.count": 3}])

    def test_bounds_without_sense_are_refused_before_the_search(self) -> None:
        for within in (-1, float("nan"), float("inf"), -0.001, 1e7):
            with self.assertRaisesRegex(faster_sim.InputError, "within_percent = .*, expected a number from 0 to"):
                self.events.size_fifos(within)
        with self.assertRaisesRegex(faster_sim.InputError, "front_points = 1001, expected"):
            self.events.size_fifos(5, front_points=1001)

    def test_sensitivities_and_sizes_are_those_of_the_tool(self) -> None:
        program = os.environ["FASTER_SIM"]
        folder = self.folder / "sizes"
        subprocess.run([program, "size-fifos", self.path, "--within", "5", "--points", "0", "--out", folder], check=True,
                       stdout=subprocess.DEVNULL)
        self.assertEqual(self.events.size_fifos(5), json.loads((folder / "sizing.json").read_text()))
        csv = self.folder / "sensitivities.csv"
        subprocess.run([program, "sensitivities", self.path, "--csv", csv], check=True, stdout=subprocess.DEVNULL)
        rows = self.events.sensitivities()
        self.assertEqual(len(rows), len(csv.read_text().splitlines()) - 1)
        deeper = rows[(rows["key"] == DEPTH) & (rows["changed_value"].astype(str) == "3")]
        self.assertEqual(deeper["total_cycles"].tolist(), [self.events.whatif({DEPTH: 3}).total_cycles])

    def test_a_run_writes_what_the_program_writes(self) -> None:
        out = self.folder / "out"
        result = faster_sim.run(CONFIG, out=out, **SMALL)
        self.assertEqual(json.loads((out / "summary.json").read_text()), result.summary)

    def test_the_version_is_that_of_the_program(self) -> None:
        said = subprocess.run([os.environ["FASTER_SIM"], "--version"], capture_output=True, text=True, check=True).stdout
        self.assertEqual(said.split()[0], faster_sim.__version__)
        self.assertEqual(self.events.whatif({DEPTH: 16}).summary["made_by"]["version"], faster_sim.__version__)
        self.assertEqual(self.events.whatif({DEPTH: 16}).summary["made_by"]["commit"] or "", faster_sim.__commit__)

    def test_progress_is_told(self) -> None:
        seen = []
        self.events.size_fifos(5, progress=lambda done, of_all: seen.append((done, of_all)))
        faster_sim.run(CONFIG, progress=lambda done, of_all: seen.append((done, of_all)), **SMALL)
        self.assertTrue(all(0 <= done <= of_all for done, of_all in seen))

    def test_ctrl_c_ends_work_in_this_process(self) -> None:
        many = [{DEPTH: 1 + i % 64, "accelerator.raster_cores": 1 + i % 6} for i in range(20000)]
        threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            self.events.whatif_matrix(many)
        self.assertLess(time.monotonic() - start, 60)
        self.assertFalse(self.events.whatif().deadlocked)  # and it goes on

    def test_what_progress_raises_ends_the_work(self) -> None:
        class Enough(Exception):
            pass

        def stop(done: int, of_all: int) -> None:
            raise Enough

        with self.assertRaises(Enough):
            self.events.whatif_matrix([{DEPTH: 1 + i % 64} for i in range(20000)], progress=stop)

    def test_the_tutorial_is_true(self) -> None:
        """docs/python.md, block after block, in a folder where it finds what it names."""
        text = (SOURCE / "docs" / "python.md").read_text(encoding="utf-8")
        blocks = re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
        self.assertGreater(len(blocks), 3)
        (self.folder / "configs").symlink_to(SOURCE / "configs")
        before = os.getcwd()
        os.chdir(self.folder)
        try:
            tutorial = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, "docs/python.md", None, 0)
            self.assertEqual(doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(tutorial).failed, 0)
        finally:
            os.chdir(before)


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
