#include "workload/bop/pose_results.hpp"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

#include "kernel/base/files/csv_cells.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/base/printable.hpp"
#include "workload/bop/pose_numbers.hpp"

namespace faster::bop {
namespace {

enum Column { scene_id, im_id, obj_id, score, rotation, translation, time };
std::vector<std::string> const& columns() {
    static std::vector<std::string> const names{"scene_id", "im_id", "obj_id", "score", "R", "t", "time"};
    return names;
}

template <class Number> bool parse(std::string_view text, Number& number) {
    char const* const end = text.data() + text.size();
    auto const result = std::from_chars(text.data(), end, number);
    return result.ec == std::errc{} && result.ptr == end && std::isfinite(static_cast<double>(number));
}

/// One row of the table, and how to complain about it.
class Row {
  public:
    Row(std::filesystem::path const& path, std::size_t line, std::string_view const* cells)
        : path_(path), line_(line), cells_(cells) {}

    int id(Column column) const {
        int value = 0;
        if (!parse(cells_[column], value) || value < 0)
            fail(column, "an integer from 0");
        return value;
    }
    double number(Column column) const {
        double value = 0;
        if (!parse(cells_[column], value))
            fail(column, "a finite number");
        return value;
    }
    std::vector<double> numbers(Column column, std::size_t count) const {
        std::vector<double> values;
        for (std::string_view rest = cells_[column]; !rest.empty();) {
            values.emplace_back();
            if (!parse(take_word(rest), values.back()))
                fail(column, fmt::format("{} finite numbers parted by blanks", count));
        }
        if (values.size() != count)
            fail(column, fmt::format("{} numbers parted by blanks, not {}", count, values.size()));
        return values;
    }
    [[noreturn]] void fail(Column column, std::string const& expected) const {
        throw InputError(fmt::format("{}:{}: column {} = {}, expected {}", path_.string(), line_, columns()[column],
                                     cells_[column].empty() ? "nothing" : shortened(cells_[column]), expected));
    }

  private:
    /// Takes a word off the front of `rest`, and the blanks behind it.
    static std::string_view take_word(std::string_view& rest) {
        std::string_view const word = rest.substr(0, rest.find_first_of(" \t"));
        rest.remove_prefix(word.size());
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
        return word;
    }

    std::filesystem::path const& path_;
    std::size_t line_;
    std::string_view const* cells_;
};

PoseEstimate read_estimate(Row const& row) {
    PoseEstimate estimate;
    estimate.image = {row.id(scene_id), row.id(im_id)};
    estimate.obj_id = row.id(obj_id);
    estimate.score = row.number(score);
    estimate.pose.rotation = matrix_of(row.numbers(rotation, 9));
    if (std::string const problem = rotation_problem(estimate.pose.rotation); !problem.empty())
        row.fail(rotation, problem);
    std::vector<double> const t = row.numbers(translation, 3);
    estimate.pose.translation = m_per_mm * Eigen::Vector3d(t[0], t[1], t[2]);
    estimate.time_s = row.number(time);
    return estimate;
}

std::string csv_row(PoseEstimate const& estimate) {
    auto const& r = estimate.pose.rotation;
    Eigen::Vector3d const t = estimate.pose.translation / m_per_mm;
    return fmt::format("{},{},{},{},{} {} {} {} {} {} {} {} {},{} {} {},{}\n", estimate.image.scene_id,
                       estimate.image.im_id, estimate.obj_id, estimate.score, r(0, 0), r(0, 1), r(0, 2), r(1, 0),
                       r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2), t.x(), t.y(), t.z(), estimate.time_s);
}

}  // namespace

std::vector<PoseEstimate> read_pose_results(std::filesystem::path const& path) {
    std::vector<PoseEstimate> estimates;
    io::read_csv_cells(path, columns(), [&](std::size_t line, std::string_view const* cells) {
        estimates.push_back(read_estimate(Row(path, line, cells)));
        estimates.back().line = line;
    });
    return estimates;
}

std::string pose_results_csv(std::vector<PoseEstimate> const& estimates) {
    std::string text = fmt::format("{}\n", fmt::join(columns(), ","));
    for (PoseEstimate const& estimate : estimates)
        text += csv_row(estimate);
    return text;
}

}  // namespace faster::bop
