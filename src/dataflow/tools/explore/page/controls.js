// A control for every key that may be changed, with what one step of it does.

/// Where a slider stops: every number up to 16, then four to an octave.
function stops_between(min, max) {
  const stops = [];
  for (let value = min; value <= Math.min(max, min + 16); ++value) stops.push(value);
  for (let eighth = 1; stops[stops.length - 1] < max; ++eighth)
    stops.push(Math.min(max, Math.max(stops[stops.length - 1] + 1, Math.round(Math.max(16, min + 16) * 2 ** (eighth / 4)))));
  return stops;
}

/// Where a slider ends, unless the recorded value is near it or beyond; the field beside it takes the rest.
const usual_most = { depth: 1024, ports: 8, factor: 16, ii: 16, recurrence_ii: 16, raster_cores: 32 };
const other_most = 128;

/// "fifos.vertex" of accelerator.fifos.vertex.depth
function part_of(key) {
  return key.split(".").slice(1, -1).join(".");
}

function leaf_of(key) {
  return key.slice(key.lastIndexOf(".") + 1);
}

/// What a part of the graph is called among the keys: of a process, all that begins so.
function is_of_part(key, { kind, name }) {
  const part = part_of(key);
  if (kind === "fifo") return part === `fifos.${name}`;
  if (kind === "bram") return `${part}.`.startsWith(`brams.${name}.`);
  return part.startsWith(`loops.${name}.`) || part === `modules.${name}` || part === name;
}

/// One key. `changed(value, is_settled)` is told what the user does.
class KeyControl {
  constructor(row, changed) {
    this.row = row;
    this.changed = changed;
    this.name = element("span", { class: "leaf" }, leaf_of(row.key));
    this.box = element("input", { "aria-label": row.key });
    this.slider = null;
    if (row.kind === "choice") {
      this.box = element("select", { "aria-label": row.key });
      for (const choice of row.choices) this.box.append(element("option", { value: choice }, choice));
    } else {
      this.box.setAttribute("type", "number");
      this.box.setAttribute("step", row.kind === "integer" ? 1 : "any");
      for (const end of ["min", "max"]) if (row[end] !== null) this.box.setAttribute(end, row[end]);
      if (row.kind === "integer") this.add_slider();
    }
    this.box.addEventListener("change", () => this.changed(this.box.value, true));
    this.steps = ["down", "up"].map((side) => this.step_button(side));
    this.back = element("button", { type: "button", class: "back", title: `as recorded: ${row.value}`, "aria-label": `${row.key} as recorded` }, "↺");
    this.back.addEventListener("click", () => this.changed(row.value, true));
    this.line = element("div", { class: "key", "data-key": row.key },
      element("label", { title: `${row.key}: ${row.meaning}` }, this.name, element("span", { class: "unit" }, row.unit)),
      this.slider || element("span"), this.box, ...this.steps, this.back,
      element("p", { class: "meaning" }, `${row.meaning} Accepts ${row.accepts}; default ${row.default}, recorded ${row.value}.`));
    this.show(row.value);
  }

  add_slider() {
    const most = Math.min(this.row.max, Math.max(usual_most[leaf_of(this.row.key)] ?? other_most, 2 * Number(this.row.value)));
    this.stops = stops_between(this.row.min, most);
    this.slider = element("input", { type: "range", min: 0, max: this.stops.length - 1, step: 1, "aria-label": `${this.row.key}, slider` });
    const value = () => String(this.stops[Number(this.slider.value)]);
    this.slider.addEventListener("input", () => this.changed(value(), false));
    this.slider.addEventListener("change", () => this.changed(value(), true));
  }

  /// One step, as the sensitivities have it. A click takes it.
  step_button(side) {
    const button = element("button", { type: "button", class: "step", disabled: "" }, "");
    button.addEventListener("click", () => this.changed(String(Number(this.value) + (side === "up" ? 1 : -1)), true));
    return button;
  }

  show(value) {
    this.value = value;
    if (document.activeElement !== this.box || this.row.kind === "choice") this.box.value = value;
    else if (this.box.value !== value) this.box.value = value;
    if (this.slider) {
      const past = this.stops.findIndex((stop) => stop >= Number(value));
      this.slider.value = past < 0 ? this.stops.length - 1 : past;
      this.slider.setAttribute("aria-valuetext", value);
    }
    const differs = value !== this.row.value;
    this.line.classList.toggle("changed-key", differs);
    this.back.disabled = !differs;
  }

  /// The sensitivity of this key: {down, up}, or null while it is not known; then a button says only which way it goes.
  show_sensitivity(sensitivity) {
    this.sensitivity = sensitivity;
    ["down", "up"].forEach((side, i) => {
      const step = sensitivity && sensitivity[side];
      const button = this.steps[i];
      const sign = side === "up" ? "one more" : "one less";
      button.disabled = step ? step.outcome === "invalid" : this.row.kind !== "integer";
      button.textContent = !step ? (this.row.kind === "integer" ? (side === "up" ? "▸" : "◂") : "") : step.outcome === "finished" ? signed(step.change_cycles) : step.outcome;
      button.title = !step ? sign : `${sign}: ${button.textContent}${step.outcome === "finished" ? " cycles" : ""}`;
      button.className = "step " + (!step ? "" : step.outcome === "deadlock" || step.change_cycles > 0 ? "worse" : step.change_cycles < 0 ? "better" : "");
    });
  }

  /// The largest change of cycles by a step in either direction.
  effect() {
    const of_step = (step) => step.outcome === "deadlock" ? Number.MAX_VALUE : Math.abs(step.change_cycles || 0);
    return this.sensitivity ? Math.max(of_step(this.sensitivity.down), of_step(this.sensitivity.up)) : -1;
  }
}

/// All of them, and which are shown.
class KeyList {
  constructor(changed) {
    this.controls = data.keys.map((row) => new KeyControl(row, (value, is_settled) => changed(row.key, value, is_settled)));
    this.part = null;
    this.filter = element("input", { type: "search", placeholder: "e.g. depth", "aria-label": "Only keys with" });
    this.order = choice(["as documented", "largest effect first"], () => this.arrange());
    this.only = element("input", { type: "checkbox" });
    this.all = element("button", { type: "button", hidden: "" }, "all keys");
    for (const control of [this.filter, this.only]) control.addEventListener("input", () => this.arrange());
    this.all.addEventListener("click", () => this.show_part(null));
    by_id("key-controls").append(labelled("Only keys with", this.filter), labelled("Order", this.order),
      element("label", {}, this.only, "only changed"), this.all);
    this.arrange();
  }

  show(changes) {
    for (const control of this.controls) control.show(changes.get(control.row.key) ?? control.row.value);
    if (this.only.checked) this.arrange();
  }

  show_sensitivities(rows) {
    const by_key = new Map(rows.map((row) => [row.key, row]));
    for (const control of this.controls) control.show_sensitivity(by_key.get(control.row.key) || null);
    if (Number(this.order.value) === 1) this.arrange();
  }

  show_part(part) {
    this.part = part;
    this.all.hidden = part === null;
    this.arrange();
  }

  is_shown({ row, value }) {
    if (this.part && !is_of_part(row.key, this.part)) return false;
    if (this.only.checked && value === row.value) return false;
    return row.key.includes(this.filter.value.trim());
  }

  arrange() {
    const shown = this.controls.filter((control) => this.is_shown(control));
    const by_effect = Number(this.order.value) === 1;
    if (by_effect) shown.sort((a, b) => b.effect() - a.effect());
    const children = [];
    let part = null;
    for (const control of shown) {
      const its_part = part_of(control.row.key) || "machine";
      control.name.textContent = by_effect ? control.row.key.replace("accelerator.", "") : leaf_of(control.row.key);
      if (!by_effect && its_part !== part) children.push(element("h3", {}, its_part));
      part = its_part;
      children.push(control.line);
    }
    by_id("key-list").replaceChildren(...children);
    by_id("keys-note").textContent = `${shown.length} of ${count_of(this.controls.length, "key")}` +
      (this.part ? `, those of ${this.part.name}` : "") + ". Beside each: what one less and one more change, in cycles; a click does it.";
  }
}
