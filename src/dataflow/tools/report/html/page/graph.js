// The dataflow graph of a core, drawn where the build of the page's data has placed its parts.

function svg_element(tag, attributes, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes || {})) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

/// The points of a curve as an SVG path: the first, then three for each piece; the tip of the arrow last.
function curve_path({ points, tip }) {
  const [first, ...rest] = points.map(([x, y]) => `${x} ${y}`);
  return `M${first}C${rest.join(" ")}` + (tip ? `L${tip[0]} ${tip[1]}` : "");
}

/// Squeezes a text that is wider than the box around it: fonts differ, and what it says may have changed since the box
/// was placed.
function fit_texts(svg) {
  for (const text of svg.querySelectorAll("text")) {
    const room = text.parentNode.querySelector("rect").getAttribute("width") - 4;
    if (text.getComputedTextLength() <= room) continue;
    text.setAttribute("textLength", room);
    text.setAttribute("lengthAdjust", "spacingAndGlyphs");
  }
}

const least_scale = 0.8; // of text that can be read
const graph_margin = 4;

/// What the graph shows besides its parts: `modules` with their cycles, `fifos` summed over cores, `lane_cycles` of each
/// module, rows of a critical `path` (or null); of a deadlock, who waits in the circle, `stuck`, and who waits at all,
/// `waiting` (or null).
class DataflowGraph {
  constructor(box, selected = () => {}) {
    this.box = box;
    this.selected = selected;
    this.source = element("p", { class: "note", "aria-live": "polite" });
    box.after(this.source);
    new ResizeObserver(() => { if (this.figures && this.layout() !== this.drawn) this.show(this.figures); }).observe(box);
  }

  static is_there() {
    return Boolean(data.graph && data.graph.wide);
  }

  /// From left to right if there is room for that, else what is less wide. Neither is drawn smaller than it can be read.
  layout() {
    const { wide, tall } = data.graph;
    return wide.width + 2 * graph_margin <= this.box.clientWidth || wide.width <= tall.width ? wide : tall;
  }

  show(figures) {
    this.figures = figures;
    const layout = this.drawn = this.layout();
    const svg = svg_element("svg", {
      viewBox: `${-graph_margin} ${-graph_margin} ${layout.width + 2 * graph_margin} ${layout.height + 2 * graph_margin}`, role: "group", "aria-label": "Dataflow graph", class: "graph",
    });
    svg.style.maxWidth = `${Math.round(layout.width * 1.5)}px`;
    svg.style.minWidth = `${Math.round(least_scale * (layout.width + 2 * graph_margin))}px`;
    for (const memory of data.graph.memories) this.add_links(svg, layout, memory);
    for (const name of Object.keys(layout.edges)) if (name.startsWith("memory:")) this.add_link(svg, layout.edges[name]);
    for (const fifo of data.graph.fifos) this.add_fifo(svg, layout, fifo);
    for (const memory of data.graph.memories) this.add_memory(svg, layout, memory);
    if (layout.nodes["memory:external memory"]) this.add_external(svg, layout.nodes["memory:external memory"]);
    for (const process of data.graph.processes) this.add_process(svg, layout, process);
    const focused = document.activeElement && document.activeElement.dataset ? document.activeElement.dataset.part : null;
    this.box.replaceChildren(svg);
    fit_texts(svg);
    if (focused) for (const part of svg.querySelectorAll("[data-part]")) if (part.dataset.part === focused) part.focus();
  }

  /// A group that says what it is. A click, or Enter, chooses it, and tells where `modules` are described.
  part(svg, kind, name, text, modules) {
    const group = svg_element("g", { class: kind, "data-part": `${kind}:${name}`, "aria-label": text, role: "button", tabindex: "0" });
    group.append(svg_element("title", {}, [text, ...modules.filter((module) => data.graph.sources[module]).map(source_text)].join("\n")));
    svg.append(group);
    const choose = () => {
      this.show_sources(modules);
      this.selected(kind, name);
    };
    group.addEventListener("click", choose);
    group.addEventListener("keydown", (event) => {
      if (event.key !== "Enter" && event.key !== " ") return;
      event.preventDefault();
      choose();
    });
    return group;
  }

  show_sources(modules) {
    const known = [...new Set(modules)].filter((module) => data.graph.sources[module]);
    this.source.replaceChildren(...known.map((module) => {
      const { link } = data.graph.sources[module];
      return element("span", { class: "source" }, link ? element("a", { href: link }, source_text(module)) : source_text(module), " ");
    }));
  }

  add_link(svg, edge) {
    svg.append(svg_element("path", { d: curve_path(edge), class: "link" }));
  }

  add_links(svg, layout, { bram }) {
    for (const name of [`bram:${bram}`, `bram:${bram}:reader`]) if (layout.edges[name]) this.add_link(svg, layout.edges[name]);
  }

  on_path(module) {
    const { path, total_cycles } = this.figures;
    return path ? path.rows.reduce((sum, row) => sum + (row.module === module ? row.cycles : 0), 0) / total_cycles : 0;
  }

  add_process(svg, layout, name) {
    const { at: [x, y], width, height } = layout.nodes[`process:${name}`];
    const row = (this.figures.modules || []).find(({ module }) => module === name);
    const share = this.on_path(name);
    const waits = (this.figures.stuck || []).some((wait) => wait.process === name);
    const of_path = share > 0 ? `, ${decimal(100 * share, 1)} % of the critical path` : "";
    const group = this.part(svg, "process", name, name + of_path, [name]);
    group.classList.toggle("critical", share >= 0.001);
    group.classList.toggle("stuck", waits);
    group.classList.toggle("waiting", (this.figures.waiting || []).some((wait) => wait.process === name));
    group.append(svg_element("rect", { x: x - width / 2, y: y - height / 2, width, height, rx: 4 }),
      svg_element("text", { x, y: y - height / 2 + 13 }, name));
    if (share >= 0.001) group.append(svg_element("text", { x, y: y + 7, class: "small" }, `${decimal(100 * share, 1)} % of path`));
    if (row) this.add_bar(group, row, x - width / 2 + 4, y + height / 2 - 9, width - 8);
  }

  /// Where the cycles of a module went.
  add_bar(group, row, x, y, width) {
    const sum = row.cycles.reduce((all, cycles) => all + cycles, 0);
    let at = x;
    row.cycles.forEach((cycles, c) => {
      const part = sum > 0 ? (width * cycles) / sum : 0;
      if (part > 0.2) {
        const bar = svg_element("rect", { x: at, y, width: part, height: 5, class: "bar" });
        bar.style.fill = `var(--${data.cycle_classes[c]})`;
        group.append(bar);
      }
      at += part;
    });
  }

  add_fifo(svg, layout, { fifo, writer, reader }) {
    const edge = layout.edges[`fifo:${fifo}`];
    const row = this.figures.fifos.find((one) => one.fifo === fifo);
    if (!edge || !row) return;
    const share = (cycles) => Math.min(1, cycles / Math.max(1, this.figures.lane_cycles));
    const [full, empty] = [share(row.full_stall_cycles), share(row.empty_stall_cycles)];
    const text = `${fifo}, from ${writer} to ${reader}: at most ${row.max_occupancy} of ${row.capacity} tokens, ` +
      `full for ${decimal(100 * full, 1)} % and empty for ${decimal(100 * empty, 1)} % of the time`;
    const group = this.part(svg, "fifo", fifo, text, [writer, reader]);
    const waits = (this.figures.stuck || []).find((wait) => wait.fifo === fifo);
    const crossed = this.figures.path && this.figures.path.rows.some((one) => one.item === fifo && one.crossings > 0);
    group.classList.toggle("critical", Boolean(crossed));
    group.classList.toggle("stuck", Boolean(waits));
    const line = svg_element("path", { d: curve_path(edge), class: "line" });
    line.style.stroke = waits ? "var(--port_conflict)" : this.stall_colour(full, empty);
    line.style.strokeWidth = 1.2 + 3 * Math.max(full, empty);
    group.append(svg_element("path", { d: curve_path(edge), class: "halo" }), line, this.arrow(edge, line.style.stroke));
    this.add_gauge(group, edge.label, row);
  }

  stall_colour(full, empty) {
    const strongest = Math.max(full, empty);
    const name = full >= empty ? "full_stall" : "empty_stall";
    return strongest < 0.001 ? "var(--quiet)" : `color-mix(in srgb, var(--${name}) ${Math.round(35 + 65 * strongest)}%, var(--line))`;
  }

  /// From where the curve ends to its tip.
  arrow({ points, tip }, stroke) {
    const [x, y] = points[points.length - 1];
    const [dx, dy] = [(tip[0] - x) / 2, (tip[1] - y) / 2];
    const head = svg_element("path", { d: `M${tip[0]} ${tip[1]}L${x - dy} ${y + dx}L${x + dy} ${y - dx}Z` });
    head.style.fill = stroke;
    return head;
  }

  /// Name and most tokens, with the share of the capacity that those fill.
  add_gauge(group, label, row) {
    const [x, y] = label;
    const width = Math.max(40, row.fifo.length * 6.6 + 8);
    const filled = row.capacity > 0 ? Math.min(1, row.max_occupancy / row.capacity) : 0;
    group.append(
      svg_element("rect", { x: x - width / 2, y: y - 9, width, height: 18, rx: 3, class: "gauge" }),
      svg_element("rect", { x: x - width / 2, y: y + 5, width: width * filled, height: 4, rx: 1, class: "level" }),
      svg_element("text", { x, y: y + 2, class: "small" }, row.fifo));
  }

  add_memory(svg, layout, { bram, owner, ports, banks }) {
    const node = layout.nodes[`bram:${bram}`];
    if (!node) return; // the configuration has no such memory
    const { at: [x, y], width, height } = node;
    const now = (this.figures.brams || []).find((row) => row.bram === bram) || { ports, banks };
    const of_banks = now.banks > 1 ? `${now.banks} banks of ` : "";
    const text = of_banks + count_of(now.ports, "port");
    const group = this.part(svg, "bram", bram, `${bram} of ${owner}: ${text}`, [owner]);
    const crowded = this.figures.path && this.figures.path.rows.some((row) => row.item === bram && row.cause === "port_conflict");
    group.classList.toggle("critical", Boolean(crowded));
    group.append(svg_element("rect", { x: x - width / 2, y: y - height / 2, width, height, rx: 12 }),
      svg_element("text", { x, y: y - 2 }, bram), svg_element("text", { x, y: y + 10, class: "small" }, text));
  }

  add_external(svg, { at: [x, y], width, height }) {
    svg.append(svg_element("g", { class: "bram" }, svg_element("rect", { x: x - width / 2, y: y - height / 2, width, height, rx: 12 }),
      svg_element("text", { x, y: y + 4 }, "external memory")));
  }
}

function source_text(module) {
  const { file, line } = data.graph.sources[module];
  return `${module} is described in ${file}:${line}.`;
}

function graph_legend() {
  return legend([...data.cycle_classes.map((name) => [name, in_words(name)]), ["critical", "on the critical path"]]);
}
