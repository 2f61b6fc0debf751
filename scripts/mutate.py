#!/usr/bin/env python3
"""Mistakes in the model, one at a time: does cosimulation with the register-transfer twin find each of them?

scripts/mutate.py [--check] [--only TEXT] [--jobs N]
    --check      only whether each change of tests/rtl/mutations.txt can be made exactly once
    --only TEXT  those whose description or file this regular expression fits

Works on a copy of the sources in build/mutations. The first build takes minutes, each mutation another compilation of
what includes the file and some seconds of simulation. Needs Verilator. Exit code 1: one is not found, or found although
it should not be seen.
"""
import argparse
import collections
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = ROOT / "tests/rtl/mutations.txt"
WORK = ROOT / "build/mutations"
COPIED = ["CMakeLists.txt", "CMakePresets.json", "cmake", "configs", "rtl", "src", "python"]

Mutation = collections.namedtuple("Mutation", "what file old new unseen")

# What is compared, one core each. Between them they enter every loop in every one of its forms.
DEEP = ["fifos.%s.depth=%d" % (name, depth) for name, depth in
        (("command", 40), ("fragment_depth", 40), ("fragment_index", 32), ("area", 3), ("area_reciprocal", 3),
         ("vertex", 5), ("edge_token", 64), ("sample_raster", 8))]  # 8 x 128 bits are 1024
COLUMNS = ["brams.%s.partition.%s" % (memory, key) for memory in ("object_map", "depth_buffer")
           for key in ("type=cyclic", "factor=10", "dimension=2")]
TEN_LANES = COLUMNS + ["edge_map.algorithm=inner_border", "edge_map.clearing=on_read_out", "edge_map.buffers=2",
                         "rasterizer.scan=spans", "rasterizer.setup_overlap=12", "rasterizer.edge_tokens=object",
                         "rasterizer.lanes=10", "inlier_unit.clearing=on_read_out",
                         "inlier_unit.fragment_loop=flattened",
                         "inlier_unit.sweep_lanes=5", "inlier_unit.sweep_region=touched", "inlier_unit.buffers=2",
                         "fifos.area.depth=16", "fifos.area_reciprocal.depth=32", "fifos.vertex.depth=16",
                         "fifos.command.depth=64", "fifos.fragment_depth.depth=64", "fifos.fragment_index.depth=64",
                         "fifos.edge_token.depth=64"]
TRIALS = [
    ("edge_heavy", []),
    ("full_window", []),
    ("edge_heavy", DEEP + ["fifo_rules=vitis_hls", "edge_map.flush_last=true", "inlier_unit.clearing=on_read_out",
                           "edge_map.clearing=on_read_out", "brams.object_map.ports=1", "loops.rasterizer.scan.ii=2"]),
    ("edge_heavy", DEEP + ["inlier_unit.fragment_loop=flattened", "edge_map.algorithm=inner_border",
                           "inlier_unit.clearing=on_read_out", "brams.depth_buffer.ports=1",
                           "area_reciprocal.when_full=squeeze", "fifos.area_reciprocal.write_latency=2"]),
    ("fragment_heavy", DEEP + ["inlier_unit.neighbour_access=window", "inlier_unit.hidden=counted", "edge_map.clearing=on_read_out",
                               "brams.edge_map.ports=1", "loops.inlier_unit.fragment.recurrence_ii=3",
                               "fifos.fragment_index.write_latency=3", "fifos.command.kind=memory"]),
    ("tomato_soup_can", DEEP),
    ("empty", []),
    ("last_object", []),
    ("at_border", []),
    # Our own designs
    ("edge_heavy", TEN_LANES + ["inlier_unit.hidden=counted"]),
    ("edge_heavy", TEN_LANES + ["rasterizer.lanes=5", "inlier_unit.sweep_lanes=10", "edge_map.buffers=1",
                                  "inlier_unit.buffers=1", "fifos.area.depth=4", "rasterizer.setup_overlap=2"]),
    ("full_window", TEN_LANES + ["rasterizer.lanes=1", "inlier_unit.sweep_region=window", "fifos.vertex.depth=2"]),
]


def read_list():
    mutations = []
    for stanza in re.split(r"\n\n+", LIST.read_text().strip()):
        fields, name = {}, None
        for line in stanza.split("\n"):
            if line.startswith("#"):
                continue
            found = re.match(r"(what|file|from|to|unseen): +(.*)", line)
            if found:
                name = found.group(1)
                fields[name] = found.group(2)
            else:
                fields[name] += "\n" + line
        if fields:
            mutations.append(Mutation(*(fields.get(name) for name in ("what", "file", "from", "to", "unseen"))))
    return mutations


def wrong_entries(mutations):
    for mutation in mutations:
        path = ROOT / mutation.file
        times = path.read_text().count(mutation.old) if path.exists() else 0
        if times != 1 or mutation.old == mutation.new:
            yield f"{mutation.what}: {mutation.file} has its text {times} times, expected once"


def copy_sources():
    """What has not changed keeps its time, and is not compiled again."""
    source = WORK / "source"
    for name in COPIED:
        for path in [ROOT / name] if (ROOT / name).is_file() else sorted((ROOT / name).rglob("*")):
            target = source / path.relative_to(ROOT)
            if not path.is_file() or (target.exists() and target.read_bytes() == path.read_bytes()):
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, target)
    return source


def build(source, jobs, is_first=False):
    """Little optimization: compiling takes longer than simulating."""
    folder = WORK / "build"
    if is_first:  # also if it was configured before: files may have come
        subprocess.run(["cmake", "-S", source, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG", "-DCMAKE_UNITY_BUILD=ON",
                        "-DFASTER_BUILD_TESTS=OFF", "-DFASTER_BUILD_EXAMPLES=OFF", "-DFASTER_BUILD_PYTHON=OFF",
                        "-DFASTER_BUILD_BENCHMARKS=OFF"],
                       check=True, stdout=subprocess.DEVNULL)
    return subprocess.run(["cmake", "--build", folder, "--target", "faster-sim", "--", f"-j{jobs}"],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def program():
    return next(path for path in (WORK / "build").rglob("faster-sim") if path.is_file())


def make_traces():
    """Two more than there are: a sample whose last token is an object's, in a row that ends at the left wall; and a
    triangle that reaches one column beyond the image, which rejects it."""
    folder = WORK / "traces"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(ROOT / "traces", folder)
    for name, old, new in (("last_object", "480,384,", "480,368,"), ("at_border", "544,320,", "1024,320,")):
        shutil.copytree(folder / "one_triangle", folder / name)
        triangles = folder / name / "triangles.csv"
        triangles.write_text(triangles.read_text().replace(old, new))


def first_difference(faster_sim):
    """Of the first trial that has one: (trial, what cosim says); None: there is none."""
    for number, (trace, keys) in enumerate(TRIALS):
        overrides = [word for key in ["raster_cores=1"] + keys for word in ("--set", "accelerator." + key)]
        try:
            run = subprocess.run(
                [faster_sim, "cosim", WORK / "traces" / trace, "--out", WORK / "waveforms"] + overrides,
                capture_output=True, text=True, timeout=60)
        except subprocess.TimeoutExpired:
            return number, "the model does not come to an end"
        if run.returncode == 2:
            sys.exit(f"trial {number}: {run.stderr}")
        if run.returncode != 0:
            return number, (run.stdout or run.stderr or f"the model ends with {run.returncode}").strip().split("\n")[0]
    return None


def try_one(source, mutation, jobs):
    """What cosim says; None: nothing."""
    path = source / mutation.file
    kept = path.read_text()
    path.write_text(kept.replace(mutation.old, mutation.new))
    try:
        built = build(source, jobs)
        if built.returncode != 0:
            sys.exit(f"{mutation.what}: does not compile\n{built.stdout}")
        return first_difference(program())
    finally:
        path.write_text(kept)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    mutations = read_list()
    complaints = list(wrong_entries(mutations))
    if complaints:
        sys.exit("\n".join(complaints))
    if arguments.check:
        print(f"{len(mutations)} mutations can be made")
        return 0
    os.nice(5)
    source = copy_sources()
    make_traces()
    built = build(source, arguments.jobs, is_first=True)
    if built.returncode != 0:
        sys.exit(built.stdout)
    found = first_difference(program())
    if found:
        sys.exit(f"without a mutation, trial {found[0]}: {found[1]}")
    wrong = 0
    chosen = [mutation for mutation in mutations if re.search(arguments.only, f"{mutation.what} {mutation.file}")]
    # What many files include takes long.
    chosen.sort(key=lambda mutation: (mutation.file.endswith(".hpp"), mutation.file.startswith("src/dataflow")))
    for mutation in chosen:
        found = try_one(source, mutation, arguments.jobs)
        is_right = (found is None) == bool(mutation.unseen)
        wrong += not is_right
        print(f"{'' if is_right else 'WRONG '}{mutation.what}: "
              f"{f'trial {found[0]}: {found[1]}' if found else 'not found'}", flush=True)
    print(f"{len(chosen)} mutations, {wrong} not as expected")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
