// The page of a sweep: figures, front, lines, table.

function count_with(status) {
  return data.points.filter((point) => point.status === status).length;
}

function fill_headline() {
  const missing = data.planned - data.points.length;
  by_id("machine").textContent = `${count_of(data.columns.length, "column")}, ${count_of(data.planned, "point")}`;
  const figures = [["done", whole(count_with("done"))], ["deadlock", whole(count_with("deadlock"))], ["failed", whole(count_with("failed"))]];
  if (missing > 0) figures.push(["not done yet", whole(missing)]);
  if (done_points.length > 0) {
    const cycles = done_points.map((point) => point.total_cycles);
    figures.push(["fewest cycles", whole(cycles.reduce((a, b) => Math.min(a, b)))], ["most cycles", whole(cycles.reduce((a, b) => Math.max(a, b)))]);
  }
  fill_figures(by_id("headline"), figures);
}

function point_columns() {
  const key = (column, i) => {
    const scale = scale_of(data.points.map((point) => point.values[i]));
    return { title: short_name(column), value: (point) => (scale.numeric ? Number(point.values[i]) : point.values[i]),
      text: (point) => point.values[i], number: scale.numeric };
  };
  const shown = (metric, point) => point.status === "done" || (["ramb36", "lut", "ff", "dsp"].includes(metric.name) && point.status === "deadlock");
  const metric_column = (metric) => figure(metric.title, (point) => (shown(metric, point) ? point[metric.name] : -1),
    (point) => (shown(metric, point) ? metric_text(metric, point[metric.name]) : "-"));
  return [figure("point", (point) => point.point), ...data.columns.map(key), { title: "status", value: (point) => point.status },
    ...metrics.map(metric_column), { title: "message", value: (point) => point.message, wrap: true }];
}

const most_lines = 2000;

function draw_page() {
  set_chart_defaults();
  fill_headline();
  let only_front = false;
  const table = new SortableTable(by_id("point-table"), "Points", point_columns(), [], {
    box: "high", row_class: (point) => (pareto.on_front.has(point) ? "front" : "") });
  const note = element("span", { class: "note" });
  function show_points() {
    const shown = data.points.filter((point) => parallel.is_kept(point) && (!only_front || pareto.on_front.has(point)));
    table.show(shown.slice(0, most_lines));
    note.textContent = shown.length > most_lines ? `the first ${whole(most_lines)} of ${whole(shown.length)}; results.csv has all` : "";
  }
  const pareto = new ParetoChart(() => {
    parallel.draw();
    show_points();
  });
  const parallel = new ParallelCoordinates((point) => pareto.on_front.has(point), show_points);
  const filter = element("input", { type: "checkbox", id: "only-front" });
  filter.addEventListener("change", () => {
    only_front = filter.checked;
    show_points();
  });
  by_id("point-controls").append(labelled("", element("span", {}, filter, " only the Pareto front")), note);
  show_points();
  return { pareto, parallel };
}

/// For the tests, with #self-check in the address: uses the page as a reader would, and leaves what came of it in the page
/// as JSON.
function leave_self_check({ pareto, parallel }) {
  const is_painted = (canvas) => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.some((byte) => byte !== 0);
  const lines = () => [...document.querySelectorAll("#point-table tbody tr")].map((line) => line.cells[0].textContent);
  const canvases = [...document.querySelectorAll("canvas")];
  const check = { front: pareto.front.map((point) => point.point), axes: parallel.axes.map((axis) => axis.title),
    charts: canvases.length, painted: canvases.filter(is_painted).length, rows: lines().length,
    page_width: document.documentElement.scrollWidth, window_width: innerWidth };
  by_id("only-front").click();
  check.rows_on_front = lines().length;
  by_id("only-front").click();
  if (parallel.axes.length > 1) {
    drag(parallel, 1, -0.2, 0.5);
    check.rows_in_range = lines();
    drag(parallel, 1, 0.5, 0.5);
  }
  const select = document.querySelectorAll("#pareto-controls select")[1];
  select.selectedIndex = 0;
  select.dispatchEvent(new Event("change"));
  check.front_of_same_figure = pareto.front.map((point) => point.point);
  const text = element("script", { type: "application/json", id: "self-check" });
  text.textContent = JSON.stringify({ ...check, errors }).replaceAll("<", "\\u003c");
  document.body.append(text);
}

/// Along an axis, from share to share of it, as a pointer would.
function drag(parallel, i, from, to) {
  const box = parallel.canvas.getBoundingClientRect();
  const length = parallel_height - margin.top - margin.bottom;
  const at = (share) => ({ clientX: box.left + parallel.x_of(i), clientY: box.top + parallel_height - margin.bottom - share * length });
  parallel.canvas.dispatchEvent(new PointerEvent("pointerdown", at(from)));
  parallel.canvas.dispatchEvent(new PointerEvent("pointermove", at(to)));
  parallel.canvas.dispatchEvent(new PointerEvent("pointerup", at(to)));
}

const drawn = draw_page();
if (location.hash === "#self-check") requestAnimationFrame(() => leave_self_check(drawn));
