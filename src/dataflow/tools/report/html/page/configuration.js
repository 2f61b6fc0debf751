// All keys, and which of them somebody has changed.

function show_configuration() {
  const changed = data.configuration.filter((row) => !row.default);
  by_id("configuration-note").textContent =
    `${count_of(data.configuration.length, "key")} as resolved; ${changed.length} differ from their defaults.`;
  const table = new SortableTable(by_id("configuration-table"), "Configuration", [
    { title: "key", value: (row) => row.key },
    { title: "value", value: (row) => row.value, wrap: true },
    { title: "default", value: (row) => (row.default ? "default" : "changed"),
      fill: (cell, row) => cell.append(row.default ? "default" : element("span", { class: "tag" }, "changed")) },
  ], data.configuration, { box: "high", row_class: (row) => (row.default ? "" : "changed") });
  const filter = element("input", { type: "checkbox", id: "only-non-defaults" });
  filter.addEventListener("change", () => table.show(filter.checked ? changed : data.configuration));
  by_id("configuration-controls").append(element("label", {}, filter, "only non-defaults"));
}
