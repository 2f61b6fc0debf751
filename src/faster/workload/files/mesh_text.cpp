#include "faster/workload/files/mesh_text.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <utility>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/text_lines.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::files {
namespace {

constexpr std::string_view blanks = " \t\v\f";
constexpr std::string_view line_ends = "\r\n";
constexpr std::string_view word_ends = " \t\v\f\r\n#";

std::string_view without_plus(std::string_view word) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-')
        word.remove_prefix(1);
    return word;
}

}  // namespace

std::optional<double> number_in(std::string_view word) {
    word = without_plus(word);
    char const* const end = word.data() + word.size();
    double value = 0;
    auto const result = std::from_chars(word.data(), end, value);
    if (result.ptr != end || result.ec == std::errc::invalid_argument)
        return std::nullopt;
    if (result.ec == std::errc::result_out_of_range)
        return std::strtod(std::string(word).c_str(), nullptr);
    return value;
}

std::optional<std::int64_t> integer_in(std::string_view word) {
    word = without_plus(word);
    char const* const end = word.data() + word.size();
    std::int64_t value = 0;
    auto const result = std::from_chars(word.data(), end, value);
    if (result.ptr == end && result.ec == std::errc{})
        return value;
    constexpr double exact = 9e15;  // whole numbers below it are doubles
    auto const number = number_in(word);
    if (!number || !(std::abs(*number) < exact) || std::trunc(*number) != *number)
        return std::nullopt;
    return static_cast<std::int64_t>(*number);
}

MeshText::MeshText(std::filesystem::path path, std::string_view text, std::size_t first_line)
    : path_(std::move(path)), rest_(first_line == 1 ? without_byte_order_mark(text) : text), line_(first_line) {}

void MeshText::skip_line_end() {
    bool const has_two = rest_.substr(0, 2) == line_ends;
    rest_.remove_prefix(has_two ? 2 : 1);
    ++line_;
}

bool MeshText::next_line() {
    if (!std::exchange(is_before_first_, false)) {
        rest_.remove_prefix(std::min(rest_.find_first_of(line_ends), rest_.size()));
        if (!rest_.empty())
            skip_line_end();
    }
    return !rest_.empty();
}

bool MeshText::next_line_of_words() {
    while (next_line()) {
        skip_blanks();
        if (!rest_.empty() && word_ends.find(rest_.front()) == std::string_view::npos)
            return true;
    }
    return false;
}

bool MeshText::takes_continuation() {
    if (!joins_lines_ || rest_.empty() || rest_[0] != '\\' ||
        (rest_.size() > 1 && line_ends.find(rest_[1]) == std::string_view::npos))
        return false;
    rest_.remove_prefix(1);
    if (!rest_.empty())
        skip_line_end();
    return true;
}

void MeshText::skip_blanks() {
    do
        rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
    while (takes_continuation());
}

std::string_view MeshText::word() {
    skip_blanks();
    std::size_t length = std::min(rest_.find_first_of(word_ends), rest_.size());
    bool const is_continued = joins_lines_ && length > 0 && rest_[length - 1] == '\\' &&
                              (length == rest_.size() || line_ends.find(rest_[length]) != std::string_view::npos);
    length -= is_continued ? 1U : 0U;
    std::string_view const found = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return found;
}

std::string_view MeshText::word_of_row() {
    for (;;) {
        if (std::string_view const found = word(); !found.empty())
            return found;
        if (!next_line())
            fail_at_end();
    }
}

Eigen::Vector3d MeshText::coordinates(std::size_t vertex, std::string_view (MeshText::*next)()) {
    Eigen::Vector3d place;
    for (double& coordinate : place) {
        std::string_view const given = (this->*next)();
        auto const number = number_in(given);
        if (!number)
            fail(fmt::format("vertex {} (counted from 0) has {} as a coordinate, expected three numbers", vertex,
                             given.empty() ? "nothing" : shortened(given)));
        coordinate = *number;
    }
    return place;
}

std::string MeshText::place() const { return fmt::format("{}:{}", path_.string(), line_); }

void MeshText::fail(std::string const& what) const { throw InputError(place() + ": " + what); }

void MeshText::fail_at_end() const { fail("the file ends early, expected more values"); }

}  // namespace faster::files
