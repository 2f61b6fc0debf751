#include "faster/workload/pictures/line_plot.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "faster/workload/pictures/colour.hpp"
#include "faster/workload/pictures/drawing.hpp"

namespace faster::pictures {

namespace {

constexpr int plot_width = 420;
constexpr int plot_height = 220;
constexpr int left_margin = 70;
constexpr int right_margin = 24;
constexpr int title_height = 36;
constexpr int axis_height = 48;  // ticks and the axis's name
constexpr int key_line_height = 18;
constexpr int steps = 5;
constexpr double letters = 0.4;

/// Draws a plot whose first pixel is (top, left).
class PlotPainter {
  public:
    PlotPainter(Image<Colour>& canvas, LinePlot const& plot, int top, int left)
        : canvas_(canvas), plot_(plot), top_(top + title_height), left_(left + left_margin) {
        double largest = 0;
        for (PlottedLine const& line : plot.lines)
            for (std::size_t i = 0; i < line.values.size(); ++i) {
                largest = std::max(largest, line.values[i]);
                last_ = std::max(last_, static_cast<double>(i));
            }
        end_ = axis_end(largest);
    }

    void draw() {
        write_text(canvas_, plot_.title, top_ - 12, left_, 0.5);
        draw_grid();
        for (std::size_t i = 0; i < plot_.lines.size(); ++i)
            draw_line(i);
    }

  private:
    int x(double number) const {
        return left_ + static_cast<int>(std::lround(plot_width * number / std::max(1.0, last_)));
    }
    int y(double value) const { return top_ + static_cast<int>(std::lround(plot_height * (1 - value / end_))); }

    void draw_grid() {
        for (int step = 0; step <= steps; ++step) {
            double const value = end_ * step / steps;
            draw_lines(canvas_, {{left_, y(value)}, {left_ + plot_width, y(value)}}, palette::grid, 1);
            std::string const text = fmt::format("{:.6g}", value);
            write_text(canvas_, text, y(value) + 4, left_ - 8 - text_width(text, letters), letters);
        }
        for (double const number : {0.0, std::floor(last_ / 2), last_}) {
            draw_lines(canvas_, {{x(number), top_}, {x(number), y(0)}}, palette::grid, 1);
            std::string const text = fmt::format("{:.0f}", number);
            write_text(canvas_, text, y(0) + 16, x(number) - text_width(text, letters) / 2, letters);
        }
        write_text(canvas_, plot_.across, y(0) + 36, left_ + (plot_width - text_width(plot_.across, letters)) / 2,
                   letters);
    }

    void draw_line(std::size_t number) {
        PlottedLine const& line = plot_.lines[number];
        Colour const colour = palette::lines[number % palette::lines.size()];
        std::vector<std::array<int, 2>> points;
        for (std::size_t i = 0; i < line.values.size(); ++i)
            points.push_back({x(static_cast<double>(i)), y(line.values[i])});
        if (points.size() == 1)
            points.push_back({left_ + plot_width, points.front()[1]});
        if (!points.empty())
            draw_lines(canvas_, points, colour, 2);
        int const baseline = y(0) + axis_height + key_line_height * static_cast<int>(number + 1);
        draw_lines(canvas_, {{left_, baseline - 4}, {left_ + 20, baseline - 4}}, colour, 2);
        std::string const last = line.values.empty() ? "" : fmt::format(": {:.4g}", line.values.back());
        write_text(canvas_, line.name + last, baseline, left_ + 28, letters);
    }

    Image<Colour>& canvas_;
    LinePlot const& plot_;
    int top_;
    int left_;
    double last_ = 0;  ///< number of the last value
    double end_ = 1;
};

}  // namespace

double axis_end(double largest) {
    if (!(largest > 0))
        return 1;
    double const rough = largest / steps, power = std::pow(10, std::floor(std::log10(rough)));
    for (double const factor : {1.0, 2.0, 5.0, 10.0})
        if (steps * factor * power >= largest)
            return steps * factor * power;
    return steps * 10 * power;
}

Image<Colour> drawn_plots(std::vector<LinePlot> const& plots) {
    std::size_t most_lines = 0;
    for (LinePlot const& plot : plots)
        most_lines = std::max(most_lines, plot.lines.size());
    int const count = static_cast<int>(plots.size()), columns = std::min(count, 2);
    int const width = left_margin + plot_width + right_margin;
    int const height = title_height + plot_height + axis_height + key_line_height * (static_cast<int>(most_lines) + 1);
    Image<Colour> canvas(height * ((count + columns - 1) / columns), width * columns, palette::paper);
    for (int i = 0; i < count; ++i)
        PlotPainter(canvas, plots[static_cast<std::size_t>(i)], height * (i / columns), width * (i % columns)).draw();
    return canvas;
}

}  // namespace faster::pictures
