// The search for the cheapest FIFO depths, and all that was tried.

class Sizing {
  /// `overrides()`: what is changed now; `found(overrides)`: the user takes an answer; `tried(rows, base)`: points of the front.
  constructor(overrides, found, tried) {
    Object.assign(this, { overrides, found, tried });
    this.within = element("input", { type: "number", min: 0, max: 1000000, step: "any", value: 5, "aria-label": "per cent" });
    this.start = element("button", { type: "button" }, "size FIFOs");
    this.stop = element("button", { type: "button", hidden: "" }, "cancel");
    this.progress = element("progress", { max: 1, value: 0, hidden: "", "aria-label": "Sizing" });
    by_id("sizing-controls").append(element("label", {}, "within", this.within, "%"), this.start, this.stop, this.progress);
    this.job = new BackgroundJob("sizing", (state) => this.show_progress(state));
    this.start.addEventListener("click", () => this.run());
    this.stop.addEventListener("click", () => this.job.cancel());
  }

  say(text) {
    by_id("sizing-note").textContent = text;
  }

  show_progress({ done, steps }) {
    this.progress.max = Math.max(1, steps);
    this.progress.value = done;
    this.say(`Step ${done} of ${steps || "?"}`);
  }

  is_running(runs) {
    this.start.disabled = runs;
    this.stop.hidden = this.progress.hidden = !runs;
  }

  async run() {
    this.is_running(true);
    this.say("Looking for the cheapest depths");
    by_id("sizing-table").replaceChildren();
    try {
      const base = this.overrides();
      const sizing = await this.job.start({ set: base, within: number_in(this.within) });
      sizing ? this.show(sizing, base) : this.say("Cancelled.");
    } catch (error) {
      this.say(error.message);
    }
    this.is_running(false);
  }

  overrides_of_depths(depths) {
    return Object.entries(depths).map(([fifo, depth]) => `accelerator.fifos.${fifo}.depth=${depth}`);
  }

  show(sizing, base) {
    const { answer } = sizing;
    this.say(`${whole(answer.total_cycles)} cycles for ${whole(answer.cost_luts)} LUT-equivalents a core (${whole(answer.luts)} LUTs and ${decimal(answer.ramb36, 1)} RAMB36), ${whole(answer.cost_of_cores)} for all cores with their memories; ` +
      `at most ${whole(sizing.bound_cycles)} allowed; ${sizing.proven ? "proven: nothing below that keeps the bound." : `not proven to be the cheapest, but: nothing below ${whole(sizing.least_cost_luts)} LUT-equivalents keeps the bound.`}`);
    const take = element("button", { type: "button", id: "take-sizing" }, "take these depths");
    take.addEventListener("click", () => this.found(this.overrides_of_depths(answer.depths)));
    by_id("sizing-note").append(" ", take);
    new SortableTable(by_id("sizing-table"), "Depths of the answer", [
      { title: "FIFO", value: (row) => row.fifo },
      figure("configured", (row) => row.configured_depth),
      figure("depth", (row) => row.depth),
      { title: "kind", value: (row) => in_words(row.kind) },
      figure("LUTs", (row) => row.luts),
      figure("RAMB36", (row) => row.ramb36, (row) => decimal(row.ramb36, 1)),
    ], sizing.fifos, { box: "high" });
    this.tried([answer, ...sizing.front].filter((point) => point.total_cycles !== null)
      .map((point) => ({ overrides: this.overrides_of_depths(point.depths), cycles: point.total_cycles, cost: point.cost_of_cores })), base);
  }
}

/// No other is at most as expensive and at most as long, and one of both less.
function is_on_front(row, rows) {
  return !rows.some((other) => other.cost <= row.cost && other.cycles <= row.cycles && (other.cost < row.cost || other.cycles < row.cycles));
}

/// All configurations whose cycles are known.
class Tried {
  constructor(chosen) {
    this.chosen = chosen;
    this.rows = [];
    this.known = new Set();
    this.entry = add_chart(by_id("tried-chart"), "Cycles against cost of all that was tried; the table below has the figures", () => this.scatter());
    this.table = new SortableTable(by_id("tried-table"), "Tried", [
      { title: "changes", value: (row) => row.overrides.join(" ") || "as recorded", wrap: true, fill: (cell, row) => this.fill_link(cell, row) },
      figure("cycles", (row) => row.cycles),
      figure("cost [LUT-equivalents]", (row) => row.cost),
    ], [], { box: "high" });
  }

  fill_link(cell, row) {
    const button = element("button", { type: "button", class: "link" }, row.overrides.map((text) => text.replace("accelerator.", "")).join(" ") || "as recorded");
    button.addEventListener("click", () => this.chosen(row.overrides));
    cell.append(button);
  }

  note(row) {
    const name = row.overrides.join();
    if (this.known.has(name)) return;
    this.known.add(name);
    this.rows.push(row);
  }

  /// All, and which of them is shown now.
  show(overrides) {
    this.now = overrides.join();
    draw(this.entry);
    this.table.show([...this.rows].reverse());
  }

  scatter() {
    const front = this.rows.filter((row) => is_on_front(row, this.rows)).sort((a, b) => a.cost - b.cost);
    const points = (label, rows, style) => ({ label, data: rows.map((row) => ({ x: row.cost, y: row.cycles, row })), ...style });
    const colours = (name) => ({ borderColor: colour(name), backgroundColor: colour(name) });
    return {
      type: "scatter",
      data: { datasets: [
        points("now", this.rows.filter((row) => row.overrides.join() === this.now), { pointStyle: "rectRot", pointRadius: 9, ...colours("port_conflict") }),
        points("front", front, { showLine: true, stepped: true, borderWidth: 1.5, pointRadius: 4, ...colours("busy") }),
        points("tried", this.rows, { pointRadius: 4, ...colours("empty_stall") }),
      ] },
      options: {
        onClick: (event, items) => { if (items.length > 0) this.chosen(items[0].element.$context.raw.row.overrides); },
        scales: {
          x: { title: axis_title("cost of FIFOs and memories of all cores [LUT-equivalents]") },
          y: { title: axis_title("cycles"), ticks: whole_ticks },
        },
        plugins: { tooltip: { callbacks: { label: (item) => `${whole(item.raw.y)} cycles, ${whole(item.raw.x)} LUT-equivalents: ${item.raw.row.overrides.join(" ") || "as recorded"}` } } },
      },
    };
  }
}
