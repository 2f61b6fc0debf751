// What all charts share: colours of the style sheet, text sizes, and being drawn again when those change.

const charts = []; // {canvas, options_of, chart}

function colour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
}

function draw(entry) {
  if (entry.chart) entry.chart.destroy();
  entry.chart = new Chart(entry.canvas, entry.options_of());
}

/// Draws a chart into a box. `options_of` is asked again whenever colours change.
function add_chart(box, label, options_of) {
  const canvas = element("canvas", { role: "img", "aria-label": label });
  box.append(canvas);
  const entry = { canvas, options_of };
  charts.push(entry);
  draw(entry);
  return entry;
}

function remove_chart(entry) {
  entry.chart.destroy();
  entry.canvas.remove();
  charts.splice(charts.indexOf(entry), 1);
}

function use_colours() {
  Chart.defaults.color = colour("quiet");
  Chart.defaults.borderColor = colour("line");
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  Chart.defaults.plugins.tooltip.backgroundColor = colour("text");
  Chart.defaults.plugins.tooltip.titleColor = colour("card");
  Chart.defaults.plugins.tooltip.bodyColor = colour("card");
}

function set_chart_defaults() {
  Chart.defaults.animation = false;
  Chart.defaults.maintainAspectRatio = false;
  Chart.defaults.font.size = 12;
  Chart.defaults.plugins.legend.display = false; // a list in HTML wraps and can be read aloud
  Chart.defaults.plugins.tooltip.boxPadding = 4;
  use_colours();
  for (const query of ["(prefers-color-scheme: dark)", "print"])
    matchMedia(query).addEventListener("change", () => {
      use_colours();
      charts.forEach(draw);
    });
}

function swatch(colour_name) {
  const square = element("span", { class: "swatch", "aria-hidden": "true" });
  square.style.background = `var(--${colour_name})`;
  return square;
}

function fill_with_swatch(cell, name, colour_name = name) {
  cell.append(swatch(colour_name), in_words(name));
}

/// [colour name, text] of each kind of bar.
function legend(entries) {
  const list = element("ul", { class: "legend" });
  for (const [name, text] of entries) list.append(element("li", {}, swatch(name), text));
  return list;
}

/// Causes of the critical path have the colours of what a module would call them.
const path_colours = { read_latency: "empty_stall", backpressure: "full_stall", memory: "memory_stall" };
const path_colour = (cause) => path_colours[cause] || cause;

/// A bar for each label, of parts behind each other. `series`: {name, colour, values}; without a colour, that of the name.
function stacked_bars(labels, series, x, tooltip) {
  return {
    type: "bar",
    data: {
      labels,
      datasets: series.map((part) => ({
        label: in_words(part.name), data: part.values, backgroundColor: colour(part.colour || part.name), barPercentage: 0.85,
      })),
    },
    options: {
      indexAxis: "y",
      scales: { x: { stacked: true, ...x }, y: { stacked: true, ticks: { autoSkip: false } } },
      plugins: { tooltip: { callbacks: { label: tooltip } } },
    },
  };
}

/// Of an axis with whole numbers: no tick between two of them, which would have the text of one of them.
const whole_ticks = { precision: 0, maxRotation: 0, autoSkipPadding: 24, callback: (value) => whole(value) };

function axis_title(text) {
  return { display: true, text };
}
