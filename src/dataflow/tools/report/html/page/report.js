// Fills the sections of the page, from top to bottom.

const lane_cycles = (data.headline.total_cycles - data.headline.load_cycles) * data.headline.cores;

function show_headline() {
  const h = data.headline;
  const load = h.load_cycles > 0 && `the first ${count_of(h.load_cycles, "cycle")} of the total load memories, before cycle 0 of all that follows`;
  by_id("machine").textContent = machine_text(h, load);
  fill_figures(by_id("headline"), [
    ["cycles", whole(h.total_cycles)],
    ["ms", decimal(h.milliseconds, 3)],
    ["samples", whole(h.samples)],
    [h.cores_are, whole(h.cores)],
    ["samples per second", h.milliseconds > 0 ? whole((h.samples / h.milliseconds) * 1000) : "-"],
    ["median latency [ms]", data.latency ? decimal(milliseconds(data.latency.median), 3) : "-"],
  ]);
  by_id("bound-by").append(...data.warnings.map((text) => element("p", { role: "note" }, `Warning: ${text}`)));
  const [bound, ...reasons] = data.bound_by;
  if (!bound) return;
  by_id("bound-by").append(element("p", {}, bound), element("ul", {}, ...reasons.map((text) => element("li", {}, text))));
}

function show_graph() {
  if (!DataflowGraph.is_there()) return leave_out("graph");
  by_id("graph-legend").append(graph_legend());
  new DataflowGraph(by_id("graph-box")).show({
    modules: data.modules,
    fifos: rows_of(data.fifos, null, (row) => row.fifo, ["writes", "reads", "full_stall_cycles", "empty_stall_cycles"], ["max_occupancy"]),
    lane_cycles, total_cycles: data.headline.total_cycles, path: data.critical_path,
  });
}

function module_bars() {
  const series = data.cycle_classes.map((name, c) => ({ name, values: data.modules.map((row) => percent(row.cycles[c], lane_cycles)) }));
  return stacked_bars(data.modules.map((row) => row.module), series, { max: 100, title: axis_title("% of all cycles of all cores") }, module_tooltip);
}

function module_tooltip(item) {
  const cycles = data.modules[item.dataIndex].cycles[item.datasetIndex];
  return `${item.dataset.label}: ${decimal(percent(cycles, lane_cycles), 2)} %, ${count_of(cycles, "lane-cycle")}`;
}

function show_modules() {
  const box = by_id("module-chart");
  box.before(legend(data.cycle_classes.map((name) => [name, in_words(name)])));
  add_chart(box, "Where the cycles of each module went; the table below has the figures", module_bars);
  new SortableTable(by_id("module-table"), "Where the cycles of each module went, in per cent", [
    { title: "module", value: (row) => row.module },
    ...data.cycle_classes.map((name, c) =>
      figure(in_words(name) + " %", (row) => percent(row.cycles[c], lane_cycles), (row) => decimal(percent(row.cycles[c], lane_cycles), 2))),
  ], data.modules);
}

function show_stalls() {
  const rows = [...data.stalls].sort((a, b) => b.cycles - a.cycles);
  new SortableTable(by_id("stall-table"), "What the modules wait for", [
    { title: "module", value: (row) => row.module },
    { title: "stall", value: (row) => row.kind, fill: (cell, row) => fill_with_swatch(cell, row.kind) },
    { title: "FIFO or block RAM", value: (row) => row.item },
    { title: "waits for", value: (row) => row.waits_for || "-" },
    figure("lane-cycles", (row) => row.cycles),
    figure("% of all", (row) => percent(row.cycles, lane_cycles), (row) => decimal(percent(row.cycles, lane_cycles), 2)),
  ], rows, { box: "high" });
}

function path_bars() {
  const modules = data.modules.map((row) => row.module);
  const cycles = (module, cause) =>
    data.critical_path.rows.reduce((sum, row) => sum + (row.module === module && row.cause === cause ? row.cycles : 0), 0);
  const series = data.path_causes.map((name) => ({
    name, colour: path_colour(name), values: modules.map((module) => percent(cycles(module, name), data.headline.total_cycles)),
  }));
  return stacked_bars(modules, series, { title: axis_title("% of the total") }, (item) => `${item.dataset.label}: ${decimal(item.raw, 2)} %`);
}

function show_critical_path() {
  const path = data.critical_path;
  if (!path || path.rows.length === 0) return leave_out("critical-path");
  by_id("path-note").textContent =
    `Along which operations the ${whole(data.headline.total_cycles)} cycles came about: from the last result back, each module until it ` +
    `last waited, then the one it waited for. Core ${path.core}, the last to end. Making something else faster does not make the run shorter.`;
  const box = by_id("path-chart");
  box.before(legend(data.path_causes.map((cause) => [path_colour(cause), in_words(cause)])));
  add_chart(box, "The critical path by module and cause; the table below has the figures", path_bars);
  new SortableTable(by_id("path-table"), "Critical path", [
    { title: "module", value: (row) => row.module },
    { title: "loop", value: (row) => row.loop || "-" },
    { title: "cause", value: (row) => in_words(row.cause) },
    { title: "FIFO or block RAM", value: (row) => row.item || "-" },
    figure("cycles", (row) => row.cycles),
    figure("% of the total", (row) => percent(row.cycles, data.headline.total_cycles), (row) => decimal(percent(row.cycles, data.headline.total_cycles), 2)),
    figure("crossings", (row) => row.crossings, (row) => (row.crossings > 0 ? whole(row.crossings) : "-")),
  ], path.rows, { box: "high" });
}

/// The change of one step; what is no number is shown, and sorted behind all others.
function step_column(title, side) {
  const step = (row) => row[side];
  const change = (row) => step(row).outcome === "finished" ? step(row).change_cycles : Number.MAX_VALUE;
  const text = (row) => step(row).outcome === "invalid" ? "not valid" : step(row).outcome !== "finished" ? step(row).outcome
    : (step(row).change_cycles > 0 ? "+" : "") + whole(step(row).change_cycles);
  return figure(title, change, text);
}

function alternative_text(row) {
  const outcome = row.outcome === "finished" ? `${(row.change_cycles > 0 ? "+" : "") + whole(row.change_cycles)} cycles` : row.outcome;
  return ` ${row.key} ${row.other}: ${outcome}.`;
}

function show_sensitivities() {
  if (data.sensitivities.length === 0) return leave_out("sensitivities");
  const moves = (step) => step.outcome === "deadlock" || (step.outcome === "finished" && step.change_cycles !== 0);
  const rows = data.sensitivities.filter((row) => moves(row.down) || moves(row.up));
  by_id("sensitivity-note").textContent =
    `${count_of(rows.length, "key")} of ${data.sensitivities.length} change something by a step; cycles of the total.` +
    data.alternatives.map(alternative_text).join("");
  const effect = (row) => Math.max(...[row.down, row.up].map((step) => Math.abs(step.change_cycles ?? 0)));
  new SortableTable(by_id("sensitivity-table"), "Sensitivities", [
    { title: "key", value: (row) => row.key },
    figure("value", (row) => row.value),
    step_column("one less", "down"),
    step_column("one more", "up"),
  ], rows.sort((a, b) => effect(b) - effect(a)), { box: "high" });
}

function spark_options(profile, capacity) {
  const line = (values, options) => ({ data: values, stepped: "middle", pointRadius: 0, ...options });
  return {
    type: "line",
    data: {
      labels: profile.mean.map((_, i) => `${Math.round((100 * i) / profile.mean.length)} % of the sample`),
      datasets: [
        line(profile.mean, { label: "mean", fill: "origin", borderWidth: 1, borderColor: colour("accent"), backgroundColor: colour("accent") + "66" }),
        line(profile.max, { label: "largest", borderWidth: 1, borderColor: colour("quiet") }),
      ],
    },
    options: {
      interaction: { mode: "index", intersect: false },
      layout: { padding: 1 },
      scales: { x: { display: false }, y: { display: false, min: 0, max: capacity * 1.05 } },
      plugins: { tooltip: { displayColors: false } },
    },
  };
}

/// The FIFO table, with the occupancies of the sample that the timeline shows.
class FifoTable {
  constructor() {
    this.core = null;
    this.sparks = new Map();
    add_core_choice(by_id("fifo-controls"), (core) => {
      this.core = core;
      this.table.show(this.rows());
    });
    this.table = new SortableTable(by_id("fifo-table"), "FIFOs", this.columns(), this.rows());
    this.note(null);
  }

  rows() {
    return rows_of(data.fifos, this.core, (row) => row.fifo, ["writes", "reads", "full_stall_cycles", "empty_stall_cycles"], ["max_occupancy"]);
  }

  columns() {
    const columns = [
      { title: "FIFO", value: (row) => row.fifo },
      { title: "kind", value: (row) => in_words(row.kind) },
      figure("depth", (row) => row.depth),
      figure("write latency", (row) => row.write_latency),
      figure("max occupancy", (row) => row.max_occupancy),
      figure("writes", (row) => row.writes),
      figure("reads", (row) => row.reads),
      figure("full stall", (row) => row.full_stall_cycles),
      figure("empty stall", (row) => row.empty_stall_cycles),
    ];
    if (data.timelines.length > 0)
      columns.splice(1, 0, { title: "occupancy", value: (row) => this.mean_of(row.fifo), fill: (cell, row) => cell.append(this.spark_box(row.fifo)) });
    return columns;
  }

  mean_of(fifo) {
    const profile = this.timeline && this.timeline.occupancy[fifo];
    return profile ? profile.mean.reduce((sum, mean) => sum + mean, 0) / profile.mean.length : 0;
  }

  /// A FIFO has one box, whatever the rows: its chart moves along.
  spark_box(fifo) {
    if (!this.sparks.has(fifo)) this.sparks.set(fifo, { box: element("div", { class: "spark" }) });
    return this.sparks.get(fifo).box;
  }

  show_occupancy(timeline) {
    this.timeline = timeline;
    for (const [fifo, spark] of this.sparks) {
      if (spark.entry) remove_chart(spark.entry);
      const profile = timeline.occupancy[fifo];
      const capacity = Math.max(1, data.fifos.find((row) => row.fifo === fifo).capacity);
      const label = `Tokens in ${fifo} during sample ${timeline.sample}, of ${capacity}: ${decimal(this.mean_of(fifo), 2)} on average`;
      spark.entry = profile && add_chart(spark.box, label, () => spark_options(profile, capacity));
    }
    this.table.arrange();
    this.note(timeline);
  }

  note(timeline) {
    const sum = data.headline.cores > 1 ? ", summed up over cores; depth and occupancy in tokens, the largest of any core" : "; depth and occupancy in tokens";
    const spark = timeline && this.sparks.size > 0
      ? ` The curves are the tokens during sample ${timeline.sample} on core ${timeline.core}: mean (filled) and largest, up to the FIFO's capacity.` : "";
    by_id("fifo-note").textContent = `Stalls in cycles of the waiting module${sum}.${spark}`;
  }
}

function show_loops() {
  let table = null;
  const rows = (core) =>
    rows_of(data.loops, core, (row) => `${row.module}.${row.loop}`, ["entries", "iterations", "port_conflict_cycles", "recurrence_cycles"], []);
  const trips = (row) => (row.entries > 0 ? row.iterations / row.entries : 0);
  add_core_choice(by_id("loop-controls"), (core) => table.show(rows(core)));
  table = new SortableTable(by_id("loop-table"), "Loops", [
    { title: "loop", value: (row) => `${row.module}.${row.loop}` },
    figure("II target", (row) => row.ii_target),
    figure("II achieved", (row) => row.ii),
    { title: "limited by", value: (row) => row.limited_by || "-" },
    figure("II of recurrence", (row) => row.ii_recurrence),
    figure("depth", (row) => row.depth),
    figure("entries", (row) => row.entries),
    figure("iterations", (row) => row.iterations),
    figure("trip count", trips, (row) => (row.entries > 0 ? decimal(trips(row), 1) : "-")),
    figure("port conflict cycles", (row) => row.port_conflict_cycles),
    figure("recurrence cycles", (row) => row.recurrence_cycles),
  ], rows(null), { row_class: (row) => (row.ii > row.ii_target ? "changed" : "") });
}

function show_hazards() {
  if (data.hazards.length === 0) return leave_out("hazards");
  const distances = (row) => row.distances.map((count, i) => `${i + 1}: ${whole(count)}`).join(", ") || "-";
  new SortableTable(by_id("hazard-table"), "Hazards", [
    { title: "loop", value: (row) => `${row.module}.${row.loop}` },
    { title: "memory", value: (row) => row.bram },
    figure("II", (row) => row.ii),
    { title: "read stage", value: (row) => (row.reads ? row.read_stage : "-") },
    figure("write stage", (row) => row.write_stage),
    figure("span", (row) => row.span),
    figure("smallest distance", (row) => row.smallest_distance ?? Number.MAX_VALUE, (row) => row.smallest_distance ?? "-"),
    { title: "below the span", value: distances },
    figure("hazards", (row) => row.hazards),
    { title: "handling", value: (row) => row.handling },
    figure("comparators", (row) => row.comparators),
    figure("register bits", (row) => row.register_bits),
  ], data.hazards, { row_class: (row) => (row.hazards > 0 && row.handling === "report" ? "changed" : "") });
}

function histogram_bars() {
  const { first, width, counts } = data.latency.histogram;
  const range = (i) => `${whole(first + i * width)} to ${whole(first + (i + 1) * width - 1)} cycles`;
  return {
    type: "bar",
    data: {
      labels: counts.map((_, i) => whole(first + i * width)),
      datasets: [{ data: counts, backgroundColor: colour("busy"), barPercentage: 1, categoryPercentage: 0.94 }],
    },
    options: {
      scales: {
        x: { title: axis_title(`latency [cycles], bins of ${whole(width)} from the cycle named`), grid: { display: false }, ticks: { maxRotation: 50 } },
        y: { title: axis_title("samples"), beginAtZero: true, ticks: { precision: 0 } },
      },
      plugins: { tooltip: { callbacks: { title: (items) => range(items[0].dataIndex), label: (item) => count_of(item.raw, "sample") } } },
    },
  };
}

/// Bytes per cycle and the queue, stretch by stretch.
function traffic_lines() {
  const { cycles, stretches } = data.external_memory.over_time;
  const line = (label, value, name, axis) => ({
    label, data: stretches.map((s) => ({ x: s.begin_cycle, y: value(s) })), stepped: true, pointRadius: 0, borderWidth: 1.5,
    borderColor: colour(name), backgroundColor: colour(name), yAxisID: axis,
  });
  return {
    type: "line",
    data: { datasets: [
      line("bytes per cycle", (s) => s.bytes / cycles, "busy", "y"),
      line("longest queue [bursts]", (s) => s.largest_queue, "memory_stall", "queue"),
    ] },
    options: { scales: {
      x: { type: "linear", title: axis_title("cycle"), ticks: whole_ticks },
      y: { beginAtZero: true, title: axis_title("bytes per cycle") },
      queue: { beginAtZero: true, position: "right", grid: { display: false }, title: axis_title("bursts") },
    } },
  };
}

function show_external_memory() {
  const memory = data.external_memory;
  if (!memory) return leave_out("external-memory");
  const alone = memory.compute_alone_cycles === null ? "" : `, compute alone ${count_of(memory.compute_alone_cycles, "cycle")}`;
  by_id("external-memory-note").textContent =
    `${whole(memory.bytes)} bytes, ${decimal(memory.gb_per_s, 2)} GB/s; the controller is busy for ` +
    `${decimal(100 * memory.controller.utilisation, 1)} % of the time, its longest queue is ` +
    `${count_of(memory.controller.largest_queue, "burst")}. Memory alone would take ` +
    `${count_of(memory.memory_alone_cycles, "cycle")}${alone}.`;
  add_chart(by_id("external-memory-chart"), "What arrives at the controller, and its queue", traffic_lines);
  new SortableTable(by_id("port-table"), "Ports", [
    figure("port", (row) => row.port),
    figure("bytes read", (row) => row.bytes_read),
    figure("GB/s", (row) => row.gb_per_s, (row) => decimal(row.gb_per_s, 2)),
    figure("busy %", (row) => 100 * row.utilisation, (row) => decimal(100 * row.utilisation, 1)),
  ], memory.ports);
  new SortableTable(by_id("master-table"), "Masters; latencies of bursts in cycles", [
    figure("core", (row) => row.core),
    { title: "master", value: (row) => row.master },
    figure("port", (row) => row.port),
    figure("bursts", (row) => row.bursts),
    figure("bytes", (row) => row.bytes),
    figure("GB/s", (row) => row.gb_per_s, (row) => decimal(row.gb_per_s, 3)),
    figure("least", (row) => row.latency_least),
    figure("median", (row) => row.latency_median),
    figure("90 %", (row) => row.latency_90),
    figure("most", (row) => row.latency_most),
  ], memory.masters, { box: "high" });
}

function show_latency() {
  if (!data.latency) return leave_out("latency");
  const names = [["min", "min"], ["tenth", "10 %"], ["median", "median"], ["ninetieth", "90 %"], ["max", "max"]];
  fill_figures(by_id("latency-figures"), names.map(([key, text]) => [text + " [cycles]", whole(data.latency[key])]));
  add_chart(by_id("latency-chart"), `Histogram of the latency of ${count_of(data.headline.samples, "sample")}`, histogram_bars);
}

function show_timelines(fifo_table) {
  if (data.timelines.length === 0) return leave_out("timeline");
  new PackedSamples((shown) => fifo_table.show_occupancy(shown));
}

function show_pictures() {
  if (data.pictures.length === 0) return leave_out("pictures");
  for (const picture of data.pictures)
    by_id("picture-list").append(element("figure", {},
      element("img", { src: "data:image/png;base64," + picture.png, alt: picture.title, loading: "lazy" }),
      element("figcaption", {}, picture.title)));
}

set_chart_defaults();
show_headline();
show_graph();
show_modules();
show_stalls();
show_critical_path();
show_sensitivities();
show_timelines(new FifoTable());
show_loops();
show_memories();
show_resources();
show_hazards();
show_external_memory();
show_latency();
show_pictures();
show_configuration();
