#include "dataflow/tools/budgets/replace_baseline.hpp"

#include <catch2/catch.hpp>

#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"

namespace replace_baseline_test {

using namespace dataflow::budgets;
using Catch::Matchers::Contains;
using faster::test::input_error_text;

Baseline new_baseline() {
    Baseline baseline{"2026-05-06", "deeper FIFO # not a comment", "fnv1a64:0000000000000002", {}, {}};
    baseline.figures.set("total_cycles", 99);
    baseline.figures.set("fifos.vertex.depth", 4);
    baseline.figures.set("fifos.vertex.writes", 8);
    return baseline;
}

std::string const new_lines =
    "  date: 2026-05-06\n  reason: \"deeper FIFO # not a comment\"\n  configuration: fnv1a64:0000000000000002\n  "
    "accelerator: {}\n"
    "  figures:\n    total_cycles: 99\n    fifos.vertex: {depth: 4, writes: 8}\n";

std::string const old_lines =
    "  date: 2026-01-01\n  reason: \"old # reason\"\n  configuration: fnv1a64:1\n  figures:\n"
    "    total_cycles: 5\n    fifos.vertex: {depth: 2}\n";

std::string replaced(std::string const& text) { return replace_baseline(text, new_baseline(), "b.yaml"); }

TEST_CASE("A new baseline replaces the old one, and every other letter stays") {
    std::string const before =
        "# head\nformat: faster-budget   # beside\n\nlimits:\n    # why\n    total_cycles: {max:   7}\n";
    std::string const after = "\n# about what follows\nset: {a: 1}  # tail\n# end\n";
    CHECK(replaced(before + "baseline:\n" + old_lines + after) == before + "baseline:\n" + new_lines + after);
    CHECK(replaced(before + "baseline:\n" + old_lines) == before + "baseline:\n" + new_lines);
}

TEST_CASE("A file without a baseline gets one at its end") {
    CHECK(replaced("a: 1  # x\n") == "a: 1  # x\n\nbaseline:\n" + new_lines);
    CHECK(replaced("a: 1") == "a: 1\n\nbaseline:\n" + new_lines);
}

TEST_CASE("Comments inside the baseline stay where they were") {
    std::string const old =
        "a: 1\nbaseline:  # ours\n  # when\n  date: 2026-01-01\n  reason: \"old # reason\"  # by M.\n"
        "  configuration: fnv1a64:1\n  figures:\n    # the total\n    total_cycles: 5  # 25 ns\n"
        "    # gone with its FIFO\n    fifos.area: {depth: 2}  # too\n    # last\n";
    std::string const expected =
        "a: 1\nbaseline:  # ours\n  # when\n  date: 2026-05-06\n  reason: \"deeper FIFO # not a comment\"  # by M.\n"
        "  configuration: fnv1a64:0000000000000002\n  accelerator: {}\n  figures:\n    # the total\n    total_cycles: "
        "99  # 25 ns\n"
        "    fifos.vertex: {depth: 4, writes: 8}\n    # gone with its FIFO\n  # too\n    # last\n";
    CHECK(replaced(old) == expected);
    CHECK(replaced(replaced(old)).find("# when") != std::string::npos);
}

TEST_CASE("Line ends stay as they are") {
    std::string const text = replaced("a: 1\r\nbaseline: {}\r\nb: 2\r\n");
    CHECK(text.find("a: 1\r\nbaseline:\r\n  date: 2026-05-06\r\n") == 0);
    CHECK(text.find("writes: 8}\r\nb: 2\r\n") != std::string::npos);
    CHECK(replaced("a: 1\nc: 3\r\nbaseline:\n" + old_lines + "b: 2\n") ==
          "a: 1\nc: 3\r\nbaseline:\n" + new_lines + "b: 2\n");
    CHECK(replaced("a: 1\r\nb: 2").find("a: 1\r\nb: 2\r\n\r\nbaseline:\r\n") == 0);
}

TEST_CASE("What cannot be replaced alone is refused") {
    CHECK_THAT(input_error_text([] { replaced("{a: 1, baseline: {date: x}}\n"); }),
               Contains("b.yaml:1: the baseline cannot be replaced without touching something else"));
    CHECK_THAT(input_error_text([] { replaced("a: 1\n...\n"); }), Contains("cannot be replaced"));
}

}  // namespace replace_baseline_test
