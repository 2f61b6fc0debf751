// What a configuration comes to, and what moved against the pinned one.

function signed(number) {
  return (number > 0 ? "+" : number < 0 ? "−" : "") + whole(Math.abs(number));
}

function change_of(now, before) {
  if (now === undefined || before === undefined) return "";
  const percentage = before > 0 ? ` (${now >= before ? "+" : "−"}${decimal(Math.abs((100 * (now - before)) / before), 2)} %)` : "";
  return now === before ? "as pinned" : signed(now - before) + percentage;
}

/// A large figure with its change below.
function headline_figure(name, text, change, is_worse) {
  const note = element("span", { class: "change " + (change === "as pinned" || !change ? "" : is_worse ? "worse" : "better") }, change);
  return element("div", {}, element("dt", {}, name), element("dd", {}, text, note));
}

function show_headline(figures, pinned) {
  const is_over = figures.outcome === "finished";
  const total = is_over ? whole(figures.total_cycles) : "deadlock";
  const area = (name, value, text) => headline_figure(name, text(value(figures)), change_of(value(figures), value(pinned)), value(figures) > value(pinned));
  by_id("headline").replaceChildren(
    headline_figure("cycles", total, is_over ? change_of(figures.total_cycles, pinned.total_cycles) : `at cycle ${whole(figures.deadlock.cycle)}`,
      !is_over || figures.total_cycles > pinned.total_cycles),
    headline_figure("ms", is_over ? decimal(figures.milliseconds, 3) : "-", is_over && pinned.milliseconds !== figures.milliseconds
      ? (figures.milliseconds > pinned.milliseconds ? "+" : "−") + decimal(Math.abs(figures.milliseconds - pinned.milliseconds), 3) : "",
      is_over && figures.milliseconds > pinned.milliseconds),
    area("LUTs of a core's FIFOs", (f) => f.area.luts, whole),
    area("RAMB36 of a core's FIFOs", (f) => f.area.ramb36, (value) => decimal(value, 1)),
    area("RAMB36 of its memories", (f) => f.area.memories_ramb36, (value) => decimal(value, 1)),
    area("LUT-equivalents of all cores", (f) => f.area.cost_of_cores, whole));
  by_id("headline").removeAttribute("aria-busy");
}

/// What stands there is of what was asked for before.
function show_waiting() {
  by_id("headline").setAttribute("aria-busy", true);
  document.querySelectorAll("#headline .change").forEach((note, i) => {
    note.className = "change";
    note.textContent = i === 0 ? "working it out" : "";
  });
}

/// A row per figure that differs: {what, figure, before, now}.
function differences(now, before) {
  const rows = [];
  const put = (what, name, was, is) => {
    if (was !== is) rows.push({ what, figure: name, before: was, now: is });
  };
  const by_name = (list, name_of) => new Map((list || []).map((row) => [name_of(row), row]));
  const modules = by_name(before.modules, (row) => row.module);
  for (const row of now.modules || []) {
    const was = modules.get(row.module);
    if (was) row.cycles.forEach((cycles, c) => put(row.module, in_words(data.cycle_classes[c]), was.cycles[c], cycles));
  }
  const tables = [
    ["fifos", (row) => `FIFO ${row.fifo}`, ["depth", "capacity", "max_occupancy", "full_stall_cycles", "empty_stall_cycles", "luts", "ramb36"]],
    ["loops", (row) => `loop ${row.module}.${row.loop}`, ["ii", "depth", "port_conflict_cycles", "recurrence_cycles"]],
    ["brams", (row) => `memory ${row.bram}`, ["ports", "banks"]],
  ];
  for (const [table, name_of, columns] of tables) {
    const others = by_name(before[table], name_of);
    for (const row of now[table])
      for (const column of others.has(name_of(row)) ? columns : [])
        put(name_of(row), in_words(column), others.get(name_of(row))[column], row[column]);
  }
  return rows;
}

let moved_table = null;

function show_moved(figures, pinned) {
  const rows = differences(figures, pinned).sort((a, b) => Math.abs(b.now - b.before) - Math.abs(a.now - a.before));
  by_id("moved-note").textContent = rows.length === 0 ? "Nothing, against the pinned configuration."
    : `${count_of(rows.length, "figure")} against the pinned configuration, the largest first; cycles of all cores together.`;
  if (!moved_table)
    moved_table = new SortableTable(by_id("moved-table"), "What moved", [
      { title: "of", value: (row) => row.what },
      { title: "figure", value: (row) => row.figure },
      figure("pinned", (row) => row.before),
      figure("now", (row) => row.now),
      figure("difference", (row) => row.now - row.before, (row) => signed(row.now - row.before)),
    ], rows, { box: "high" });
  else moved_table.show(rows);
}

let path_table = null;

function show_path(path, figures) {
  const section = by_id("critical-path");
  section.hidden = !path;
  if (!path) return;
  by_id("path-note").textContent = `Core ${path.core}, the last to end. Making something else faster does not make the run shorter.`;
  const share = (row) => percent(row.cycles, figures.total_cycles);
  if (!path_table)
    path_table = new SortableTable(by_id("path-table"), "Critical path", [
      { title: "cause", value: (row) => row.cause, fill: (cell, row) => fill_with_swatch(cell, row.cause, path_colour(row.cause)) },
      { title: "module", value: (row) => row.module },
      { title: "loop", value: (row) => row.loop || "-" },
      { title: "FIFO or memory", value: (row) => row.item || "-" },
      figure("cycles", (row) => row.cycles),
      figure("%", share, (row) => decimal(row.share, 2)),
    ], [], { box: "high" });
  path_table.show(path.rows.map((row) => ({ ...row, share: share(row) })));
}
