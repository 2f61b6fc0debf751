// The points of a sweep, their figures, and which of them are on the Pareto front.

const metrics = [
  { name: "total_cycles", title: "total cycles", digits: 0 },
  { name: "milliseconds", title: "milliseconds", digits: 3 },
  { name: "stall_cycles", title: "stall cycles", digits: 0 },
  { name: "port_conflict_cycles", title: "port conflict cycles", digits: 0 },
  { name: "fifo_full_stall_cycles", title: "FIFO full stall cycles", digits: 0 },
  { name: "fifo_empty_stall_cycles", title: "FIFO empty stall cycles", digits: 0 },
  { name: "ramb36", title: "RAMB36", digits: 1 },
  { name: "lut", title: "LUT", digits: 0 },
  { name: "ff", title: "FF", digits: 0 },
  { name: "dsp", title: "DSP", digits: 0 },
];

const done_points = data.points.filter((point) => point.status === "done");

function metric_text(metric, value) {
  return Number.isInteger(value) ? whole(value) : decimal(value, metric.digits);
}

/// The last part of a key says most; the whole is in the tooltip.
function short_name(column) {
  return column.split(".").slice(-2).join(".");
}

/// A file by its name, and no word longer than an axis is wide.
function short_text(text) {
  const name = text.replace(/^.*\//, "").replace(/\.yaml$/, "");
  return name.length > 18 ? name.slice(0, 17) + "\u2026" : name;
}

function settings_of(point) {
  return data.columns.map((column, i) => `${short_name(column)} = ${short_text(point.values[i])}`);
}

/// The points that no other beats in figures `a` and `b`, by `a`. Points that are equal in both are all on it.
function pareto_front(points, a, b) {
  const sorted = [...points].sort((p, q) => p[a] - q[a] || p[b] - q[b]);
  const front = [];
  for (const point of sorted) {
    const last = front[front.length - 1];
    if (!last || point[b] < last[b] || (point[b] === last[b] && point[a] === last[a])) front.push(point);
  }
  return front;
}

/// Where a text stands on an axis: numbers by value, words in the order in which they came.
function scale_of(texts) {
  const numeric = texts.every((text) => text.trim() !== "" && Number.isFinite(Number(text)));
  const words = [...new Set(texts)];
  const value = numeric ? Number : (text) => words.indexOf(text);
  return { numeric, words, value };
}
