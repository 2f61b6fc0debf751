// The timeline of one sample: a row per module, loops as wide bars, stalls as narrow ones on top.

const span_kinds = ["loop", "empty_stall", "full_stall", "memory_stall"];

/// A row of the data, with names.
function named_span([module, kind, item, begin, end, cycles, iterations, spans]) {
  return { module, kind, item, begin, end, cycles, iterations, spans };
}

/// How strongly a bar is drawn: as much as its spans fill it, but never invisible.
function strength(span) {
  const share = span.cycles / Math.max(1, span.end - span.begin);
  return Math.round(255 * (0.3 + 0.7 * Math.min(1, share))).toString(16).padStart(2, "0");
}

/// The loops of a module in their order; so are their colours, again from the first when there are no more.
function loops_of(module) {
  return data.loops.filter((row) => row.core === 0 && row.module === module).map((row) => row.loop);
}

const loop_colours = 3;

function loop_colour(i) {
  return `loop-${i % loop_colours}`;
}

function span_colour(span) {
  return colour(span.kind === "loop" ? loop_colour(loops_of(span.module).indexOf(span.item)) : span.kind);
}

/// Names of the loops by colour, then the stalls.
function timeline_legend() {
  const names = Array.from({ length: loop_colours }, () => new Set());
  for (const row of data.modules) loops_of(row.module).forEach((loop, i) => names[i % loop_colours].add(loop));
  const loops = names.map((set, i) => [loop_colour(i), "loop " + [...set].join(", ")]).filter((_, i) => names[i].size > 0);
  const memory = data.cycle_classes.includes("memory_stall") ? [["memory_stall", "memory stall"]] : [];
  return legend([...loops, ["empty_stall", "empty stall"], ["full_stall", "full stall"], ...memory]);
}

function span_text(span) {
  const what = span.kind === "loop" ? `loop ${span.item}` : `${in_words(span.kind)} of ${span.item}`;
  const several = span.spans > 1 ? `, in ${whole(span.spans)} spans` : "";
  const iterations = span.kind === "loop" ? `, ${count_of(span.iterations, "iteration")}` : "";
  return [`${what}: ${count_of(span.cycles, "cycle")}${iterations}${several}`, `cycle ${whole(span.begin)} to ${whole(span.end - 1)}`];
}

function span_dataset(kind, spans) {
  const palette = new Map();
  const shade = (span) => {
    const key = span.module + span.item;
    if (!palette.has(key)) palette.set(key, span_colour(span));
    return palette.get(key) + strength(span);
  };
  return {
    label: in_words(kind),
    data: spans.map((span) => ({ x: [span.begin, span.end], y: span.module, span })),
    backgroundColor: spans.map(shade),
    grouped: false,
    categoryPercentage: 1,
    barPercentage: kind === "loop" ? 0.8 : 0.36,
    maxBarThickness: kind === "loop" ? 36 : 16,
    borderSkipped: false,
    order: kind === "loop" ? 1 : 0, // smaller is in front
  };
}

const fewest_cycles_shown = 50;

/// All cycles are those of the run. Zoom is how often the part that is shown has been halved. `looked` is told of the
/// part, and may have finer bars for it.
class Timeline {
  constructor() {
    this.zoom = element("input", { type: "range", min: 0, max: 8, step: 0.25, value: 0 });
    this.halvings = 0;
    this.place = 0.5;
    this.position = element("input", { type: "range", min: 0, max: 1, step: 0.001, value: 0.5 });
    by_id("timeline-controls").append(labelled("Zoom", this.zoom), labelled("Position", this.position));
    this.zoom.addEventListener("input", () => this.look(Number(this.zoom.value), this.place));
    this.position.addEventListener("input", () => this.look(this.halvings, Number(this.position.value)));
    by_id("timeline-chart").before(timeline_legend());
    by_id("timeline-chart").addEventListener("wheel", (event) => this.wheel(event), { passive: false });
    this.shown = () => {};
    this.looked = () => {};
  }

  /// Zooms where the pointer is; sideways, it moves.
  wheel(event) {
    const x = this.entry && this.entry.chart.scales.x;
    if (!x || (this.halvings === 0 && event.deltaY > 0)) return; // the page scrolls
    event.preventDefault();
    const sideways = event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY);
    const { min, max } = this.part();
    const length = this.end - this.begin;
    const halvings = sideways ? this.halvings : Math.min(Number(this.zoom.max), Math.max(0, this.halvings - event.deltaY / 240));
    const shown = length / 2 ** halvings;
    const under = x.getValueForPixel(event.clientX - this.entry.canvas.getBoundingClientRect().left);
    const begin = sideways ? min + ((event.deltaX || event.deltaY) / 600) * shown : under - ((under - min) / (max - min)) * shown;
    const place = length > shown ? (begin - this.begin) / (length - shown) : 0.5;
    this.look(halvings, Math.min(1, Math.max(0, place)));
  }

  show(timeline) {
    this.spans = timeline.spans.map(named_span);
    [this.begin, this.end] = [timeline.begin, timeline.end];
    this.zoom.max = Math.max(0, Math.floor(4 * Math.log2((this.end - this.begin) / fewest_cycles_shown)) / 4);
    if (this.entry) remove_chart(this.entry);
    this.look_back();
    const cycles = count_of(timeline.end - timeline.begin, "cycle");
    this.entry = add_chart(by_id("timeline-chart"), `Timeline of sample ${timeline.sample}, ${cycles}`, () => this.options());
    by_id("timeline-note").textContent =
      `Sample ${timeline.sample} on core ${timeline.core}: ${cycles}, ${whole(this.begin)} to ${whole(this.end - 1)}.`;
    this.shown(timeline);
  }

  /// The part of the sample that zoom and position leave.
  part() {
    const length = (this.end - this.begin) / 2 ** this.halvings;
    const begin = this.begin + (this.end - this.begin - length) * this.place;
    return { min: begin, max: begin + length };
  }

  look_back() {
    [this.halvings, this.place] = [0, 0.5];
    [this.zoom.value, this.position.value] = [0, 0.5];
  }

  /// Other bars for the part that is shown: finer ones.
  show_spans(spans) {
    this.spans = spans.map(named_span);
    this.entry.chart.data = this.options().data;
    this.entry.chart.update("none");
  }

  look(halvings, place) {
    if (!this.entry) return;
    [this.halvings, this.place] = [halvings, place];
    [this.zoom.value, this.position.value] = [halvings, place];
    Object.assign(this.entry.chart.options.scales.x, this.part());
    this.entry.chart.update("none");
    this.looked(this.part());
  }

  options() {
    return {
      type: "bar",
      data: {
        labels: data.modules.map((row) => row.module),
        datasets: span_kinds.map((kind) => span_dataset(kind, this.spans.filter((s) => s.kind === kind))),
      },
      options: {
        indexAxis: "y",
        interaction: { mode: "nearest", intersect: true },
        scales: {
          x: { ...this.part(), title: axis_title("cycle"), ticks: { ...whole_ticks, includeBounds: false } },
          y: { grid: { display: true }, ticks: { autoSkip: false } },
        },
        plugins: {
          tooltip: {
            callbacks: {
              title: (items) => items[0].raw.y,
              label: (item) => span_text(item.raw.span),
            },
          },
        },
      },
    };
  }
}
