// Fills the page of an evaluation, from top to bottom. Its data are evaluation.json.

const line_colours = ["loop-0", "loop-1", "loop-2", "empty_stall", "full_stall", "accent", "setup", "recurrence"];
const largest_cm = 10;
const methods = data.methods.map((method) => method.name);
const objects = data.curves.filter((curve) => curve.method === methods[0]).map((curve) => curve.object);
const shown = { object: objects.length - 1, errors: "add_s_m" };

function line_colour(i) {
  return line_colours[i % line_colours.length];
}

function visibility_words() {
  if (data.visible_from <= 0)
    return "";
  const unknown = data.of_unknown_visibility > 0 ? ` (${data.of_unknown_visibility} of unknown visibility)` : "";
  return `, each at least ${100 * data.visible_from} % visible${unknown}`;
}

function show_headline() {
  const all = data.rows.find((row) => row.obj_id === 0);
  by_id("machine").textContent = `${data.dataset}: ${count_of(all.instances, "instance")} of ${count_of(objects.length - 1, "object")} in ` +
    `${count_of(data.images, "image")}${visibility_words()}; ${count_of(data.replicates, "bootstrap")}, seed ${data.seed}`;
}

/// A step up at each error.
function steps_of(curve) {
  const points = [{ x: 0, y: 0 }];
  curve[shown.errors].forEach((error, i) => points.push({ x: 100 * error, y: percent(i + 1, curve.instances) }));
  points.push({ x: largest_cm, y: points[points.length - 1].y });
  return points;
}

function accuracy_lines() {
  const curves = data.curves.filter((curve) => curve.object === objects[shown.object]);
  return {
    type: "line",
    data: {
      datasets: curves.map((curve, i) => ({
        label: curve.method,
        data: steps_of(curve),
        stepped: true,
        pointRadius: 0,
        borderWidth: 2,
        borderColor: colour(line_colour(i)),
        backgroundColor: colour(line_colour(i)),
      })),
    },
    options: {
      scales: {
        x: { type: "linear", min: 0, max: largest_cm, title: axis_title(`threshold of ${shown.errors === "add_m" ? "ADD" : "ADD-S"} [cm]`) },
        y: { min: 0, max: 100, title: axis_title("accuracy [%]") },
      },
      interaction: { mode: "nearest", axis: "x", intersect: false },
      plugins: { tooltip: { callbacks: { label: (item) => `${item.dataset.label}: ${decimal(item.parsed.y, 1)} % within ${decimal(item.parsed.x, 2)} cm` } } },
    },
  };
}

function show_accuracy() {
  const box = by_id("accuracy-chart");
  const entry = add_chart(box, "Accuracy over the threshold; the table below has the areas", accuracy_lines);
  const object_choice = choice(objects, (i) => { shown.object = i; draw(entry); });
  object_choice.value = shown.object;
  by_id("accuracy-choice").append(
    labelled("Object", object_choice),
    labelled("Error", choice(["ADD-S", "ADD"], (i) => { shown.errors = ["add_s_m", "add_m"][i]; draw(entry); })));
  box.before(legend(methods.map((method, i) => [line_colour(i), method])));
}

function with_range(scores, name, sign) {
  if (!scores[name]) return "-";
  const [value, low, high] = scores[name].map((number) => (sign && number > 0 ? "+" : "") + decimal(number, 1));
  return `${value} (${low} to ${high})`;
}

function score_columns(of, sign) {
  return Object.entries(data.scores).map(([name, title]) =>
    figure(title, (row) => row[of][name] ? row[of][name][0] : -Infinity, (row) => with_range(row[of], name, sign)));
}

/// An object's methods below each other.
function by_object(rows) {
  const order = [...objects, "mean"];
  return [...rows].sort((a, b) => order.indexOf(a.object) - order.indexOf(b.object));
}

function show_scores() {
  new SortableTable(by_id("scores-table"), "Scores [%]", [
    { title: "object", value: (row) => row.object },
    { title: "method", value: (row) => row.method },
    figure("instances", (row) => row.instances),
    figure("estimated", (row) => row.estimated),
    ...score_columns("scores", false),
  ], by_object(data.rows));
}

function show_differences() {
  if (methods.length < 2) return leave_out("differences");
  by_id("difference-words").textContent = `Points more than ${methods[0]}, on the same draws of images.`;
  new SortableTable(by_id("differences-table"), `More than ${methods[0]} [points]`, [
    { title: "object", value: (row) => row.object },
    { title: "method", value: (row) => row.method },
    ...score_columns("more_than_first", true),
  ], by_object(data.rows.filter((row) => row.method !== methods[0])));
}

set_chart_defaults();
show_headline();
show_accuracy();
show_scores();
show_differences();
