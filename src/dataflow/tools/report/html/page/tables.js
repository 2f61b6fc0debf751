// Tables that are sorted by a click on the head of a column. They scroll inside their box, never the page.

function compared(a, b) {
  return typeof a === "number" ? a - b : a.localeCompare(b, "en");
}

/// A column: title; value(row), to sort by; text(row), the value itself unless given; fill(cell, row) for more than
/// text; number: to the right, largest first. The first column heads its row.
class SortableTable {
  constructor(place, caption, columns, rows, options = {}) {
    this.columns = columns;
    this.row_class = options.row_class || (() => "");
    this.heads = columns.map((column, i) => this.head(column, i));
    this.body = element("tbody");
    const table = element("table", {}, element("caption", {}, caption),
      element("thead", {}, element("tr", {}, ...this.heads)), this.body);
    place.append(element("div", { class: "scroll " + (options.box || ""), role: "region", tabindex: "0", "aria-label": caption }, table));
    this.show(rows);
  }

  head(column, i) {
    const button = element("button", { type: "button" }, column.title);
    button.addEventListener("click", () => this.sort_by(i));
    const head = element("th", { scope: "col", "aria-sort": "none" }, button);
    head.classList.toggle("number", column.number === true);
    return head;
  }

  /// Replaces the rows; they stay sorted as they were.
  show(rows) {
    this.rows = rows.map((row) => ({ row, line: this.line(row) }));
    this.arrange();
  }

  line(row) {
    const line = element("tr", { class: this.row_class(row) });
    this.columns.forEach((column, i) => {
      const cell = element(i === 0 ? "th" : "td", i === 0 ? { scope: "row" } : {});
      if (column.number) cell.classList.add("number");
      if (column.wrap) cell.classList.add("wrap");
      if (column.fill) column.fill(cell, row);
      else cell.textContent = column.text ? column.text(row) : column.value(row);
      line.append(cell);
    });
    return line;
  }

  sort_by(i) {
    const first = this.columns[i].number ? "descending" : "ascending";
    const other = first === "ascending" ? "descending" : "ascending";
    const order = this.heads[i].getAttribute("aria-sort") === first ? other : first;
    this.heads.forEach((head, k) => head.setAttribute("aria-sort", k === i ? order : "none"));
    this.arrange();
  }

  arrange() {
    const i = this.heads.findIndex((head) => head.getAttribute("aria-sort") !== "none");
    const lines = [...this.rows];
    if (i >= 0) {
      const sign = this.heads[i].getAttribute("aria-sort") === "ascending" ? 1 : -1;
      const value = this.columns[i].value;
      lines.sort((a, b) => sign * compared(value(a.row), value(b.row)));
    }
    this.body.replaceChildren(...lines.map((entry) => entry.line));
  }
}

/// A column with a figure.
function figure(title, value, text) {
  return { title, value, text: text || ((row) => whole(value(row))), number: true };
}

/// Rows of one core, or of all cores with `added` summed up and `largest` maximized.
function rows_of(rows, core, name_of, added, largest) {
  if (core !== null) return rows.filter((row) => row.core === core);
  const sums = new Map();
  for (const row of rows) {
    const sum = sums.get(name_of(row));
    if (!sum) {
      sums.set(name_of(row), { ...row });
      continue;
    }
    for (const key of added) sum[key] += row[key];
    for (const key of largest) sum[key] = Math.max(sum[key], row[key]);
  }
  return [...sums.values()];
}

/// A choice of core, where there are several; `chosen` gets null for all of them.
function add_core_choice(place, chosen) {
  const cores = data.headline.cores;
  if (cores < 2) return;
  const texts = ["all, summed up", ...Array.from({ length: cores }, (_, core) => `core ${core}`)];
  place.append(labelled("Cores", choice(texts, (i) => chosen(i === 0 ? null : i - 1))));
}
