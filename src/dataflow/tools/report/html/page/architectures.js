// Fills the page of architectures side by side, from top to bottom. Its data: {rows}, those of architectures.csv.

const bar_colours = ["loop-0", "loop-1", "loop-2", "empty_stall", "full_stall", "accent", "setup", "recurrence"];
const architectures = [...new Set(data.rows.map((row) => row.architecture))];
const workloads = [...new Set(data.rows.map((row) => row.workload))];

function row_of(architecture, workload) {
  return data.rows.find((row) => row.architecture === architecture && row.workload === workload);
}

function bar_colour(i) {
  return bar_colours[i % bar_colours.length];
}

function show_headline() {
  by_id("machine").textContent = `${count_of(architectures.length, "architecture")} on ${count_of(workloads.length, "workload")}`;
}

function time_bars() {
  return {
    type: "bar",
    data: {
      labels: architectures,
      datasets: workloads.map((workload, i) => ({
        label: workload,
        data: architectures.map((architecture) => row_of(architecture, workload).milliseconds),
        backgroundColor: colour(bar_colour(i)),
      })),
    },
    options: {
      indexAxis: "y",
      scales: { x: { title: axis_title("ms"), beginAtZero: true } },
      plugins: { tooltip: { callbacks: { label: (item) => `${item.dataset.label}: ${decimal(item.parsed.x, 2)} ms` } } },
    },
  };
}

function show_time() {
  const box = by_id("time-chart");
  box.before(legend(workloads.map((workload, i) => [bar_colour(i), workload])));
  box.style.height = `${60 + architectures.length * (12 + 8 * workloads.length)}px`;
  add_chart(box, "Milliseconds by architecture and workload; the table below has the figures", time_bars);
}

/// Geometric mean over the workloads that both finish; null if there are none.
function relative_time(architecture) {
  const ratios = workloads
    .map((workload) => [row_of(architecture, workload).milliseconds, row_of(architectures[0], workload).milliseconds])
    .filter(([time, first]) => time > 0 && first > 0)
    .map(([time, first]) => Math.log(time / first));
  return ratios.length > 0 ? Math.exp(ratios.reduce((a, b) => a + b) / ratios.length) : null;
}

function cost_points() {
  return architectures
    .map((name) => ({ name, x: row_of(name, workloads[0]).ramb36, y: relative_time(name) }))
    .filter((point) => point.y !== null);
}

/// From few block RAMs to many, each faster than all before.
function front_of(points) {
  const front = [];
  for (const point of [...points].sort((a, b) => a.x - b.x || a.y - b.y))
    if (front.length === 0 || point.y < front[front.length - 1].y) front.push(point);
  return front;
}

function cost_chart() {
  const points = cost_points();
  return {
    type: "scatter",
    data: {
      datasets: [
        { data: points, pointRadius: 5, backgroundColor: colour("accent") },
        { data: front_of(points), showLine: true, stepped: true, pointRadius: 7, borderColor: colour("busy"), backgroundColor: colour("busy") },
      ],
    },
    options: {
      scales: {
        x: { title: axis_title("RAMB36, all cores") },
        y: { type: "logarithmic", title: axis_title(`time, ${architectures[0]} = 1`) },
      },
      plugins: { tooltip: { callbacks: { label: ({ raw }) => `${raw.name}: ${decimal(raw.y, 3)}, ${decimal(raw.x, 1)} RAMB36` } } },
    },
  };
}

function show_cost() {
  if (cost_points().length < 2) return leave_out("cost");
  const box = by_id("cost-chart");
  box.before(legend([["accent", "architecture"], ["busy", "beaten by no other"]]));
  add_chart(box, "Time against block RAM; the table below has the figures", cost_chart);
}

function or_deadlock(text) {
  return (row) => (row.deadlocked ? "deadlock" : text(row));
}

function quality(title, name) {
  return figure(title, (row) => row[name], (row) => (row.judged_samples > 0 ? decimal(100 * row[name], 1) + " %" : "-"));
}

function show_figures() {
  const judged = data.rows.some((row) => row.judged_samples > 0);
  new SortableTable(by_id("figures-table"), "All figures", [
    { title: "architecture", value: (row) => row.architecture },
    { title: "workload", value: (row) => row.workload },
    figure("ms", (row) => row.milliseconds, or_deadlock((row) => decimal(row.milliseconds, 3))),
    figure("cycles", (row) => row.total_cycles, or_deadlock((row) => whole(row.total_cycles))),
    figure("empty stalls", (row) => row.empty_stall_cycles),
    figure("full stalls", (row) => row.full_stall_cycles),
    figure("port conflicts", (row) => row.port_conflict_cycles),
    figure("RAMB36", (row) => row.ramb36, (row) => decimal(row.ramb36, 1)),
    ...["lut", "ff", "dsp"].map((name) => figure(name.toUpperCase(), (row) => row[name], (row) => decimal(row[name], 0))),
    ...(judged ? [quality("precision", "precision"), quality("recall", "recall"), quality("closed", "closed"), quality("thin", "thin")] : []),
  ], data.rows);
}

set_chart_defaults();
show_headline();
show_time();
show_cost();
show_figures();
