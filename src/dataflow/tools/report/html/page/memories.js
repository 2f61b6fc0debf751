// The block RAMs of the modules.

function show_memories() {
  const { ramb36_of_device } = data.area;
  const in_graph = (name) => data.graph.memories.find((memory) => memory.bram === name) || {};
  const memories = data.area.memories.map((row) => ({ ...row, owner: in_graph(row.bram).owner }));
  if (memories.length === 0) return leave_out("memories");
  const cores = Math.max(1, data.headline.cores);
  const all = memories.reduce((sum, row) => sum + row.ramb36 * cores, 0);
  const tenths = (number) => decimal(number, Number.isInteger(number) ? 0 : 1);
  by_id("memories-note").textContent =
    `All ${data.headline.cores_are} together: ${tenths(all)} RAMB36, of the ZCU102's ${whole(ramb36_of_device)}.`;
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
}
