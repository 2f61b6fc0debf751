#include "dataflow/tools/sweeps/journal_rows.hpp"

#include <fmt/format.h>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/fnv1a.hpp"

namespace dataflow::sweeps {

namespace {

constexpr std::size_t checksum_letters = 16;

bool is_whole(std::string_view row) {
    return row.size() > checksum_letters && row[checksum_letters] == ' ' &&
           row.substr(0, checksum_letters) == fnv1a_digits(row.substr(checksum_letters + 1));
}

/// A row without its line end. One of another version has a right checksum, and is of no use either.
bool read_row(std::string_view row, std::function<void(Json const&)> const& take) {
    try {
        if (!is_whole(row))
            return false;
        take(io::parse_json(row.substr(checksum_letters + 1)));
        return true;
    } catch (Json::exception const&) {
        return false;
    }
}

}  // namespace

bool may_be_journal(std::string_view text) {
    constexpr std::string_view hexadecimal = "0123456789abcdef";
    std::string_view const start = text.substr(0, checksum_letters);
    if (start.find_first_not_of(hexadecimal) != std::string_view::npos)
        return false;
    return text.size() <= checksum_letters || text[checksum_letters] == ' ';
}

std::string journal_row(Json const& json) {
    std::string const text = io::text_of(json);
    return fnv1a_digits(text) + " " + text + "\n";
}

std::size_t read_journal_rows(std::string_view text, std::function<void(Json const&)> const& take) {
    std::size_t damaged = 0;
    while (!text.empty()) {
        std::size_t const end = text.find('\n');
        if (end == std::string_view::npos || !read_row(text.substr(0, end), take))
            ++damaged;
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return damaged;
}

}  // namespace dataflow::sweeps
