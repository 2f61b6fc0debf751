// Why the loops have their initiation intervals.

let loop_table = null;

/// The accesses of one iteration to the fullest bank of a memory: a row per port, a column per cycle.
function schedule_table({ bram, banks, ports, sharers, accesses, cycles }) {
  const most_ports = Math.min(ports, Math.max(...cycles.map((cycle) => cycle.length)));
  const of_cores = sharers > 1 ? ` of ${sharers} cores that share it` : "";
  const caption = `${bram}: ${accesses === 1 ? "1 access" : accesses + " accesses"} per iteration` +
    (banks > 1 ? ` in ${banks} banks; the fullest` : "") + of_cores + ` takes ${count_of(cycles.length, "cycle")} on ${count_of(ports, "port")}`;
  const head = element("tr", {}, element("th", { scope: "col" }, ""), ...cycles.map((_, cycle) => element("th", { scope: "col" }, `cycle ${cycle}`)));
  const rows = Array.from({ length: most_ports }, (_, port) => element("tr", {}, element("th", { scope: "row" }, `port ${port}`),
    ...cycles.map((cycle) => element("td", {}, cycle[port] || "-"))));
  return element("figure", {}, element("figcaption", {}, caption),
    element("div", { class: "scroll", role: "region", tabindex: "0", "aria-label": caption }, element("table", { class: "slots" }, element("thead", {}, head), element("tbody", {}, ...rows))));
}

function schedule_of(row) {
  const why = row.ii === 1 ? "an iteration begins every cycle"
    : row.limited_by === "recurrence" ? `a dependence between iterations demands ${row.recurrence} cycles`
    : row.limited_by ? `the ports of ${row.limited_by} demand ${row.ports} cycles` : `the pragma asks for ${row.target}`;
  return element("details", row.ii > row.target ? { open: "" } : {}, element("summary", {}, `${row.loop}, II ${row.ii}: ${why}`),
    ...row.memories.map(schedule_table));
}

function show_loops(schedules) {
  if (!loop_table)
    loop_table = new SortableTable(by_id("loop-table"), "Initiation intervals", [
      { title: "loop", value: (row) => row.loop },
      figure("II", (row) => row.ii),
      figure("pragma", (row) => row.target),
      figure("dependence", (row) => row.recurrence),
      figure("ports", (row) => row.ports),
      { title: "limited by", value: (row) => row.limited_by || "-" },
    ], schedules, { box: "high", row_class: (row) => (row.ii > row.target ? "changed" : "") });
  else loop_table.show(schedules);
  by_id("loop-schedules").replaceChildren(...schedules.filter((row) => row.memories.length > 0).map(schedule_of));
}
