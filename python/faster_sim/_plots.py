"""Pictures of a run, where matplotlib is installed."""

from collections import defaultdict
from typing import Any, Mapping

_COLOURS = {"busy": "#4c9a5b", "fill_drain": "#a9cfa4", "setup": "#d0d6a0", "empty_stall": "#6d8fc7", "full_stall": "#d98143",
            "port_conflict": "#b9484e", "recurrence": "#8d6bb1", "memory_stall": "#7a5c48", "idle_before": "#e4e4e4",
            "idle_after": "#cfcfcf"}


def stalls(summary: Mapping[str, Any], axes: Any) -> Any:
    axes = axes if axes is not None else _new_axes()
    sums: dict[str, dict[str, int]] = defaultdict(lambda: defaultdict(int))
    for row in summary["modules"]:
        for name, cycles in row.items():
            if name.endswith("_cycles"):
                sums[row["module"]][name.removesuffix("_cycles")] += cycles
    modules = list(sums)
    left = [0] * len(modules)
    for kind in dict.fromkeys(kind for row in sums.values() for kind in row):
        cycles = [sums[module][kind] for module in modules]
        if any(cycles):
            axes.barh(modules, cycles, left=left, label=kind.replace("_", " "), color=_COLOURS.get(kind))
        left = [start + more for start, more in zip(left, cycles)]
    axes.invert_yaxis()
    axes.set_xlabel("cycles of all cores")
    axes.legend(fontsize="small")
    return axes


def dataflow(summary: Mapping[str, Any], axes: Any) -> Any:
    axes = axes if axes is not None else _new_axes()
    edges = summary["dataflow"]
    places = _places(edges)
    waited: dict[str, int] = defaultdict(int)
    for row in summary["fifos"]:
        waited[row["fifo"]] += row["full_stall_cycles"] + row["empty_stall_cycles"]
    most = max(waited.values(), default=0) or 1
    between: dict[tuple[str, str], int] = defaultdict(int)
    for edge in edges:
        ends = (edge["from"], edge["to"])
        share = waited[edge["fifo"]] / most
        bend = 0.12 * between[ends]
        between[ends] += 1
        axes.annotate("", places[ends[1]], places[ends[0]], arrowprops={
            "arrowstyle": "->", "connectionstyle": f"arc3,rad={bend}", "lw": 1 + 4 * share, "color": "#d98143" if share > 0.1 else "#888",
            "shrinkA": 16, "shrinkB": 16})
        middle = [(a + b) / 2 for a, b in zip(places[ends[0]], places[ends[1]])]
        axes.text(middle[0], middle[1] - bend, edge["fifo"], fontsize=7, ha="center", va="bottom")
    for name, (x, y) in places.items():
        axes.text(x, y, name, ha="center", va="center", bbox={"boxstyle": "round", "facecolor": "#f3efe4", "edgecolor": "#555"}, fontsize=8)
    axes.set_xlim(-0.6, max((x for x, _ in places.values()), default=0) + 0.6)
    axes.set_ylim(min((y for _, y in places.values()), default=0) - 0.6, max((y for _, y in places.values()), default=0) + 0.6)
    axes.set_axis_off()
    return axes


def _places(edges: list[Mapping[str, str]]) -> dict[str, tuple[float, float]]:
    """A column behind those that a module reads from; a feedback counts for nothing."""
    names = list(dict.fromkeys(end for edge in edges for end in (edge["from"], edge["to"])))
    column = dict.fromkeys(names, 0)
    for _ in names:
        for edge in edges:
            column[edge["to"]] = min(max(column[edge["to"]], column[edge["from"]] + 1), len(names) - 1)
    columns = sorted(set(column.values()))
    places = {}
    for x, number in enumerate(columns):
        members = [name for name in names if column[name] == number]
        for i, name in enumerate(members):
            places[name] = (float(x), (len(members) - 1) / 2 - i)
    return places


def _new_axes() -> Any:
    from matplotlib import pyplot

    return pyplot.subplots(figsize=(9, 4))[1]
