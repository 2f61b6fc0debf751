// For the tests, with #self-check in the address: uses the page as a reader would, and leaves what came of it in the
// page as JSON.

function is_painted(canvas) {
  if (canvas.width === 0 || canvas.height === 0) return false;
  return canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data.some((byte) => byte !== 0);
}

function column_of(table, i) {
  return [...table.tBodies[0].rows].map((row) => row.cells[i].textContent);
}

/// Sorts a table by each column twice; every column with its texts after each click.
function sort_all(table) {
  return [...table.tHead.rows[0].cells].map((head, i) => {
    const sorted = { column: head.textContent };
    for (let click = 0; click < 2; ++click) {
      head.firstElementChild.click();
      sorted[head.getAttribute("aria-sort")] = column_of(table, i);
    }
    head.firstElementChild.blur();
    return sorted;
  });
}

function rows_with_filter(checked) {
  const filter = by_id("only-non-defaults");
  if (filter.checked !== checked) filter.click();
  return column_of(document.querySelector("#configuration-table table"), 0);
}

/// Until the timeline that was chosen is drawn.
async function timeline_is_drawn() {
  while (data.timelines.length > 0 && !by_id("timeline-chart").dataset.shown) await new Promise((resolve) => setTimeout(resolve, 5));
}

/// What `observe` finds after each choice of a select, by the text of the choice; the first is chosen again at the end.
async function with_each_choice(place, observe) {
  const select = document.querySelector(place + " select");
  if (!select) return {};
  const found = {};
  const choose = async (i) => {
    select.selectedIndex = i;
    select.dispatchEvent(new Event("change"));
    await timeline_is_drawn();
    found[select.options[i].textContent] = observe();
  };
  for (let i = 0; i < select.options.length; ++i) await choose(i);
  await choose(0);
  return found;
}

/// Cycles on the timeline's axis without and with all zoom.
function zoomed() {
  const entry = charts.find(({ canvas }) => canvas.parentNode.id === "timeline-chart");
  if (!entry) return [];
  const zoom = document.querySelector("#timeline-controls input");
  return [zoom.min, zoom.max, zoom.min].map((value) => {
    zoom.value = value;
    zoom.dispatchEvent(new Event("input"));
    return entry.chart.scales.x.max - entry.chart.scales.x.min;
  });
}

async function self_check() {
  await timeline_is_drawn();
  const first_fifo = () => document.querySelector("#fifo-table tbody tr").textContent;
  const cores = await with_each_choice("#fifo-controls", first_fifo);
  const loops_of_cores = await with_each_choice("#loop-controls", () => column_of(document.querySelector("#loop-table table"), 6));
  const samples = await with_each_choice("#timeline-controls", () => by_id("timeline-note").textContent);
  const tables = {};
  for (const table of document.querySelectorAll("table")) tables[table.caption.textContent] = sort_all(table);
  return {
    charts: charts.length,
    painted: charts.filter((entry) => is_painted(entry.canvas)).length,
    sections: [...document.querySelectorAll("section")].filter((section) => !section.hidden).map((section) => section.id),
    pictures: [...document.images].filter((image) => image.complete && image.naturalWidth > 0).length,
    tables,
    cores,
    loops_of_cores,
    samples,
    zoomed: zoomed(),
    title: document.title,
    elements_in_data: document.querySelectorAll("h1 *, figcaption *, #configuration-table td *:not(.tag)").length,
    dark: matchMedia("(prefers-color-scheme: dark)").matches,
    keys: rows_with_filter(false),
    changed_keys: rows_with_filter(true),
    page_width: document.documentElement.scrollWidth,
    window_width: document.documentElement.clientWidth,
    errors,
  };
}

/// The text must survive being written out as HTML.
async function leave_self_check() {
  const json = JSON.stringify(await self_check()).replaceAll("<", "\\u003c");
  document.body.append(element("script", { type: "application/json", id: "self-check" }, json));
}

if (location.hash === "#self-check") addEventListener("load", leave_self_check);
