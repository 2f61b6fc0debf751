// What the machine takes of the device.

function resource_columns() {
  const amount = (title, key, digits) => figure(title, (row) => row[key], (row) => decimal(row[key], digits));
  return [amount("LUT", "lut", 0), amount("FF", "ff", 0), amount("DSP", "dsp", 0), amount("RAMB36", "ramb36", 1)];
}

function show_resources() {
  const { device, modules, fifos, memories, core, cores, beside, chip } = data.resources;
  const part_of = (row) => row.module || (row.fifo && `FIFO ${row.fifo}`) || (row.bram && `memory ${row.bram}`) || row.sum;
  const name = { title: "part of a core", value: part_of };
  const basis = { title: "basis", value: (row) => row.basis || "" };
  const share = (sum, of) => ({ sum: `${sum}, % of the ${device.name}`, ...of.percent_of_device });
  const rows = [...modules, ...fifos, ...memories, { sum: "a core", ...core }, { sum: "all cores", ...cores },
    share("all cores", cores)];
  if (beside) rows.push({ sum: "all cores and what is beside them", ...chip }, share("with what is beside them", chip));
  by_id("resources-note").textContent =
    (chip.fits ? "" : `This does not fit the ${device.name}. `) + (beside ? `Beside the cores: ${beside.is}.` : "");
  new SortableTable(by_id("resource-table"), "Resources", [name, ...resource_columns(), basis], rows);
  if (data.timing) show_paths();
  if (data.power) show_power();
}

function show_paths() {
  const ns = (title, key) => figure(title, (row) => row[key], (row) => decimal(row[key], 2));
  by_id("longest-paths").hidden = false;
  by_id("longest-paths-note").textContent =
    `Estimated from netlists, without placement. A cycle has ${decimal(1e3 / data.timing.clock_mhz, 2)} ns.`;
  new SortableTable(by_id("longest-path-table"), "Longest paths, estimated", [
    { title: "module", value: (row) => row.module }, ns("ns, low", "low_ns"), ns("typical", "typical_ns"), ns("high", "high_ns"),
    { title: "from", value: (row) => row.from, wrap: true }, { title: "to", value: (row) => row.to, wrap: true },
  ], data.timing.modules, { row_class: (row) => (row.typical_ns > 1e3 / data.timing.clock_mhz ? "changed" : "") });
}

function show_power() {
  const power = data.power;
  const milliwatts = (name, range) => ({ name, unit: "mW", ...range });
  const rows = [...Object.entries(power.modules_mw).map(([name, range]) => milliwatts(name, range)),
    milliwatts("FIFOs", power.fifos_mw), milliwatts("memories", power.memories_mw), milliwatts("beside the cores", power.beside_mw),
    { name: "dynamic", unit: "W", ...power.dynamic_w }, { name: "static", unit: "W", ...power.static_w },
    { name: "processing system", unit: "W", ...power.ps_w }, { name: "in all", unit: "W", ...power.total_w },
    { name: "energy of the run", unit: "mJ", ...power.energy_mj }];
  const column = (key) => figure(key, (row) => row[key], (row) => decimal(row[key], 3));
  by_id("power").hidden = false;
  new SortableTable(by_id("power-table"), "Power, estimated from the run's activity", [
    { title: "of", value: (row) => row.name }, column("low"), column("typical"), column("high"),
    { title: "unit", value: (row) => row.unit }], rows);
}
