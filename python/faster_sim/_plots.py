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
    """An arrow for all FIFOs from one module to another, as thick as the one that is waited for most."""
    edges = summary["dataflow"]
    places = _places(edges)
    columns = max((x for x, _ in places.values()), default=0)
    axes = axes if axes is not None else _new_axes(width=2.4 * (columns + 1))
    waited: dict[str, int] = defaultdict(int)
    for row in summary["fifos"]:
        waited[row["fifo"]] += row["full_stall_cycles"] + row["empty_stall_cycles"]
    most = max(waited.values(), default=0) or 1
    between: dict[tuple[str, str], list[str]] = defaultdict(list)
    for edge in edges:
        between[edge["from"], edge["to"]].append(edge["fifo"])
    for (start, end), fifos in between.items():
        bend = 0.3 if _is_in_the_way(places, places[start], places[end]) else 0.0
        _arrow(axes, places[start], places[end], bend, fifos, max(waited[fifo] for fifo in fifos) / most)
    for name, (x, y) in places.items():
        axes.text(x, y, name, ha="center", va="center", bbox={"boxstyle": "round", "facecolor": "#f3efe4", "edgecolor": "#555"}, fontsize=8)
    axes.set_xlim(-0.6, columns + 0.6)
    axes.set_ylim(min((y for _, y in places.values()), default=0) - 0.8, max((y for _, y in places.values()), default=0) + 0.6)
    axes.set_axis_off()
    return axes


def _is_in_the_way(places: Mapping[str, tuple[float, float]], start: tuple[float, float], end: tuple[float, float]) -> bool:
    """Whether a straight line passes a module closely."""
    left, right = sorted([start, end])
    return any(left[0] < x < right[0] and abs(left[1] + (right[1] - left[1]) * (x - left[0]) / (right[0] - left[0]) - y) < 0.4
               for x, y in places.values())


def _arrow(axes: Any, start: tuple[float, float], end: tuple[float, float], bend: float, fifos: list[str], share: float) -> None:
    """Names stand in its middle, which a bend puts below."""
    from matplotlib.patches import FancyArrowPatch

    dx, dy = end[0] - start[0], end[1] - start[1]
    colour = "#d98143" if share > 0.1 else "#888"
    axes.add_patch(FancyArrowPatch(start, end, connectionstyle=f"arc3,rad={bend}", arrowstyle="-|>", mutation_scale=12,
                                   linewidth=1 + 4 * share, color=colour, shrinkA=20, shrinkB=20))
    middle = start[0] + dx / 2 + bend / 2 * dy, start[1] + dy / 2 - bend / 2 * dx
    axes.text(*middle, "\n".join(fifos), fontsize=7, ha="center", va="center",
              bbox={"boxstyle": "square,pad=0.1", "facecolor": "white", "edgecolor": "none", "alpha": 0.8})


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


def _new_axes(width: float = 9) -> Any:
    from matplotlib import pyplot

    return pyplot.subplots(figsize=(width, 4))[1]
