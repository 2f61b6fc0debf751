// Fills the page of a sizing of FIFOs, from top to bottom. Its data are sizing.json.

function cycles_text(cycles) {
  return cycles === null ? "deadlock" : whole(cycles);
}

function change_text(cycles) {
  if (cycles === null || data.unbounded.total_cycles === 0) return "-";
  return decimal((100 * (cycles - data.unbounded.total_cycles)) / data.unbounded.total_cycles, 3) + " %";
}

function after_all(cycles) {
  return cycles === null ? Number.MAX_SAFE_INTEGER : cycles;
}

function proof() {
  if (data.proven) return "Proven: no depths within the bound cost less.";
  const least = `othing within the bound costs less than ${decimal(data.least_cost_luts, 1)} LUTs`;
  if (data.unproven_because === "given_up") return `Not proven to be the cheapest, as the search was given up: n${least}.`;
  if (data.unproven_because === "shared_memory")
    return `N${least}: that would be too slow even if every master had the memory to itself.`
      + " They share it, so that more room may cost time: not proven that nothing in between is within.";
  return `N${least}: that would be too slow even if tokens in front of a full ${data.freezing_fifos.join(", ")} closed up.`
    + " They freeze, so that more room may cost time: not proven that nothing in between is within.";
}

function show_headline() {
  by_id("machine").textContent =
    `${count_of(data.raster_cores, "core")} at ${data.clock_mhz} MHz, within ${data.within_percent} % of unbounded FIFOs`;
  fill_figures(by_id("headline"), [
    ["cycles, unbounded", whole(data.unbounded.total_cycles)],
    ["cycles, at most", whole(data.bound_cycles)],
    ["cycles, answer", whole(data.answer.total_cycles)],
    ["LUTs, answer", whole(data.answer.luts)],
    ["RAMB36, answer", decimal(data.answer.ramb36, 1)],
    ["cost in LUTs, answer", decimal(data.answer.cost_luts, 1)],
  ]);
  by_id("proof").textContent = proof();
}

function point_of(row) {
  return { x: row.cost_luts, y: row.total_cycles };
}

function points(label, rows, style) {
  return { label, data: rows.filter((row) => row.total_cycles !== null).map(point_of), ...style };
}

function front_lines() {
  const colours = (name) => ({ borderColor: colour(name), backgroundColor: colour(name) });
  return {
    type: "line",
    data: {
      datasets: [
        points("front", data.front, { stepped: true, pointRadius: 4, borderWidth: 1.5, ...colours("busy") }),
        points("answer", [data.answer], { pointStyle: "triangle", pointRadius: 9, ...colours("port_conflict") }),
        points("as configured", [data.configured], { pointStyle: "rect", pointRadius: 8, ...colours("full_stall") }),
      ],
    },
    options: {
      scales: {
        x: { type: "linear", title: axis_title("cost of one core's FIFOs [LUTs]") },
        y: { title: axis_title("cycles") },
      },
      plugins: { tooltip: { callbacks: { label: (item) => `${item.dataset.label}: ${whole(item.parsed.y)} cycles, ${decimal(item.parsed.x, 1)} LUTs` } } },
    },
  };
}

function show_front() {
  if (data.front.length === 0) return leave_out("front");
  const box = by_id("front-chart");
  box.before(legend([["busy", "front"], ["port_conflict", "answer"], ["full_stall", "as configured"]]));
  add_chart(box, "Cost against cycles; the table below has the figures", front_lines);
  new SortableTable(by_id("front-table"), "The cheapest depths within each bound", [
    figure("cost [LUTs]", (row) => row.cost_luts, (row) => decimal(row.cost_luts, 1)),
    figure("LUTs", (row) => row.luts),
    figure("RAMB36", (row) => row.ramb36, (row) => decimal(row.ramb36, 1)),
    figure("cycles", (row) => row.total_cycles),
    figure("more than unbounded", (row) => row.total_cycles, (row) => change_text(row.total_cycles)),
    ...data.fifos.map(({ fifo }) => figure(in_words(fifo), (row) => row.depths[fifo])),
  ], data.front);
}

function show_fifos() {
  new SortableTable(by_id("fifo-table"), "FIFOs of the answer", [
    { title: "FIFO", value: (row) => row.fifo },
    figure("configured", (row) => row.configured_depth),
    figure("depth", (row) => row.depth),
    figure("holds", (row) => row.holds),
    { title: "kind", value: (row) => in_words(row.kind) },
    figure("bits", (row) => row.bits),
    figure("LUTs", (row) => row.luts),
    figure("RAMB36", (row) => row.ramb36, (row) => decimal(row.ramb36, 1)),
    figure("cost [LUTs]", (row) => row.cost_luts, (row) => decimal(row.cost_luts, 1)),
  ], data.fifos);
}

function step_text(row) {
  return [row.token_step ? "a token" : "", row.cost_step ? "a cost step" : ""].filter(Boolean).join(", ");
}

function show_certificate() {
  if (data.certificate.length === 0) return leave_out("certificate");
  new SortableTable(by_id("certificate-table"), "Shallower by one step", [
    { title: "FIFO", value: (row) => row.fifo },
    figure("depth", (row) => row.depth),
    figure("shallower", (row) => row.shallower_depth),
    { title: "by", value: step_text },
    figure("core", (row) => row.core),
    figure("its cycles", (row) => after_all(row.core_cycles), (row) => cycles_text(row.core_cycles)),
    figure("more than unbounded", (row) => after_all(row.core_cycles), (row) => change_text(row.core_cycles)),
  ], data.certificate);
}

set_chart_defaults();
show_headline();
show_front();
show_fifos();
show_certificate();
