#include "faster/workload/files/table_row.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_text.hpp"
#include "faster/workload/files/pose_numbers.hpp"

namespace faster::files {
namespace {

std::optional<double> finite_number_in(std::string_view text) {
    auto const number = number_in(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

/// Takes a word off the front of `rest`, and the blanks behind it.
std::string_view take_word(std::string_view& rest) {
    std::string_view const word = rest.substr(0, rest.find_first_of(" \t"));
    rest.remove_prefix(word.size());
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    return word;
}

}  // namespace

std::vector<std::string> const& columns_of_results() {
    static std::vector<std::string> const names{"scene_id", "im_id", "obj_id", "score", "R", "t", "time"};
    return names;
}

int TableRow::id(std::size_t column) const {
    auto const value = integer_in(cells_[column]);
    if (!value || *value < 0 || *value > std::numeric_limits<int>::max())
        fail(column, "an integer from 0");
    return static_cast<int>(*value);
}

double TableRow::number(std::size_t column) const {
    auto const value = finite_number_in(cells_[column]);
    if (!value)
        fail(column, "a finite number");
    return *value;
}

std::vector<double> TableRow::numbers(std::size_t column, std::size_t count) const {
    std::vector<double> values;
    for (std::string_view rest = cells_[column]; !rest.empty();) {
        auto const value = finite_number_in(take_word(rest));
        if (!value)
            fail(column, fmt::format("{} finite numbers parted by blanks", count));
        values.push_back(*value);
    }
    if (values.size() != count)
        fail(column, fmt::format("{} numbers parted by blanks, not {}", count, values.size()));
    return values;
}

Eigen::Matrix3d TableRow::rotation(std::size_t column) const {
    Eigen::Matrix3d matrix = matrix_of(numbers(column, 9));
    if (std::string const problem = rotation_problem(matrix); !problem.empty())
        fail(column, problem);
    return matrix;
}

Eigen::Vector3d TableRow::vector(std::size_t column) const {
    std::vector<double> const t = numbers(column, 3);
    return {t[0], t[1], t[2]};
}

std::string TableRow::complaint(std::size_t column, std::string const& expected) const {
    return fmt::format("{}:{}: column {} = {}, expected {}", path_.string(), line_, columns_[column],
                       cells_[column].empty() ? "nothing" : shortened(cells_[column]), expected);
}

void TableRow::fail(std::size_t column, std::string const& expected) const {
    throw InputError(complaint(column, expected));
}

}  // namespace faster::files
