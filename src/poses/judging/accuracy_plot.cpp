#include "poses/judging/accuracy_plot.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "faster/workload/pictures/colour.hpp"
#include "faster/workload/pictures/drawing.hpp"

namespace faster::poses {
namespace {

using pictures::draw_lines;
using pictures::text_width;
using pictures::write_text;
namespace palette = pictures::palette;

constexpr int plot_width = 260;
constexpr int plot_height = 200;
constexpr int left_margin = 52;
constexpr int right_margin = 18;
constexpr int title_height = 34;
constexpr int axis_height = 46;  // ticks and the axis's name
constexpr int line_height = 18;
constexpr int most_columns = 4;
constexpr double letters = 0.4;

/// What a panel shows: the curves of an object, one per method.
struct Panel {
    std::vector<AccuracyCurve const*> curves;
    std::vector<double> areas;  ///< [%]
};

std::vector<double> const& errors_of(AccuracyCurve const& curve, CurveOf error) {
    return error == CurveOf::add_s ? curve.add_s_m : curve.add_m;
}

double area_of(AccuracyCurve const& curve, CurveOf error) {
    std::vector<WeightedError> errors;
    for (double const error_m : errors_of(curve, error))
        errors.push_back({error_m, 1});
    return 100 * area_under_accuracy(errors, static_cast<double>(curve.instances));
}

/// Curves stand by method; panels by object.
std::vector<Panel> panels_of(Evaluation const& evaluation, CurveOf error) {
    std::vector<Panel> panels(evaluation.curves.size() / evaluation.methods.size());
    for (std::size_t i = 0; i < evaluation.curves.size(); ++i) {
        Panel& panel = panels[i % panels.size()];
        panel.curves.push_back(&evaluation.curves[i]);
        panel.areas.push_back(area_of(evaluation.curves[i], error));
    }
    return panels;
}

/// Draws a panel whose first pixel is (top, left).
class PanelPainter {
  public:
    PanelPainter(Image<Colour>& canvas, int top, int left)
        : canvas_(canvas), top_(top + title_height), left_(left + left_margin), panel_left_(left) {}

    void draw(Panel const& panel, CurveOf error) {
        write_text(canvas_, panel.curves.front()->object, top_ - 12, left_, 0.5);
        draw_grid();
        draw_axis_name(error);
        for (std::size_t i = 0; i < panel.curves.size(); ++i) {
            auto const thickness = static_cast<int>(std::min<std::size_t>(panel.curves.size() - i, 3) + 1);
            draw_curve(*panel.curves[i], errors_of(*panel.curves[i], error), palette::lines[i % palette::lines.size()],
                       thickness);  // what lies below shows at its sides
            draw_key(*panel.curves[i], panel.areas[i], i);
        }
    }

  private:
    int x(double error_m) const { return left_ + static_cast<int>(std::lround(plot_width * error_m / largest_add_m)); }
    int y(double share) const { return top_ + static_cast<int>(std::lround(plot_height * (1 - share))); }

    void draw_grid() {
        for (int step = 0; step <= 5; ++step) {
            double const share = step / 5.0, error_m = largest_add_m * share;
            draw_lines(canvas_, {{left_, y(share)}, {left_ + plot_width, y(share)}}, palette::grid, 1);
            draw_lines(canvas_, {{x(error_m), top_}, {x(error_m), top_ + plot_height}}, palette::grid, 1);
            std::string const percent = fmt::format("{}", 20 * step), centimetres = fmt::format("{}", 2 * step);
            write_text(canvas_, percent, y(share) + 4, left_ - 8 - text_width(percent, letters), letters);
            write_text(canvas_, centimetres, y(0) + 16, x(error_m) - text_width(centimetres, letters) / 2, letters);
        }
    }

    void draw_axis_name(CurveOf error) {
        std::string const name = fmt::format("accuracy [%] over {} [cm]", error == CurveOf::add_s ? "ADD-S" : "ADD");
        write_text(canvas_, name, y(0) + 36, left_ + (plot_width - text_width(name, letters)) / 2, letters);
    }

    void draw_curve(AccuracyCurve const& curve, std::vector<double> const& errors_m, Colour colour, int thickness) {
        std::vector<std::array<int, 2>> points{{x(0), y(0)}};
        for (std::size_t i = 0; i < errors_m.size(); ++i) {
            points.push_back({x(errors_m[i]), points.back()[1]});
            points.push_back({x(errors_m[i]), y(static_cast<double>(i + 1) / static_cast<double>(curve.instances))});
        }
        points.push_back({x(largest_add_m), points.back()[1]});
        draw_lines(canvas_, points, colour, thickness);
    }

    void draw_key(AccuracyCurve const& curve, double area, std::size_t number) {
        int const baseline = y(0) + axis_height + line_height * static_cast<int>(number + 1);
        draw_lines(canvas_, {{panel_left_ + 16, baseline - 4}, {left_ - 12, baseline - 4}},
                   palette::lines[number % palette::lines.size()], 2);
        write_text(canvas_, fmt::format("{}: {:.1f}", curve.method, area), baseline, left_ - 6, letters);
    }

    Image<Colour>& canvas_;
    int top_;
    int left_;
    int panel_left_;
};

}  // namespace

Image<Colour> accuracy_plot(Evaluation const& evaluation, CurveOf error) {
    std::vector<Panel> const panels = panels_of(evaluation, error);
    int const count = static_cast<int>(panels.size()), columns = std::min(count, most_columns);
    int const methods = static_cast<int>(evaluation.methods.size());
    int const width = left_margin + plot_width + right_margin;
    int const height = title_height + plot_height + axis_height + line_height * (methods + 1);
    Image<Colour> canvas(height * ((count + columns - 1) / columns), width * columns, palette::paper);
    for (int i = 0; i < count; ++i)
        PanelPainter(canvas, height * (i / columns), width * (i % columns))
            .draw(panels[static_cast<std::size_t>(i)], error);
    return canvas;
}

}  // namespace faster::poses
