// Who waits for whom in a deadlock.

/// Those that wait for each other in a circle; others may only wait for these.
function circle_of(deadlock) {
  return deadlock.wait_cycle.length > 0 ? deadlock.wait_cycle : deadlock.stuck;
}

/// "lines full, 2 of 2"
function what_holds_up({ fifo, to, occupancy, capacity, waits_for }) {
  return waits_for === "memory" ? `${fifo} from memory` : `${fifo} ${to === "write" ? "full" : "empty"}, ${occupancy} of ${capacity}`;
}

function wait_sentence(wait) {
  const why = wait.waits_for === "memory" ? wait.fifo
    : `${wait.fifo} is ${wait.to === "write" ? "full" : "empty"}, ${wait.occupancy} of ${count_of(wait.capacity, "token")}`;
  const where = [wait.position, wait.source].filter((text) => text).join(", ");
  return `${wait.process} waits for ${wait.waits_for} since cycle ${whole(wait.since_cycle)}: ${why}` + (where ? ` (${where}).` : ".");
}

/// A ring of processes, with an arrow from each to the one that it waits for.
class WaitCircle {
  constructor(circle) {
    this.circle = circle;
    this.radius = [150, 40 + 26 * circle.length];
    this.radius[1] = Math.min(150, this.radius[1]);
    this.middle = [230, this.radius[1] + 24];
  }

  at(angle) {
    return [this.middle[0] + this.radius[0] * Math.sin(angle), this.middle[1] - this.radius[1] * Math.cos(angle)];
  }

  angle(i) {
    return (2 * Math.PI * i) / this.circle.length;
  }

  half_width(i) {
    return 10 + 3.6 * this.circle[i].process.length;
  }

  is_inside(i, [x, y]) {
    const [at_x, at_y] = this.at(this.angle(i));
    return Math.abs(x - at_x) < this.half_width(i) + 4 && Math.abs(y - at_y) < 17;
  }

  /// Along the ring, from where it leaves one box to where it comes to the next.
  arrow(i) {
    const next = (i + 1) % this.circle.length;
    const step = 0.01;
    let [begin, end] = [this.angle(i), this.angle(i + 1)];
    while (begin < end && this.is_inside(i, this.at(begin))) begin += step;
    while (begin < end && this.is_inside(next, this.at(end))) end -= step;
    const points = Array.from({ length: 25 }, (_, k) => this.at(begin + ((end - begin) * k) / 24).map((value) => value.toFixed(1)).join(" "));
    const [x, y] = this.at(end), [from_x, from_y] = this.at(end - 4 * step);
    const turn = (Math.atan2(y - from_y, x - from_x) * 180) / Math.PI;
    return [svg_element("path", { d: "M" + points.join("L") }),
      svg_element("path", { class: "tip", d: "M0 0L-10 -5L-10 5Z", transform: `translate(${x.toFixed(1)} ${y.toFixed(1)}) rotate(${turn.toFixed(1)})` })];
  }

  box(x, y, half_width, text, what) {
    const height = what ? 16 : 26;
    return [svg_element("rect", { x: x - half_width, y: y - height / 2, width: 2 * half_width, height, rx: 4, ...(what ? { class: "what" } : {}) }),
      svg_element("text", { x, y: y + 4 }, text)];
  }

  drawing() {
    const svg = svg_element("svg", {
      viewBox: `0 0 460 ${2 * this.middle[1]}`, class: "wait-circle", role: "img",
      "aria-label": "Who waits for whom: " + this.circle.map((wait) => `${wait.process} for ${wait.waits_for}`).join(", "),
    });
    const numbers = this.circle.map((_, i) => i);
    for (const i of numbers) svg.append(...this.arrow(i));
    for (const i of numbers) svg.append(...this.box(...this.at(this.angle(i)), this.half_width(i), this.circle[i].process, false));
    for (const i of numbers) {
      const text = what_holds_up(this.circle[i]);
      const [x, y] = this.at(this.angle(i + 0.5));
      const half_width = 4 + 2.9 * text.length;
      svg.append(...this.box(Math.min(460 - half_width, Math.max(half_width, x)), y, half_width, text, true));
    }
    return svg;
  }
}

/// What could be changed; `deeper` are the full FIFOs of the circle that have a depth to be set.
function ways_out(deadlock) {
  const { deeper } = deadlock;
  if (deadlock.wait_cycle.length === 0)
    return "Nobody waits in a circle: some process ends before it has written what others wait for.";
  if (deeper.length === 0)
    return "No FIFO of the circle is full, so no depth frees it: each process waits to read before, or in the stage in which, it writes what the next one needs.";
  const keys = deeper.map(({ key, depth }) => `${key} (now ${depth})`);
  return (keys.length === 1 ? `It takes a larger ${keys[0]}` : `At least one of these has to be larger: ${keys.join(", ")}`) +
    ": the others of the circle can go on then, as far as other FIFOs let them.";
}

/// Nothing for none. `how_deep`: where to find out, if a depth can free it.
function show_deadlock(place, deadlock, how_deep = "") {
  place.hidden = !deadlock;
  place.replaceChildren();
  if (!deadlock) return;
  const in_circle = deadlock.wait_cycle.length > 0;
  place.classList.add("waits");
  place.append(element("p", {}, `Deadlock in cycle ${whole(deadlock.cycle)}` + (in_circle ? ": each waits for the next, the last for the first." : ".")));
  if (deadlock.wait_cycle.length > 1) place.append(new WaitCircle(deadlock.wait_cycle).drawing());
  place.append(element("ul", {}, ...circle_of(deadlock).map((wait) => element("li", {}, wait_sentence(wait)))),
    element("p", { class: "way-out" }, ways_out(deadlock) + (deadlock.deeper.length > 0 ? how_deep : "")));
}
