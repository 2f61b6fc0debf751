// Any sample's timeline, finer where one looks closer.

class AnySample {
  constructor() {
    Object.assign(data, { loops: explorer.pinned.loops, modules: explorer.pinned.modules });
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
    this.request = { set: explorer.overrides, sample: number_in(this.sample) };
    this.say("Working it out");
    this.asked.want(this.request, this.request);
  }

  /// What has been asked for once is worked out anew when something is changed.
  follow() {
    if (this.request && this.request.set.join() !== explorer.overrides.join()) this.ask();
  }

  show(answer, request) {
    if (request !== this.request) return;
    this.timeline.show(answer);
    if (request.set.length > 0) this.say(by_id("timeline-note").textContent + " With " + request.set.join(" "));
  }

  look_closer({ min, max }) {
    clearTimeout(this.pause);
    this.pause = setTimeout(() => {
      this.finer.want({ ...this.request, from: Math.floor(min), to: Math.ceil(max) }, this.request);
    }, 120);
  }

  refine(answer, request) {
    if (request === this.request) this.timeline.show_spans(answer.spans);
  }
}
