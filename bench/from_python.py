"""100 re-timings of one sample: in the process of Python, and as programs."""

import tempfile
import time

import faster_sim

KEY = "accelerator.fifos.edge_token.depth"


def seconds_of(work) -> float:
    start = time.perf_counter()
    for depth in range(2, 102):
        work(depth)
    return time.perf_counter() - start


with tempfile.NamedTemporaryFile(suffix=".events") as file:
    events = faster_sim.record("configs/faster_zcu102.yaml", file.name, workload__samples__count=1)
    program = faster_sim.Program()
    here = seconds_of(lambda depth: events.whatif({KEY: depth}))
    programs = seconds_of(lambda depth: program.call("whatif", file.name, **{KEY: depth}))
print(f"in process {here:.2f} s, as programs {programs:.2f} s, ratio {programs / here:.0f}")
