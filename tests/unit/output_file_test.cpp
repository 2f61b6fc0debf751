#include "dataflow/base/files/output_file.hpp"

#include <catch2/catch.hpp>

#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace output_file_test {

using namespace dataflow::io;
using faster::test::content_of;
using faster::test::entries_in;
using faster::test::input_error_text;
using faster::test::TempFolder;
namespace fs = std::filesystem;

TEST_CASE("A committed file appears with its content and without leftovers", "[output_file]") {
    TempFolder const folder;
    OutputFile(folder / "report.html").commit("new");
    CHECK(content_of(folder / "report.html") == "new");
    CHECK(entries_in(folder.path()) == 1);
}

TEST_CASE("A file that is not committed leaves nothing", "[output_file]") {
    TempFolder const folder;
    { OutputFile const file(folder / "a" / "b" / "report.html"); }
    CHECK(entries_in(folder.path()) == 0);
}

TEST_CASE("An older file is replaced on commit and not before", "[output_file]") {
    TempFolder const folder;
    folder.write("report.html", "old");
    OutputFile const file(folder / "report.html");
    CHECK(content_of(folder / "report.html") == "old");
    file.commit("new");
    CHECK(content_of(folder / "report.html") == "new");
    CHECK(entries_in(folder.path()) == 1);
}

TEST_CASE("Missing parents of a file are made", "[output_file]") {
    TempFolder const folder;
    OutputFile(folder / "a" / "b" / "report.html").commit("new");
    CHECK(content_of(folder / "a" / "b" / "report.html") == "new");
}

TEST_CASE("The file behind a link is replaced, not the link", "[output_file]") {
    TempFolder const folder;
    folder.write("real.html", "old");
    fs::create_symlink("real.html", folder / "link.html");
    OutputFile(folder / "link.html").commit("new");
    CHECK(fs::is_symlink(folder / "link.html"));
    CHECK(content_of(folder / "real.html") == "new");
}

TEST_CASE("A place where no file can be written is an input error", "[output_file]") {
    TempFolder const folder;
    folder.write("file", "");
    CHECK_THAT(input_error_text([&] { OutputFile(folder.path()); }), Catch::Contains("is a folder, expected a file"));
    CHECK_THAT(input_error_text([&] { OutputFile(folder / "file" / "report.html"); }),
               Catch::Contains("file/report.html: cannot be written ("));
    CHECK_THAT(input_error_text([] { OutputFile("/proc/none/report.html"); }),
               Catch::Contains("/proc/none/report.html: cannot be written"));
    CHECK_THAT(input_error_text([] { OutputFile("/dev/null"); }), Catch::Contains("/dev/null: is no regular file"));
    CHECK_THAT(input_error_text([] { OutputFile(""); }), Catch::Contains("names no file"));
}

TEST_CASE("What is too long to be held is written bit by bit, and what stops it leaves nothing", "[output_file]") {
    TempFolder const folder;
    folder.write("long", "old");
    OutputFile const file(folder / "long");
    CHECK_THROWS_AS(file.commit([](std::ostream& stream) {
        stream << std::string(100'000, 'x');
        throw std::runtime_error("no more");
    }),
                    std::runtime_error);
    CHECK(content_of(folder / "long") == "old");
    file.commit([](std::ostream& stream) { stream << "new" << std::string(100'000, 'x'); });
    CHECK(content_of(folder / "long").size() == 100'003);
    CHECK(entries_in(folder.path()) == 1);
}

}  // namespace output_file_test
