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

/// [colour name, text] of each kind of bar.
function legend(entries) {
  const list = element("ul", { class: "legend" });
  for (const [name, text] of entries) {
    const swatch = element("span", { "aria-hidden": "true" });
    swatch.style.background = `var(--${name})`;
    list.append(element("li", {}, swatch, text));
  }
  return list;
}

/// Of an axis with whole numbers: no tick between two of them, which would have the text of one of them.
const whole_ticks = { precision: 0, maxRotation: 0, callback: (value) => whole(value) };

function axis_title(text) {
  return { display: true, text };
}
