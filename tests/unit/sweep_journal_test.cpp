#include <catch2/catch.hpp>

#include "dataflow/tools/sweeps/journal.hpp"
#include "dataflow/tools/sweeps/point_result.hpp"
#include "faster/dataflow_names.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace sweep_journal_test {

using namespace faster;
using namespace faster::test;
using sweeps::PointResult;
using Journal = sweeps::Journal<PointResult>;

PointResult result(Cycles cycles) {
    PointResult made;
    made.status = PointResult::Status::done;
    made.total_cycles = cycles;
    made.milliseconds = 0.1 * static_cast<double>(cycles);
    made.ramb36 = 1.5;
    return made;
}

/// Three rows.
std::filesystem::path written_journal(TempFolder const& folder) {
    Journal journal(folder / "journal");
    journal.append({{"a", result(1)}});
    journal.append({{"b", result(2)}, {"c", sweeps::failed("x, \"y\"\nz")}});
    return folder / "journal";
}

TEST_CASE("A journal keeps results", "[sweeps]") {
    TempFolder const folder;
    auto const content = sweeps::read_journal<PointResult>(written_journal(folder));
    CHECK(content.damaged == 0);
    REQUIRE(content.results.size() == 3);
    CHECK(content.results.at("b") == result(2));
    CHECK(content.results.at("c").message == "x, \"y\" z");
}

TEST_CASE("A journal that was cut off anywhere loses its last rows, and only those", "[sweeps]") {
    TempFolder const folder;
    std::string const whole = content_of(written_journal(folder));
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < whole.size(); ++i)
        if (whole[i] == '\n')
            ends.push_back(i + 1);
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        folder.write("journal", whole.substr(0, length));
        auto const rows = static_cast<std::size_t>(
            std::count_if(ends.begin(), ends.end(), [length](std::size_t end) { return end <= length; }));
        Journal journal(folder / "journal");
        REQUIRE(journal.results().size() == rows);
        REQUIRE(content_of(folder / "journal") == whole.substr(0, rows == 0 ? 0 : ends[rows - 1]));
    }
}

TEST_CASE("A damaged row of a journal is dropped, and can be written again", "[sweeps]") {
    TempFolder const folder;
    std::string damaged = content_of(written_journal(folder));
    damaged[damaged.find("\"total_cycles\":2") + 15] = '3';
    folder.write("journal", damaged);
    CHECK(sweeps::read_journal<PointResult>(folder / "journal").damaged == 1);
    Journal journal(folder / "journal");
    CHECK(journal.results().size() == 2);
    CHECK(journal.results().count("b") == 0);
    journal.append({{"b", result(2)}});
    auto const content = sweeps::read_journal<PointResult>(folder / "journal");
    CHECK(content.damaged == 0);
    CHECK(content.results.size() == 3);
    CHECK(lines_of(content_of(folder / "journal")).size() == 3);
}

TEST_CASE("Unwanted results are taken out of a journal", "[sweeps]") {
    TempFolder const folder;
    Journal const journal(written_journal(folder),
                          [](PointResult const& each) { return each.status == PointResult::Status::failed; });
    CHECK(journal.results().size() == 2);
    CHECK(sweeps::read_journal<PointResult>(folder / "journal").results.count("c") == 0);
}

}  // namespace sweep_journal_test
