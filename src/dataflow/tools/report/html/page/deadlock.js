// The page of a run that got stuck.

const { deadlock, headline } = data;

function show_headline() {
  const stuck_cores = new Set(deadlock.stuck.map((row) => row.core)).size;
  by_id("machine").textContent = machine_text(headline);
  fill_figures(by_id("headline"), [
    ["deadlock in cycle", whole(deadlock.cycle)],
    [`samples done, of ${whole(headline.samples)}`, whole(headline.samples_done)],
    [`${headline.cores_are} stuck, of ${whole(headline.cores)}`, whole(stuck_cores)],
  ]);
}

const cycles_before = 2000;

function show_command_for_before() {
  const settings = data.settings.map((setting) => ` --set ${setting}`).join("");
  by_id("before").textContent = `${data.command}${settings} --fst stuck.fst --vcd-from ${Math.max(0, deadlock.cycle - cycles_before)}`;
}

function show_commands() {
  if (deadlock.deeper.length === 0) return by_id("how-deep").remove();
  const configured = data.configuration.filter(({ key, default: is_default }) => /^accelerator\.fifos\.[\w-]+\.depth$/.test(key) && !is_default);
  const deeper = [...new Set([...deadlock.deeper, ...configured].map(({ key }) => key))];
  const others = data.settings.filter((setting) => !deeper.includes(setting.split("=")[0]));
  const settings = [...others, ...deeper.map((key) => `${key}=4096`)].map((setting) => ` --set ${setting}`).join("");
  by_id("commands").textContent = `${data.command}${settings} --events deep.events\n${data.program} size-fifos deep.events --within 5 --points 0`;
}

function show_graph() {
  if (!DataflowGraph.is_there()) return leave_out("graph");
  new DataflowGraph(by_id("graph-box")).show({
    fifos: rows_of(data.fifos, null, (row) => row.fifo, ["full_stall_cycles", "empty_stall_cycles"], ["max_occupancy"]),
    lane_cycles: headline.cores * deadlock.cycle, total_cycles: deadlock.cycle, path: null,
    stuck: circle_of(deadlock), waiting: deadlock.stuck,
  });
}

function show_timeline() {
  if (data.timelines.length === 0) return leave_out("timeline");
  new PackedSamples(() => {}, () => `Nothing moves after cycle ${whole(deadlock.cycle)}.`);
}

function show_stuck() {
  by_id("stuck-note").textContent = `Processes with something left to do: ${whole(deadlock.stuck.length)}, and where they are in the sources.`;
  new SortableTable(by_id("stuck-table"), "All that wait", [
    { title: "process", value: (row) => row.process },
    figure("core", (row) => row.core),
    { title: "where it is", value: (row) => row.position || "-" },
    { title: "source", value: (row) => row.source || "-" },
    { title: "waits for", value: (row) => row.waits_for },
    { title: "because of", value: what_holds_up },
    figure("since cycle", (row) => row.since_cycle),
  ], deadlock.stuck, { box: "high" });
}

/// Of a core that is stuck, at first the one of the circle.
function show_fifos() {
  const cores = [...new Set([...circle_of(deadlock), ...deadlock.stuck].map((row) => row.core))];
  const rows = (core) => data.fifos.filter((row) => row.core === core);
  const table = new SortableTable(by_id("fifo-table"), "FIFOs", [
    { title: "FIFO", value: (row) => row.fifo },
    { title: "writer", value: (row) => row.writer },
    { title: "reader", value: (row) => row.reader },
    figure("holds", (row) => row.occupancy),
    figure("of", (row) => row.capacity),
    { title: "state", value: (row) => (row.occupancy >= row.capacity ? "full" : row.occupancy === 0 ? "empty" : "-") },
    figure("written", (row) => row.writes),
    figure("read", (row) => row.reads),
  ], rows(cores[0]), { row_class: (row) => (circle_of(deadlock).some((wait) => wait.fifo === row.fifo) ? "changed" : "") });
  if (cores.length > 1)
    by_id("fifo-controls").append(labelled("Core", choice(cores.map((core) => `core ${core}`), (i) => table.show(rows(cores[i])))));
}

set_chart_defaults();
show_headline();
show_deadlock(by_id("deadlock"), deadlock);
show_commands();
show_command_for_before();
show_graph();
show_timeline();
show_stuck();
show_fifos();
show_configuration();
