#include "dataflow/base/printable.hpp"

#include <catch2/catch.hpp>
#include <chrono>
#include <string>

#include "dataflow/base/csv_cell.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/utf8.hpp"
#include "faster/dataflow_names.hpp"

namespace printable_test {

using faster::csv_cell;
using faster::first_bad_byte;
using faster::InputError;
using faster::message_line;
using faster::printable;
using faster::printable_lines;
using faster::shortened;

TEST_CASE("Printable text stays as it is") {
    for (std::string const text : {"", "a b", "\xC3\xA9t\xC3\xA9", "\xE2\x82\xAC 5", "\xF0\x9F\x8D\x8C", "C:\\n"})
        CHECK(printable(text) == text);
}

TEST_CASE("What moves the cursor or the order of reading is escaped, and so is what is no UTF-8") {
    CHECK(printable("a\x1B[2Jb") == "a\\x1b[2Jb");
    CHECK(printable(std::string("\0\t\r\n\x7F", 5)) == "\\x00\\t\\r\\n\\x7f");
    CHECK(printable("\xC2\x9B"
                    "31m") == "\\u009b31m");
    CHECK(printable("\xE2\x80\xAE"
                    "gpj.exe") == "\\u202egpj.exe");
    CHECK(printable("\xE2\x81\xA6\xE2\x80\xA8\xD8\x9C") == "\\u2066\\u2028\\u061c");
    CHECK(printable("\xF3\xA0\x80\x81") == "\\U000e0001");
    CHECK(printable("\xFF\xC3") == "\\xff\\xc3");
    CHECK(printable("\xC0\xAF") == "\\xc0\\xaf");           // overlong
    CHECK(printable("\xED\xA0\x80") == "\\xed\\xa0\\x80");  // a surrogate
    CHECK(printable("\xF4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");
}

TEST_CASE("Text of several lines keeps its line ends and tabs, and nothing else") {
    CHECK(printable_lines("a\tb\n\x1B\r\n") == "a\tb\n\\x1b\\r\n");
}

TEST_CASE("A value for a message is cut between characters") {
    CHECK(shortened(std::string(80, 'x')) == std::string(80, 'x'));
    CHECK(shortened(std::string(81, 'x')) == std::string(80, 'x') + "...");
    CHECK(shortened(std::string(79, 'x') + "\xC3\xA9") == std::string(79, 'x') + "...");
    CHECK(shortened(std::string(1'000'000, '\x1B')).size() < 400);
}

TEST_CASE("A message keeps its begin and its end, however much stands between them") {
    std::string const cell(1'000'000, 'x');
    for (std::string const& between : {cell, std::string("a ") + std::string(500'000, ' ') + cell}) {
        std::string const line = message_line("t.csv:2: column a = " + between + ", expected an integer\n");
        CHECK(line.size() < 2100);
        CHECK(line.rfind("t.csv:2: column a = ", 0) == 0);
        CHECK(line.substr(line.size() - 21) == ", expected an integer");
        CHECK(line.find("...") != std::string::npos);
    }
}

TEST_CASE("No InputError carries what could hurt a terminal") {
    CHECK(std::string(InputError("a\nb\x1B: no such file").what()) == "a\\nb\\x1b: no such file");
    CHECK(std::string(InputError("a.yaml:1: fine").what()) == "a.yaml:1: fine");
}

TEST_CASE("Text of a configuration has no hidden directions in it") {
    CHECK(!first_bad_byte("a: \xC3\xA9 # \xD7\xA9\n\t"));
    CHECK(first_bad_byte("a: \xE2\x80\xAE") == 3U);
    CHECK(first_bad_byte("ab\xC2\x85") == 2U);
}

TEST_CASE("A megabyte of a name is like nothing, and that is found out at once") {
    std::string const name(1'000'000, 'w');
    auto const start = std::chrono::steady_clock::now();
    CHECK(faster::nearest_name(name, std::vector<std::string>(1000, "window")).empty());
    CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(1));
}

TEST_CASE("Blanks that are none and letters without a picture are escaped") {
    CHECK(printable("a\xC2\xA0"
                    "b\xE2\x80\x8B"
                    "c\xEF\xBB\xBF") == "a\\u00a0b\\u200bc\\ufeff");
    CHECK_FALSE(
        first_bad_byte("a\xC2\xA0"
                       "b"));  // a file may have them
}

TEST_CASE("A cell of a table is no formula to a spreadsheet") {
    CHECK(csv_cell("=cmd|' /C calc'!A0") == "'=cmd|' /C calc'!A0");
    CHECK(csv_cell("=HYPERLINK(\"x\",1)") == "\"'=HYPERLINK(\"\"x\"\",1)\"");
    CHECK(csv_cell("@sum(1)") == "'@sum(1)");
    CHECK(csv_cell("+cmd") == "'+cmd");
    CHECK(csv_cell("-2+cmd") == "'-2+cmd");
    for (std::string const plain : {"", "-5", "+1e-3", "-0.25", "a=b", "5", "cmd", "-inf"})
        CHECK(csv_cell(plain) == plain);
}

}  // namespace printable_test
