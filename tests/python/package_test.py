"""The package faster_sim against the program, on a small job."""

import doctest
import json
import multiprocessing
import os
import pickle
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy

import faster_sim
from faster_sim import _tables, _values

SOURCE = Path(__file__).resolve().parents[2]
CONFIG = SOURCE / "configs" / "banana.yaml"
SMALL = {"workload.samples.count": 6, "accelerator.raster_cores": 2}
DEPTH = "accelerator.fifos.edge_token.depth"
STUCK = {"accelerator.fifos.fragment_depth.depth": 1, "accelerator.fifos.fragment_index.depth": 1}


def total_of(task: tuple) -> int:
    events, depth = task
    return int(events.whatif({DEPTH: depth}).total_cycles)


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
        run = faster_sim.run(CONFIG, {DEPTH: 16}, **SMALL)
        self.assertNotEqual(run.total_cycles, self.events.summary["total_cycles"])
        self.assertEqual(retimed.total_cycles, run.total_cycles)
        self.assertEqual(retimed.milliseconds, run.milliseconds)
        for name in ("samples", "fifos", "loops", "modules"):
            one, other = getattr(retimed, name), getattr(run, name)
            self.assertEqual((type(one), one.dtype, one.tolist()), (type(other), other.dtype, other.tolist()))
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
        self.assertEqual(set(table["status"]), {"done"})

    def test_keys_that_a_row_does_not_name_are_as_recorded(self) -> None:
        table = self.events.whatif_matrix([{}, {"accelerator.raster_cores": 1}])
        self.assertEqual(table["accelerator.raster_cores"].tolist(), [2, 1])
        self.assertEqual(table["total_cycles"][0], self.events.summary["total_cycles"])

    def test_a_deadlock_is_raised_and_says_who_waits(self) -> None:
        with self.assertRaises(faster_sim.DeadlockError) as by_retiming:
            self.events.whatif(STUCK)
        with self.assertRaises(faster_sim.DeadlockError) as by_running:
            faster_sim.run(CONFIG, **SMALL, **STUCK)
        retimed, run = by_retiming.exception, by_running.exception
        self.assertEqual(str(retimed), str(run))
        self.assertIn("waits for inlier_unit", str(run))
        self.assertNotIn("written", str(run))
        self.assertEqual(retimed.summary["deadlock"], run.summary["deadlock"])
        self.assertEqual(retimed.summary["partial"], run.summary["partial"])
        self.assertEqual({(row["process"], row["waits_for"]) for row in run.wait_cycle},
                         {("rasterizer", "inlier_unit"), ("inlier_unit", "rasterizer")})
        self.assertTrue(all(0 < row["since_cycle"] <= run.cycle for row in run.wait_cycle))
        self.assertEqual(run.samples_done, 0)
        self.assertGreater(run.fifos["writes"].sum(), 100)
        self.assertEqual(str(pickle.loads(pickle.dumps(run))), str(run))

    def test_a_recording_that_gets_stuck_gives_no_older_figures(self) -> None:
        path = self.folder / "older.events"
        faster_sim.record(CONFIG, path, **SMALL)
        before = path.read_bytes()
        with self.assertRaises(faster_sim.DeadlockError):
            faster_sim.record(CONFIG, path, **SMALL, **STUCK)
        self.assertEqual(path.read_bytes(), before)

    def test_a_deadlock_has_no_figure_in_a_table(self) -> None:
        table = self.events.whatif_matrix([STUCK, {}, {"accelerator.raster_cores": 1}])
        self.assertEqual(table["status"].tolist(), ["deadlock", "done", "done"])
        self.assertEqual(table["total_cycles"].tolist()[0], None)
        self.assertEqual(table["milliseconds"].tolist()[0], None)
        self.assertEqual(table["total_cycles"].argmin(), 1)
        self.assertEqual(numpy.asarray(table["total_cycles"]).argmin(), 1)  # nothing lies under the mask
        everywhere = self.events.whatif_matrix([STUCK])
        self.assertEqual((everywhere["total_cycles"].tolist(), everywhere["total_cycles"].dtype), ([None], numpy.int64))
        steps = self.events.sensitivities()
        stuck = steps[steps["status"] != "done"]
        self.assertGreater(len(stuck), 0)
        self.assertEqual(set(stuck["total_cycles"].tolist()), {None})

    def test_a_whatif_has_a_critical_path_if_asked_for(self) -> None:
        other = {"accelerator.brams.depth_buffer.ports": 4}
        path = self.events.whatif(other, critical_path=True).critical_path
        run = faster_sim.run(CONFIG, critical_path=True, **SMALL, **other)
        self.assertEqual(path.tolist(), run.critical_path.tolist())
        self.assertEqual(sum(path["cycles"]), run.total_cycles)

    def test_bad_input_is_said_in_the_tool_s_line(self) -> None:
        with self.assertRaisesRegex(faster_sim.InputError, "did you mean accelerator.raster_cores"):
            self.events.whatif({"accelerator.raster_core": 1})
        with self.assertRaisesRegex(ValueError, "did you mean accelerator.raster_cores"):
            faster_sim.run(CONFIG, **{"accelerator.raster_core": 1})
        with self.assertRaisesRegex(faster_sim.InputError, "character of code 0"):
            faster_sim.run("a\0b.yaml")
        with self.assertRaisesRegex(faster_sim.InputError, "nowhere.events"):
            faster_sim.load_events(self.folder / "nowhere.events")
        with self.assertRaises(faster_sim.InputError):
            self.events.whatif_matrix([{"workload.samples.count": 3}])

    def test_what_looks_like_a_mistake_is_a_warning_of_the_line_that_asked(self) -> None:
        told = "workload.camera.cx = 9000: the optical axis is outside"
        for command in (lambda: faster_sim.run(CONFIG, workload__camera__cx=9000, **SMALL),
                        lambda: faster_sim.record(CONFIG, self.folder / "warned.events", workload__camera__cx=9000, **SMALL),
                        lambda: faster_sim.estimate(CONFIG, untimed=True, estimator__iterations=1, workload__camera__cx=9000,
                                                    **{"workload.samples.count": 6})):
            with self.assertWarnsRegex(faster_sim.InputWarning, "^" + told) as warned:
                command()
            self.assertEqual(warned.filename, __file__)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            faster_sim.run(CONFIG, **SMALL)
            with self.assertRaisesRegex(faster_sim.InputWarning, told):
                faster_sim.run(CONFIG, workload__camera__cx=9000, **SMALL)

    def test_bounds_without_sense_are_refused_before_the_search(self) -> None:
        for within in (-1, float("nan"), float("inf"), -0.001, 1e7, 10**400, None, "5", True):
            with self.subTest(within=within), self.assertRaisesRegex(faster_sim.InputError, "within_percent = .*, expected a number from 0 to"):
                self.events.size_fifos(within)
        with self.assertRaisesRegex(faster_sim.InputError, "front_points = 1001, expected"):
            self.events.size_fifos(5, front_points=1001)
        for jobs in (-1, 1.5, "2"):
            with self.assertRaisesRegex(faster_sim.InputError, "jobs = .*, expected a whole number from 0 to 1024"):
                self.events.size_fifos(5, jobs=jobs)

    def test_values_may_be_numpy_s(self) -> None:
        expected = self.events.whatif({DEPTH: 4}).total_cycles
        for four in (numpy.int64(4), numpy.uint8(4), 4.0, numpy.float32(4), "4"):
            with self.subTest(type=type(four)):
                self.assertEqual(self.events.whatif({DEPTH: four}).total_cycles, expected)
        table = self.events.whatif_matrix([{DEPTH: depth} for depth in numpy.array([1, 4])])
        self.assertEqual((table[DEPTH].tolist(), int(table["total_cycles"][1])), ([1, 4], expected))
        for flag in (True, numpy.bool_(True)):
            run = faster_sim.run(CONFIG, **SMALL, accelerator__edge_map__flush_last=flag)
            self.assertIs(run.summary["configuration"]["accelerator.edge_map.flush_last"]["value"], True)
        self.assertEqual(_values.as_yaml(numpy.array([[1.0, 0.5], [2.0, 3.0]])), "[[1, 0.5], [2, 3]]")
        self.assertEqual(_values.as_yaml([numpy.bool_(False), numpy.float32(0.1), "a, b"]), '[false, 0.1, "a, b"]')
        with self.assertRaisesRegex(faster_sim.InputError, "0.5"):
            self.events.whatif({DEPTH: 0.5})
        with self.assertRaisesRegex(faster_sim.InputError, "NoneType"):
            self.events.whatif({DEPTH: None})
        with self.assertRaisesRegex(faster_sim.InputError, "5 is of type int, expected the name of a key"):
            self.events.whatif({5: 1})
        with self.assertRaisesRegex(faster_sim.InputError, "configurations is of type dict, expected a list of dicts"):
            self.events.whatif_matrix({DEPTH: 1})
        with self.assertRaisesRegex(faster_sim.InputError, "row 1 is of type str, expected a dict"):
            self.events.whatif_matrix([{}, DEPTH])

    def test_paths_are_those_of_the_system(self) -> None:
        path = os.path.join(os.fsencode(self.folder), b"e\xff.events")
        shutil.copy(self.path, path)
        events = faster_sim.load_events(os.fsdecode(path))
        self.assertEqual(events.whatif().total_cycles, self.events.whatif().total_cycles)
        self.assertEqual(pickle.loads(pickle.dumps(events)).config, self.events.config)
        with self.assertRaisesRegex(faster_sim.InputError, "no such file"):
            faster_sim.load_events(os.fsdecode(path + b"\xfe"))
        recorded = faster_sim.record(CONFIG, os.fsdecode(path), **SMALL)
        self.assertEqual(recorded.whatif().total_cycles, self.events.whatif().total_cycles)

    def test_events_go_to_other_processes(self) -> None:
        with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
            totals = list(pool.map(total_of, [(self.events, depth) for depth in (1, 16)]))
        self.assertEqual(totals, [self.events.whatif({DEPTH: depth}).total_cycles for depth in (1, 16)])
        result = self.events.whatif()
        self.assertEqual(pickle.loads(pickle.dumps(result)).samples.tolist(), result.samples.tolist())

    def test_options_are_those_of_the_program(self) -> None:
        page, wave = self.folder / "run.html", self.folder / "run.vcd"
        run = faster_sim.run(CONFIG, **SMALL, critical_path=True, hazards=True, report=page, vcd=wave, vcd_samples=0,
                             vcd_modules=["rasterizer", "inlier_unit"], images=None, sensitivities=False)
        self.assertIn("<html", page.read_text())
        self.assertIn("$enddefinitions", wave.read_text())
        self.assertEqual(sum(run.critical_path["cycles"].tolist()), run.total_cycles)
        self.assertIn("object_map", run.hazards["bram"].tolist())
        self.assertIn("Bound by", run.text)
        with self.assertRaisesRegex(KeyError, "critical_path=True"):
            self.events.whatif().critical_path
        with self.assertRaisesRegex(faster_sim.InputError, r"--bananas: unknown option \(see faster-sim run --help\)"):
            faster_sim.run(CONFIG, bananas=True)

    def test_commands_answer(self) -> None:
        before, after = self.events.whatif(), self.events.whatif({DEPTH: 16})
        comparison = faster_sim.compare(before, after)
        self.assertEqual(comparison.summary["total_cycles"]["difference"], after.total_cycles - before.total_cycles)
        self.assertGreater(len(comparison["changes"]), 3)
        budget = self.folder / "budget.yaml"
        faster_sim.Program().call("check", init=CONFIG, out=budget, **SMALL)
        self.assertTrue(faster_sim.check(budget))
        broken = faster_sim.check(budget, accelerator__raster_cores=1)
        self.assertFalse(broken.passed)
        self.assertIn("breached", broken["limits"]["status"].tolist())
        self.assertIn("total_cycles", broken.text)
        found = faster_sim.estimate(CONFIG, untimed=True, estimator__iterations=2, workload__samples__count=20)
        self.assertEqual(len(found["iterations"]), len(found.summary["iterations"]))
        with self.assertRaisesRegex(faster_sim.InputError, "nowhere"):
            faster_sim.evaluate(self.folder / "m.csv", dataset=self.folder / "nowhere")

    def test_an_estimate_of_all_has_its_results(self) -> None:
        wish = self.folder / "experiment.yaml"
        wish.write_text("""format: faster-experiment
version: 1
set: {workload.samples.count: 4, estimator.iterations: 1}
scenes: {bright: {objects: [banana], images: 2}}
methods: {faster: {}}
""")
        faster_sim.Program().call("experiment", wish, out=self.folder / "experiment")
        found = faster_sim.estimate(CONFIG, all=True, bop=self.folder / "experiment" / "scenes" / "bright",
                                    workload__samples__count=4, estimator__iterations=1)
        self.assertEqual(found["results"]["obj_id"].tolist(), [10, 10])
        self.assertEqual(found.summary, {})

    def test_tables_know_quotes_types_and_empty_cells(self) -> None:
        table = _tables.of_csv('a,b,message,total_cycles,flag\n1,0.5,"x, ""y""",7,true\n2,,,,false\n')
        self.assertEqual(table.tolist(), [(1, 0.5, 'x, "y"', 7, True), (2, None, "", None, False)])
        self.assertEqual([table.dtype[name].kind for name in table.dtype.names], ["i", "f", "U", "i", "b"])
        self.assertEqual(_tables.of_csv("a,total_cycles\n1,\n")["total_cycles"].tolist(), [None])
        self.assertEqual(_tables.of_csv("a,b\n").tolist(), [])
        self.assertIn("<td>x, &quot;y&quot;</td>", table._repr_html_())
        self.assertIn("<td>-</td>", table._repr_html_())
        self.assertEqual(_tables.of_cells([2, "auto"]).tolist(), ["2", "auto"])

    def test_a_sweep_loses_no_point(self) -> None:
        sweep, depth = self.folder / "sweep.yaml", "accelerator.fifos.fragment_depth.depth"
        (self.folder / "as, usual.yaml").write_text("accelerator: {clock_mhz: 100}\n")
        (self.folder / "behind.yaml").write_text("workload: {samples: {poses: behind.csv}}\n")
        (self.folder / "behind.csv").write_text("R,t_m\n1 0 0 0 1 0 0 0 1,0 0 -1\n")
        sweep.write_text(f"""format: faster-sweep
version: 1
base: {CONFIG}
set: {{workload.samples.count: 2, accelerator.raster_cores: 1}}
dimensions:
  - {{overlay: what, files: ["as, usual.yaml", behind.yaml]}}
  - {{key: {depth}, values: [1, 2]}}
""")
        table = faster_sim.sweep(sweep, self.folder / "points", jobs=1)
        self.assertEqual(table["status"].tolist(), ["deadlock", "done", "failed", "failed"])
        self.assertEqual(table["what"].tolist()[0], "as, usual.yaml")
        self.assertEqual(table[depth].tolist(), [1, 2, 1, 2])
        self.assertEqual([cycles is None for cycles in table["total_cycles"].tolist()], [True, False, True, True])
        self.assertIn("rasterizer", table["message"].tolist()[0])

    def test_other_designs_are_re_timed_by_their_program(self) -> None:
        if not (pipeline := Path(os.environ["FASTER_SIM"]).parent / "pipeline").exists():
            self.skipTest("no example designs in this build")
        program, depth = faster_sim.Program("pipeline"), "accelerator.fifos.number.depth"
        self.assertEqual(Path(program.path), pipeline)
        path = self.folder / "pipeline.events"
        recorded = program.record(SOURCE / "examples" / "pipeline" / "pipeline.yaml", path)
        for events in (recorded, faster_sim.load_events(path), pickle.loads(pickle.dumps(recorded))):
            self.assertEqual(events.config[depth], 2)
            changed = events.whatif({depth: 16})
            self.assertEqual(changed.samples.dtype, events.whatif().samples.dtype)
        run = program.run(SOURCE / "examples" / "pipeline" / "pipeline.yaml", **{depth: 16})
        self.assertEqual((changed.total_cycles, changed.samples.tolist()), (run.total_cycles, run.samples.tolist()))
        table = recorded.whatif_matrix([{depth: 16}, {}])
        self.assertEqual(table["total_cycles"].tolist(), [run.total_cycles, recorded.summary["total_cycles"]])
        steps = recorded.sensitivities()
        self.assertIn("done", steps["status"].tolist())
        self.assertEqual(recorded.size_fifos(0)["answer"]["total_cycles"] <= recorded.summary["total_cycles"], True)
        with self.assertRaisesRegex(faster_sim.InputError, "did you mean accelerator.fifos.number.depth"):
            recorded.whatif({"accelerator.fifos.numbr.depth": 1})
        with self.assertRaisesRegex(faster_sim.InputError, "^row 1: .*decides what is computed"):
            recorded.whatif_matrix([{}, {"workload.numbers": 5}])
        with self.assertRaisesRegex(faster_sim.InputError, "was recorded by faster-sim"):
            program.call("whatif", self.path)
        with self.assertRaisesRegex(faster_sim.InputError, "was recorded by pipeline"):
            faster_sim.Program().call("whatif", path)

    def test_a_design_that_gets_stuck(self) -> None:
        if not (Path(os.environ["FASTER_SIM"]).parent / "cyclic").exists():
            self.skipTest("no example designs in this build")
        with self.assertRaisesRegex(faster_sim.DeadlockError, "deadlock at cycle"):
            faster_sim.Program("cyclic").run(SOURCE / "examples" / "cyclic" / "deadlock.yaml")

    def test_data_frames_say_what_is_missing(self) -> None:
        try:
            import pandas
        except ImportError:
            self.skipTest("no pandas")
        frame = faster_sim.to_pandas(self.events.whatif_matrix([STUCK, {}]))
        self.assertEqual(frame["status"].tolist(), ["deadlock", "done"])
        self.assertTrue(pandas.isna(frame["total_cycles"][0]))
        self.assertEqual(frame["total_cycles"].idxmin(), 1)

    def test_pictures_are_drawn(self) -> None:
        try:
            import matplotlib
        except ImportError:
            self.skipTest("no matplotlib")
        matplotlib.use("Agg")
        result = self.events.whatif()
        bars = result.plot_stalls()
        self.assertEqual([label.get_text() for label in bars.get_yticklabels()][:2], ["sample_dispatcher", "vertex_transform"])
        widths = sum(bar.get_width() for bar in bars.patches)
        self.assertEqual(widths, 2 * 8 * result.total_cycles)  # of two cores' eight modules
        graph = result.plot_dataflow()
        texts = {text.get_text() for text in graph.texts}
        self.assertLessEqual({"rasterizer", "inlier_unit", "command\nfragment_depth\nfragment_index"}, texts)
        boxes = [text.get_window_extent() for text in graph.texts]
        for i, box in enumerate(boxes):
            self.assertEqual(box.count_overlaps(boxes[:i]), 0, graph.texts[i].get_text())

    def test_a_result_is_a_table_in_a_notebook(self) -> None:
        shown = self.events.whatif()._repr_html_()
        self.assertIn(f"{self.events.whatif().total_cycles:,} cycles", shown)
        self.assertIn("<td>rasterizer</td>", shown)

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
        self.assertGreater(self.events.whatif().total_cycles, 0)  # and it goes on

    def test_what_progress_raises_ends_the_work(self) -> None:
        class Enough(Exception):
            pass

        def stop(done: int, of_all: int) -> None:
            raise Enough

        with self.assertRaises(Enough):
            self.events.whatif_matrix([{DEPTH: 1 + i % 64} for i in range(20000)], progress=stop)

    def test_the_pages_are_true(self) -> None:
        """README.md and docs/python.md, block after block, in a folder where they find what they name."""
        for part in ("configs", "examples", "traces"):
            (self.folder / part).symlink_to(SOURCE / part)
        before = os.getcwd()
        os.chdir(self.folder)
        try:
            for page, least in (("README.md", 1), ("docs/python.md", 4)):
                blocks = re.findall(r"^```python\n(.*?)^```", (SOURCE / page).read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)
                self.assertGreaterEqual(len(blocks), least)
                shown = doctest.DocTestParser().get_doctest("\n".join(blocks), {}, page, None, 0)
                self.assertGreater(len(shown.examples), 0, page)
                self.assertEqual(doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(shown).failed, 0, page)
        finally:
            os.chdir(before)


if __name__ == "__main__":
    sys.exit(unittest.main(verbosity=2))
