#pragma once
#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"

namespace faster::test {

/// The tool did what it was asked, and had nothing to complain of.
inline void require_done(CommandResult const& result) {
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    REQUIRE(result.err.empty());
}

/// The tool did what it was asked, and warned of something at most.
inline void require_done_with_warnings(CommandResult const& result) {
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    std::istringstream stream(result.err);
    for (std::string line; std::getline(stream, line);)
        REQUIRE(line.rfind("faster-sim: warning: ", 0) == 0);
}

/// Exit code 2, one line on stderr that contains `parts`, nothing on stdout.
inline void check_bad_input(CommandResult const& result, std::vector<std::string> const& parts) {
    CAPTURE(result.err);
    CHECK(result.exit_code == 2);
    CHECK(result.out.empty());
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
    CHECK(result.err.find('\n') + 1 == result.err.size());
    CHECK(result.err.rfind("faster-sim: ", 0) == 0);
    for (std::string const& part : parts)
        CHECK_THAT(result.err, Catch::Matchers::Contains(part));
}

inline std::vector<std::string> lines_of(std::string const& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

/// Of a line of CSV without commas in its cells.
inline std::vector<std::string> cells_of(std::string const& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line + ",");
    for (std::string cell; std::getline(stream, cell, ',');)
        cells.push_back(cell);
    return cells;
}

}  // namespace faster::test
