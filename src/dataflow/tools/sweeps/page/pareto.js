// The front of two figures that are to be small.

class ParetoChart {
  constructor(changed) {
    this.chosen = [metrics[0], metrics.find((metric) => metric.name === "ramb36")];
    this.changed = changed;
    const titles = metrics.map((metric) => metric.title);
    ["Figure", "against"].forEach((text, which) => {
      const select = choice(titles, (i) => this.choose(which, metrics[i]));
      select.selectedIndex = metrics.indexOf(this.chosen[which]);
      by_id("pareto-controls").append(labelled(text, select));
    });
    by_id("pareto-legend").append(legend([["accent", "on the front"], ["idle_after", "others"]]));
    this.find_front();
    this.entry = add_chart(by_id("pareto-chart"), "Points by two figures, and the Pareto front", () => this.options());
  }

  choose(which, metric) {
    this.chosen[which] = metric;
    this.find_front();
    draw(this.entry);
    this.changed();
  }

  find_front() {
    this.front = pareto_front(done_points, ...this.chosen.map((metric) => metric.name));
    this.on_front = new Set(this.front);
  }

  dots(points) {
    return points.map((point) => ({ x: point[this.chosen[0].name], y: point[this.chosen[1].name], point }));
  }

  options() {
    const others = done_points.filter((point) => !this.on_front.has(point));
    return {
      type: "scatter",
      data: {
        datasets: [
          { data: this.dots(this.front), backgroundColor: colour("accent"), borderColor: colour("accent"), showLine: true,
            stepped: "before", borderWidth: 1.5, pointRadius: 5, pointHoverRadius: 7 },
          { data: this.dots(others), backgroundColor: colour("idle_after"), pointRadius: 3.5, pointHoverRadius: 6 },
        ],
      },
      options: {
        scales: {
          x: { title: axis_title(this.chosen[0].title) },
          y: { title: axis_title(this.chosen[1].title), beginAtZero: false },
        },
        plugins: { tooltip: { callbacks: { label: (item) => this.label(item.raw.point) } } },
      },
    };
  }

  label(point) {
    const figures = this.chosen.map((metric) => `${metric.title}: ${metric_text(metric, point[metric.name])}`);
    return [`point ${point.point}`, ...figures, ...settings_of(point)];
  }
}
