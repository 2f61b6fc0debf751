// Parallel coordinates on a canvas: thousands of lines, an axis per key that varies and per figure that differs.

const axis_distance = 130; // px, at least
const parallel_height = 380;
const margin = { top: 56, bottom: 40, side: 80 };
const most_words = 24; // along an axis: a line of text each
const many_words = 12; // from here on, no room is left above a word for its lines

function key_axes() {
  return data.columns
    .map((column, i) => {
      const texts = data.points.map((point) => point.values[i]);
      const scale = scale_of(texts);
      return { title: short_name(column), scale, value: (point) => scale.value(point.values[i]), is_key: true,
        text: (value) => (scale.numeric ? String(value) : short_text(scale.words[value])), distinct: new Set(texts).size };
    })
    .filter((axis) => axis.distinct > 1);
}

/// Milliseconds only say more than cycles where the clock varies; sums over FIFOs hardly more than stalls.
function metric_axes() {
  const is_left_out = (metric) => metric.name.startsWith("fifo_") ||
    (metric.name === "milliseconds" && !data.columns.includes("accelerator.clock_mhz"));
  return metrics
    .filter((metric) => !is_left_out(metric))
    .map((metric) => ({ title: metric.title, value: (point) => (point.status === "done" ? point[metric.name] : null),
      text: (value) => metric_text(metric, value), is_key: false,
      distinct: new Set(done_points.map((point) => point[metric.name])).size }))
    .filter((axis) => axis.distinct > 1);
}

function with_extent(axis) {
  const values = data.points.map(axis.value).filter((value) => value !== null);
  return { ...axis, low: Math.min(...values), high: Math.max(...values), range: null };
}

function has_words(axis) {
  return axis.is_key && !axis.scale.numeric && axis.scale.words.length <= most_words;
}

function has_many_words(axis) {
  return has_words(axis) && axis.scale.words.length > many_words;
}

class ParallelCoordinates {
  constructor(is_marked, changed) {
    this.is_marked = is_marked;
    this.changed = changed;
    this.axes = [...key_axes(), ...metric_axes()].map(with_extent);
    if (this.axes.length === 0) {
      leave_out("parallel");
      return;
    }
    this.left = has_many_words(this.axes[0]) ? margin.side + 50 : margin.side;
    this.canvas = element("canvas", { role: "img", "aria-label": "A line for each point across the axes of keys and figures; the table below has the same" });
    by_id("parallel-box").append(this.canvas);
    by_id("parallel-legend").append(legend([["accent", "on the Pareto front"], ["idle_after", "others"], ["port_conflict", "deadlock, without figures"]]));
    for (const [name, handle] of [["pointerdown", "begin"], ["pointermove", "move"], ["pointerup", "end"]])
      this.canvas.addEventListener(name, (event) => this[handle](event));
    addEventListener("resize", () => this.draw());
    for (const query of ["(prefers-color-scheme: dark)", "print"])
      matchMedia(query).addEventListener("change", () => this.draw());
    this.draw();
  }

  is_kept(point) {
    return this.axes.every((axis) => {
      const value = axis.value(point);
      return !axis.range || (value !== null && value >= axis.range[0] && value <= axis.range[1]);
    });
  }

  x_of(i) {
    return this.left + (this.axes.length < 2 ? 0 : (i * (this.width - this.left - margin.side)) / (this.axes.length - 1));
  }
  y_of(axis, value) {
    const share = axis.high > axis.low ? (value - axis.low) / (axis.high - axis.low) : 0.5;
    return parallel_height - margin.bottom - share * (parallel_height - margin.top - margin.bottom);
  }
  value_at(axis, y) {
    const share = (parallel_height - margin.bottom - y) / (parallel_height - margin.top - margin.bottom);
    return axis.low + Math.min(1, Math.max(0, share)) * (axis.high - axis.low);
  }

  draw() {
    if (!this.canvas) return;
    this.width = Math.max(by_id("parallel-box").clientWidth, this.left + margin.side + axis_distance * (this.axes.length - 1));
    const ratio = devicePixelRatio || 1;
    this.canvas.width = this.width * ratio;
    this.canvas.height = parallel_height * ratio;
    this.canvas.style.width = `${this.width}px`;
    this.canvas.style.height = `${parallel_height}px`;
    this.pen = this.canvas.getContext("2d");
    this.pen.scale(ratio, ratio);
    const kept = data.points.filter((point) => this.is_kept(point));
    const level = (point) => (this.is_marked(point) ? 2 : point.status === "deadlock" ? 1 : 0);
    this.pen.globalAlpha = 0.15;
    if (kept.length < data.points.length) data.points.forEach((point) => this.line(point, colour("idle_before"), 1));
    this.pen.globalAlpha = kept.length > 200 ? 0.5 : 0.9;
    for (const point of [...kept].sort((a, b) => level(a) - level(b)))
      this.line(point, colour(["idle_after", "port_conflict", "accent"][level(point)]), level(point) === 2 ? 2 : 1);
    this.pen.globalAlpha = 1;
    this.axes.forEach((axis, i) => this.axis(axis, this.x_of(i)));
    by_id("parallel-note").textContent = `${whole(kept.length)} of ${count_of(data.points.length, "point")} kept.`;
  }

  line(point, stroke, width) {
    this.pen.strokeStyle = stroke;
    this.pen.lineWidth = width;
    this.pen.beginPath();
    this.axes.forEach((axis, i) => {
      const value = axis.value(point);
      if (value !== null) this.pen.lineTo(this.x_of(i), this.y_of(axis, value));
    });
    this.pen.stroke();
  }

  axis(axis, x) {
    const pen = this.pen;
    pen.strokeStyle = pen.fillStyle = colour("quiet");
    pen.lineWidth = 1;
    pen.beginPath();
    pen.moveTo(x, margin.top);
    pen.lineTo(x, parallel_height - margin.bottom);
    pen.stroke();
    pen.font = `12px ${getComputedStyle(document.body).fontFamily}`;
    pen.textAlign = "center";
    if (axis.range) {
      pen.fillStyle = colour("accent");
      pen.globalAlpha = 0.3;
      const top = this.y_of(axis, axis.range[1]);
      pen.fillRect(x - 6, top, 12, Math.max(3, this.y_of(axis, axis.range[0]) - top));
      pen.globalAlpha = 1;
    }
    pen.fillStyle = colour("text");
    const words = axis.title.split(/(?<=[. ])/);
    const half = Math.ceil(words.length / 2);
    [words.slice(0, half).join(""), words.slice(half).join("")].forEach((text, i) => pen.fillText(text, x, 16 + 15 * i, 150));
    pen.fillStyle = colour("quiet");
    for (const value of this.ticks(axis)) {
      const y = this.y_of(axis, value);
      if (has_many_words(axis)) this.text_over_lines(axis.text(value), x - 5, y + 4, "right");
      else this.text_over_lines(axis.text(value), x, y + (value === axis.low ? 16 : -6), "center");
    }
  }

  /// With a rim of the ground's colour, as lines meet where it stands.
  text_over_lines(text, x, y, align) {
    this.pen.textAlign = align;
    this.pen.strokeStyle = colour("card");
    this.pen.lineWidth = 4;
    this.pen.lineJoin = "round";
    this.pen.strokeText(text, x, y, 120);
    this.pen.fillText(text, x, y, 120);
  }

  /// Every word, as long as they have room; of numbers the ends.
  ticks(axis) {
    return has_words(axis) ? axis.scale.words.map((word, i) => i) : [...new Set([axis.low, axis.high])];
  }

  position(event) {
    const box = this.canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  }

  begin(event) {
    const { x, y } = this.position(event);
    const i = this.axes.findIndex((axis, k) => Math.abs(this.x_of(k) - x) < 20);
    if (i < 0) return;
    this.dragged = { axis: this.axes[i], from: y };
    if (event.isTrusted) this.canvas.setPointerCapture(event.pointerId);
  }
  move(event) {
    if (!this.dragged) return;
    const { axis, from } = this.dragged;
    const y = this.position(event).y;
    const ends = [this.value_at(axis, from), this.value_at(axis, y)];
    axis.range = Math.abs(y - from) < 4 ? null : [Math.min(...ends), Math.max(...ends)];
    this.draw();
  }
  end(event) {
    if (!this.dragged) return;
    this.move(event);
    this.dragged = null;
    this.changed();
  }
}
