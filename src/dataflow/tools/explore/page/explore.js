// The page of an exploration: every change is retimed by the server and drawn here.

const drag_pause_ms = 60; // without a new total, before the rest is drawn
const soon_ms = 200; // an answer that takes no longer is waited for without a word
const rest_ms = 800; // without a new total, before steps from there are worked out

class Explorer {
  constructor() {
    this.history = new History();
    this.changes = new Map();
    this.keys = new KeyList((key, value, is_settled) => this.change(key, value, is_settled));
    this.graph = DataflowGraph.is_there() ? new DataflowGraph(by_id("graph-box"), (kind, name) => this.select(kind, name)) : null;
    this.retimer = new Latest("retime", (figures, context, is_stale) => this.retimed(figures, context, is_stale), (error, context, is_stale) => this.failed(error, context, is_stale));
    this.pather = new Latest("path", (path, context) => this.pathed(path, context), () => {});
    this.sensitivities = new BackgroundJob("sensitivities", ({ done, steps }) => { this.sensitivity_note.textContent = `sensitivities: ${done} of ${steps || "?"}`; });
    this.sizing = new Sizing(() => overrides_of(this.changes), (overrides) => this.put_over(overrides), (rows, base) => this.tried_by_search(rows, base));
    this.tried = new Tried((overrides) => this.go_to(changes_of(overrides)));
    this.add_actions();
    if (this.graph) by_id("graph-legend").append(graph_legend());
    else by_id("graph-box").append(element("p", { class: "note" }, "Not drawn: Graphviz's program dot, which places the parts, is not installed where faster-sim runs."));
    addEventListener("hashchange", () => {
      const changes = changes_of_hash(location.hash);
      changes ? this.go_to(changes) : this.leave_address();
    });
    addEventListener("keydown", (event) => this.key_down(event));
  }

  add_actions() {
    const button = (text, title, action) => {
      const made = element("button", { type: "button", title }, text);
      made.addEventListener("click", action);
      by_id("actions").append(made);
      return made;
    };
    this.undo = button("undo", "Ctrl-Z", () => this.travel(-1));
    this.redo = button("redo", "Ctrl-Y", () => this.travel(1));
    this.reset = button("reset", "all keys as recorded", () => this.go_to(new Map()));
    button("pin", "compare with what is shown now", () => this.pin());
    button("copy --set", "for run, whatif and size-fifos", () => this.copy(this.set_options()));
    button("copy YAML", "a configuration file that takes as long", () => this.copy(this.figures.yaml));
    button("copy link", "this address has all changes", () => this.copy(location.href));
    this.run_note = element("span", { class: "note", id: "run-note" });
    this.sensitivity_note = element("span", { class: "note", "aria-live": "polite" });
    this.copied = element("textarea", { id: "copied", "aria-label": "Copied text", readonly: "", rows: 3, hidden: "" });
    by_id("actions").append(this.run_note, this.sensitivity_note, this.copied);
  }

  /// With the figures of the recorded run, which are pinned until something else is.
  begin(recorded) {
    this.pinned = recorded;
    this.any_sample = new AnySample();
    this.retimed(recorded, { changes: this.changes, is_settled: false, complaint: "", asked_at: performance.now() }, false);
    this.go_to(changes_of_hash(location.hash) || new Map());
  }

  set_options() {
    return overrides_of(this.changes).map((setting) => `--set ${setting}`).join(" ");
  }

  /// Also shown, for browsers that give no access to the clipboard.
  copy(text) {
    this.copied.value = text;
    this.copied.hidden = text === "";
    if (navigator.clipboard) navigator.clipboard.writeText(text).catch(() => this.copied.select());
  }

  key_down(event) {
    if (!(event.ctrlKey || event.metaKey) || event.altKey || event.target.tagName === "TEXTAREA") return;
    const by = event.key === "z" && !event.shiftKey ? -1 : event.key === "y" || event.key.toLowerCase() === "z" ? 1 : 0;
    if (by === 0) return;
    event.preventDefault();
    this.travel(by);
  }

  change(key, value, is_settled) {
    value === key_rows.get(key).value ? this.changes.delete(key) : this.changes.set(key, value);
    this.retime(is_settled);
  }

  travel(by) {
    this.changes = new Map(this.history.go(by));
    this.retime(false);
    this.leave_address();
  }

  go_to(changes) {
    this.changes = new Map(changes);
    this.retime(true);
  }

  put_over(overrides) {
    this.go_to(changes_of([...overrides_of(this.changes), ...overrides]));
  }

  /// `rows` with overrides that stand over those of `base`.
  tried_by_search(rows, base) {
    for (const row of rows) this.tried.note({ ...row, overrides: overrides_of(changes_of([...base, ...row.overrides])) });
    this.tried.show(this.overrides);
  }

  /// `is_settled`: what is chosen now goes into the history, once it is known to be sound. `complaint`: about what was
  /// chosen before.
  retime(is_settled, complaint = "") {
    this.keys.show(this.changes);
    if (is_settled && this.figures && this.retimer.is_idle() && overrides_of(this.changes).join() === this.overrides.join())
      return this.settle(this.changes); // a drag has ended where its figures are known
    this.retimer.want({ set: overrides_of(this.changes) }, { changes: new Map(this.changes), is_settled, complaint, asked_at: performance.now() });
    this.wait_for_answer();
  }

  /// In sight, if it takes long.
  wait_for_answer() {
    this.waiting ||= setTimeout(show_waiting, soon_ms);
  }

  answered(is_stale) {
    clearTimeout(this.waiting);
    this.waiting = 0;
    show_headline(this.figures, this.pinned);
    if (is_stale) this.wait_for_answer();
  }

  retimed(figures, { changes, is_settled, complaint, asked_at }, is_stale) {
    this.complain(complaint);
    this.run_note.textContent = figures.run_again ? "run again, as an access that does not wait finds something else" : "";
    this.figures = figures;
    this.overrides = overrides_of(changes);
    if (is_settled) this.settle(changes);
    if (figures.outcome === "finished") this.tried.note({ overrides: this.overrides, cycles: figures.total_cycles, cost: figures.area.cost_of_cores });
    this.answered(is_stale);
    by_id("headline").dataset.milliseconds = performance.now() - asked_at;
    this.forget_sensitivities();
    if (is_stale) return;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => this.show_settled(), drag_pause_ms);
  }

  /// What takes longer to draw than the headline.
  show_settled() {
    this.show_rest(null);
    this.tried.show(this.overrides);
    this.any_sample.follow();
    this.pather.want({ set: this.overrides }, this.overrides.join());
  }

  settle(changes) {
    this.history.put(changes);
    this.leave_address();
  }

  leave_address() {
    const hash = hash_of(this.history.now);
    history.replaceState(null, "", hash === "#" ? location.pathname : hash);
    this.undo.disabled = !this.history.can_go(-1);
    this.redo.disabled = !this.history.can_go(1);
    this.reset.disabled = this.history.now.size === 0;
  }

  show_rest(path) {
    const { figures } = this;
    show_moved(figures, this.pinned);
    show_loops(figures.schedules);
    show_deadlock(by_id("deadlock"), figures.deadlock, " The search for FIFO sizes, below, finds depths that are enough.");
    const lane_cycles = figures.cores * (figures.total_cycles || figures.deadlock.cycle);
    const waits = figures.deadlock ? { stuck: circle_of(figures.deadlock), waiting: figures.deadlock.stuck } : {};
    if (this.graph) this.graph.show({ ...figures, lane_cycles, path, ...waits });
  }

  pathed(path, of) {
    if (of !== this.overrides.join()) return;
    show_path(path, this.figures);
    this.show_rest(path);
  }

  /// What was tried is not taken: the setting that the error is about, or if it names none all that were new, goes back to
  /// what it was. With the others, the run is asked for again.
  failed(error, { changes, is_settled }, is_stale) {
    this.complain(error.message);
    this.answered(is_stale);
    if (!is_settled) return;
    const sound = this.history.now;
    const tried = differing(changes, sound);
    const named = tried.filter((key) => error.message.startsWith(`--set ${setting_of(key, changes.get(key))}:`));
    for (const key of named.length > 0 ? named : tried) this.put_back(key, changes.get(key), sound);
    if (tried.length > 0) this.retime(true, error.message);
  }

  /// Unless it is another value by now.
  put_back(key, value, sound) {
    if (this.changes.get(key) !== value) return;
    sound.has(key) ? this.changes.set(key, sound.get(key)) : this.changes.delete(key);
  }

  complain(text) {
    by_id("complaint").textContent = text;
    by_id("complaint").hidden = text === "";
  }

  pin() {
    this.pinned = this.figures;
    show_headline(this.figures, this.pinned);
    if (this.waiting) show_waiting();
    show_moved(this.figures, this.pinned);
  }

  select(kind, name) {
    this.keys.show_part({ kind, name });
    by_id("keys").scrollIntoView({ block: "nearest", behavior: "smooth" });
  }

  /// Steps are those of what is on the screen: until they are worked out again, none is shown.
  forget_sensitivities() {
    const of = this.overrides.join();
    if (this.steps_of === of) return;
    this.steps_of = of;
    this.keys.show_sensitivities([]);
    this.sensitivity_note.textContent = "";
    clearTimeout(this.steps_later);
    this.steps_later = setTimeout(() => this.work_out_sensitivities(), rest_ms);
  }

  async work_out_sensitivities() {
    const of = this.overrides.join();
    if (this.figures.outcome !== "finished") return;
    try {
      const result = await this.sensitivities.start({ set: this.overrides });
      if (!result || of !== this.overrides.join()) return;
      this.keys.show_sensitivities(result.sensitivities);
      this.sensitivity_note.textContent = "one step of each key: worked out from here";
    } catch (error) {
      this.sensitivity_note.textContent = error.message;
    }
  }
}

function show_machine() {
  by_id("machine").textContent = [data.remark, count_of(data.samples, "sample")].filter((part) => part).join(", ");
}

set_chart_defaults();
show_machine();
const explorer = new Explorer();
ask("retime", { set: [] }).then((recorded) => explorer.begin(recorded));
