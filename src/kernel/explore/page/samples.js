// Any sample's timeline, finer where one looks closer.

class AnySample {
  constructor() {
    Object.assign(data, { timelines: [], loops: explorer.pinned.loops, modules: explorer.pinned.modules, external_memory: null });
    this.sample = element("input", { type: "number", min: 0, max: data.samples - 1, value: Math.min(1, data.samples - 1), "aria-label": "sample" });
    const show = element("button", { type: "button", id: "show-sample" }, "show");
    by_id("timeline-controls").append(element("label", {}, `Sample 0 to ${data.samples - 1}`, this.sample), show);
    this.timeline = new Timeline();
    this.timeline.looked = (part) => this.look_closer(part);
    this.finer = new Latest("timeline", (answer, context) => this.refine(answer, context), (error) => this.say(error.message));
    this.asked = new Latest("timeline", (answer, context) => this.show(answer, context), (error) => this.say(error.message));
    show.addEventListener("click", () => this.ask());
    this.sample.addEventListener("change", () => this.ask());
    const seen = new IntersectionObserver((entries) => {
      if (!entries.some((entry) => entry.isIntersecting)) return;
      seen.disconnect();
      if (!this.request) this.ask();
    });
    seen.observe(by_id("timeline-chart"));
  }

  say(text) {
    by_id("timeline-note").textContent = text;
  }

  /// With what is changed now.
  ask() {
    this.request = { set: explorer.overrides, sample: Number(this.sample.value) };
    this.say("Working it out");
    this.asked.want(this.request, this.request);
  }

  show(answer, request) {
    if (request !== this.request) return;
    const most_cycles_shown_alone = 50;
    this.timeline.zoom.setAttribute("max", Math.max(0, Math.log2((answer.end - answer.begin) / most_cycles_shown_alone)));
    this.whole = answer;
    this.timeline.show(answer);
    if (request.set.length > 0) this.say(by_id("timeline-note").textContent + " With " + request.set.join(" "));
  }

  look_closer({ min, max }) {
    clearTimeout(this.pause);
    this.pause = setTimeout(() => {
      const [from, to] = [Math.max(0, Math.floor(min)), Math.ceil(max)].map((cycle) => cycle + this.whole.begin);
      this.finer.want({ ...this.request, from, to }, this.request);
    }, 120);
  }

  refine(answer, request) {
    if (request === this.request) this.timeline.show_spans(answer.spans);
  }
}
