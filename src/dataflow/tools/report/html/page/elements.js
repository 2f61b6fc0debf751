// Elements, numbers and names as text. Data only ever becomes text nodes and attributes, never markup.

const errors = [];

function report_trouble(text) {
  errors.push(text);
  const place = document.getElementById("trouble");
  place.hidden = false;
  place.textContent = "Part of this report could not be drawn: " + errors.join("; ");
}
addEventListener("error", (event) => report_trouble(event.message));
addEventListener("unhandledrejection", (event) => report_trouble(String(event.reason)));

const data = JSON.parse(document.getElementById("data").textContent);

function by_id(id) {
  return document.getElementById(id);
}

/// An element with attributes and children; a child is a node or text.
function element(tag, attributes, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

const whole_numbers = new Intl.NumberFormat("en", { maximumFractionDigits: 0 });
function whole(number) {
  return whole_numbers.format(number);
}

function decimal(number, digits) {
  return new Intl.NumberFormat("en", { minimumFractionDigits: digits, maximumFractionDigits: digits }).format(number);
}

function percent(part, total) {
  return total > 0 ? (100 * part) / total : 0;
}

function in_words(name) {
  return name.replaceAll("_", " ");
}

function count_of(number, noun) {
  return whole(number) + " " + noun + (number === 1 ? "" : "s");
}

function milliseconds(cycles) {
  return cycles / (data.headline.clock_mhz * 1000);
}

/// "10 raster cores, a remark, 200 MHz"
function machine_text({ cores, cores_are, remark, clock_mhz }, ...more) {
  const parts = [`${cores} ${cores === 1 ? cores_are.replace(/s$/, "") : cores_are}`, remark, `${clock_mhz} MHz`, ...more];
  return parts.filter((part) => part).join(", ");
}

/// Large figures with what they are below them.
function fill_figures(list, figures) {
  for (const [name, value] of figures)
    list.append(element("div", {}, element("dt", {}, name), element("dd", {}, value)));
}

function labelled(text, control) {
  return element("label", {}, text, control);
}

/// A choice between texts; `chosen` gets the number of the one that was picked.
function choice(texts, chosen) {
  const select = element("select");
  texts.forEach((text, i) => select.append(element("option", { value: i }, text)));
  select.addEventListener("change", () => chosen(Number(select.value)));
  return select;
}

/// Hides a section without content, and the link to it.
function leave_out(section) {
  by_id(section).hidden = true;
  document.querySelector(`nav a[href="#${section}"]`).hidden = true;
}
