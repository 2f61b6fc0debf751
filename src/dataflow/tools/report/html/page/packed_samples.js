// Timelines that the page itself holds. They are packed, and each is there several times: coarse for a look at the whole,
// finer for the parts that somebody zooms into.

async function unpacked(text) {
  const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const packed = new ReadableStream({
    start(controller) {
      controller.enqueue(bytes);
      controller.close();
    },
  });
  const reader = packed.pipeThrough(new DecompressionStream("deflate")).getReader();
  const decoder = new TextDecoder();
  let json = "";
  for (let part = await reader.read(); !part.done; part = await reader.read()) json += decoder.decode(part.value, { stream: true });
  return JSON.parse(json);
}

/// The bars of a level, as named_span() has them.
function rows_of_level({ begin: first }, { items, levels }, number) {
  const level = levels[number];
  let begin = first;
  return (level.item || []).map((item, i) => {
    begin += level.begin[i];
    return [...items[item], begin, begin + level.length[i], level.length[i] - level.gaps[i], level.iterations[i], level.spans[i]];
  });
}

/// "617 (core 9): the slowest, 389,747 cycles"
function name_of_packed({ sample, core, begin, end, is }) {
  return `${whole(sample)} (core ${core}): ` + [...is.map((what) => `the ${what}`), count_of(end - begin, "cycle")].join(", ");
}

function held_of_all() {
  const held = data.timelines.length, all = data.headline.samples;
  if (held === all) return all === 1 ? "" : `The page holds all ${count_of(all, "sample")}.`;
  return `The page holds ${held} of ${count_of(all, "sample")}; run --report-samples adds others, explore shows any.`;
}

/// `held`: says what the page holds.
class PackedSamples {
  constructor(shown, held = held_of_all) {
    this.held = held;
    if (data.timelines.length > 1)
      by_id("timeline-controls").append(labelled("Sample", choice(data.timelines.map(name_of_packed), (i) => this.choose(i))));
    this.timeline = new Timeline();
    this.timeline.shown = shown;
    this.timeline.looked = (part) => this.look_closer(part);
    this.choose(0);
  }

  async choose(i) {
    const row = data.timelines[i];
    this.chosen = row;
    delete by_id("timeline-chart").dataset.shown;
    const timeline = await unpacked(row.packed);
    if (this.chosen !== row) return; // another one by now
    this.levels = timeline.levels.map(({ resolution }, i) => ({ resolution, spans: rows_of_level(row, timeline, i) }));
    this.timeline.show({ ...row, occupancy: timeline.occupancy, spans: this.levels[0].spans });
    by_id("timeline-note").textContent += " " + this.what_is_held();
    by_id("timeline-chart").dataset.shown = row.sample;
  }

  what_is_held() {
    const { resolution } = this.levels[this.levels.length - 1];
    const merged = resolution > 1 ? ` Bars with less than ${whole(resolution)} cycles between them are drawn as one, however close one looks.` : "";
    return this.held() + merged;
  }

  /// The finest bars that are not too many to draw.
  look_closer({ min, max }) {
    const most_bars = 3000;
    let seen = null;
    for (const { spans } of this.levels) {
      const finer = spans.filter(([, , , begin, end]) => end > min && begin < max);
      if (seen && finer.length > most_bars) break;
      seen = finer;
    }
    this.timeline.show_spans(seen);
  }
}
