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

function self_check() {
  const tables = {};
  for (const table of document.querySelectorAll("table")) tables[table.caption.textContent] = sort_all(table);
  return {
    charts: charts.length,
    painted: charts.filter((entry) => is_painted(entry.canvas)).length,
    sections: [...document.querySelectorAll("section")].filter((section) => !section.hidden).map((section) => section.id),
    pictures: [...document.images].filter((image) => image.complete && image.naturalWidth > 0).length,
    tables,
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
function leave_self_check() {
  const json = JSON.stringify(self_check()).replaceAll("<", "\\u003c");
  document.body.append(element("script", { type: "application/json", id: "self-check" }, json));
}

if (location.hash === "#self-check") addEventListener("load", leave_self_check);
