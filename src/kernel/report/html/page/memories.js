// What is kept where: the block RAMs of the modules, and what the FIFOs take.

function show_memories() {
  const { ramb36_of_device } = data.area;
  const row_of = (rows, name) => rows.find((row) => (row.bram || row.fifo) === name) || {};
  const memories = data.area.memories.map((row) => ({ ...row, owner: row_of(data.graph.memories, row.bram).owner || "" }));
  const fifo_costs = data.area.fifo_costs.map((row) => ({ ...row_of(data.fifos, row.fifo), ...row }));
  if (memories.length === 0 && fifo_costs.length === 0) return leave_out("memories");
  const sum = (rows, value) => rows.reduce((all, row) => all + value(row), 0);
  const cores = Math.max(1, data.headline.cores);
  const of_memories = sum(memories, (row) => row.ramb36 * cores), of_fifos = sum(fifo_costs, (row) => row.ramb36 * cores);
  const tenths = (number) => decimal(number, Number.isInteger(number) ? 0 : 1);
  by_id("memories-note").textContent =
    `All ${data.headline.cores_are} together: ${tenths(of_memories)} RAMB36 of block RAMs and ${tenths(of_fifos)} of FIFOs, of the ` +
    `ZCU102's ${whole(ramb36_of_device)}; and ${count_of(sum(fifo_costs, (row) => row.luts * cores), "LUT")} of FIFOs as shift registers or distributed RAM.`;
  if (memories.length > 0)
    new SortableTable(by_id("memory-table"), "Block RAMs", [
      { title: "memory", value: (row) => row.bram },
      { title: "module", value: (row) => row.owner || "-" },
      figure("words", (row) => row.words),
      figure("bits", (row) => row.bits),
      figure("banks", (row) => row.banks),
      figure("buffers", (row) => row.buffers),
      figure("ports", (row) => row.ports),
      figure("RAMB36 of a core", (row) => row.ramb36, (row) => tenths(row.ramb36)),
      figure("RAMB36 of all", (row) => row.ramb36 * cores, (row) => tenths(row.ramb36 * cores)),
      figure("port conflict [lane-cycles]", (row) => row.port_conflict_cycles),
    ], memories, { box: "high" });
  if (fifo_costs.length > 0)
    new SortableTable(by_id("fifo-cost-table"), "What FIFOs are kept in, of a core", [
      { title: "FIFO", value: (row) => row.fifo },
      { title: "kind", value: (row) => in_words(row.kind) },
      figure("depth", (row) => row.depth),
      figure("bits", (row) => row.bits),
      figure("LUTs", (row) => row.luts),
      figure("RAMB36", (row) => row.ramb36, (row) => tenths(row.ramb36)),
    ], fifo_costs, { box: "high" });
}
