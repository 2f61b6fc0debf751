#include "kernel/base/files/atomic_folder.hpp"

#include <catch2/catch.hpp>

#include "kernel/base/files/text_file.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace atomic_folder_test {

using namespace faster::io;
using faster::test::content_of;
using faster::test::entries_in;
using faster::test::input_error_text;
using faster::test::TempFolder;
namespace fs = std::filesystem;

FolderKind const kind{"result", "summary.json", {"samples.csv", "images"}};

void write_result(fs::path const& target, std::string const& content) {
    AtomicFolder output(target, kind);
    write_file(output.path() / "summary.json", content);
    output.commit();
}

TEST_CASE("A committed folder appears with its files and without leftovers", "[atomic_folder]") {
    TempFolder const folder;
    write_result(folder / "out", "new");
    CHECK(content_of(folder / "out" / "summary.json") == "new");
    CHECK(entries_in(folder.path()) == 1);
}

TEST_CASE("A folder that is not committed leaves nothing, not even the parents it made", "[atomic_folder]") {
    TempFolder const folder;
    {
        AtomicFolder output(folder / "a" / "b" / "out", kind);
        write_file(output.path() / "summary.json", "half");
        CHECK_FALSE(fs::exists(output.target()));
    }
    CHECK(entries_in(folder.path()) == 0);
}

TEST_CASE("A folder takes no place before anything is written", "[atomic_folder]") {
    TempFolder const folder;
    AtomicFolder output(folder / "a" / "out", kind);
    CHECK(entries_in(folder.path()) == 0);
    write_file(output.path() / "summary.json", "new");
    CHECK(entries_in(folder.path()) == 1);
    output.commit();
    CHECK(content_of(folder / "a" / "out" / "summary.json") == "new");
}

TEST_CASE("A folder into which nothing was written appears all the same", "[atomic_folder]") {
    TempFolder const folder;
    AtomicFolder(folder / "out", kind).commit();
    CHECK(fs::is_directory(folder / "out"));
    CHECK(entries_in(folder.path()) == 1);
}

TEST_CASE("Missing parents are made, a trailing slash does not matter", "[atomic_folder]") {
    TempFolder const folder;
    write_result((folder / "a" / "out").string() + "/", "new");
    CHECK(content_of(folder / "a" / "out" / "summary.json") == "new");
}

TEST_CASE("An empty folder is filled", "[atomic_folder]") {
    TempFolder const folder;
    fs::create_directory(folder / "out");
    write_result(folder / "out", "new");
    CHECK(content_of(folder / "out" / "summary.json") == "new");
}

TEST_CASE("An older folder of the kind is replaced, but foreign files in it survive", "[atomic_folder]") {
    TempFolder const folder;
    write_result(folder / "out", "old");
    folder.write("out/samples.csv", "stale");
    folder.write("out/wave.vcd", "mine");
    write_result(folder / "out", "new");
    CHECK(content_of(folder / "out" / "summary.json") == "new");
    CHECK_FALSE(fs::exists(folder / "out" / "samples.csv"));
    CHECK(content_of(folder / "out" / "wave.vcd") == "mine");
    CHECK(entries_in(folder.path()) == 1);
}

TEST_CASE("An older folder stays as it was if the new one is not committed", "[atomic_folder]") {
    TempFolder const folder;
    write_result(folder / "out", "old");
    { AtomicFolder const output(folder / "out", kind); }
    CHECK(content_of(folder / "out" / "summary.json") == "old");
}

TEST_CASE("A folder with other content is refused and left alone", "[atomic_folder]") {
    TempFolder const folder;
    fs::create_directory(folder / "out");
    folder.write("out/thesis.tex", "mine");
    CHECK(input_error_text([&] { AtomicFolder(folder / "out", kind); }) ==
          (folder / "out").string() + ": holds other files, expected a new or empty folder or an older result");
    CHECK(entries_in(folder / "out") == 1);
}

TEST_CASE("A place where no folder can be made is an input error", "[atomic_folder]") {
    TempFolder const folder;
    folder.write("file", "");
    CHECK_THAT(input_error_text([&] { AtomicFolder(folder / "file", kind); }),
               Catch::Contains("file: is a file, expected a folder"));
    CHECK_THAT(input_error_text([&] { AtomicFolder(folder / "file" / "out", kind); }),
               Catch::Contains("out: cannot be written ("));
    CHECK_THAT(input_error_text([] { AtomicFolder("/proc/none/out", kind); }),
               Catch::Contains("/proc/none/out: cannot be written ("));
    CHECK_THAT(input_error_text([] { AtomicFolder("", kind); }), Catch::Contains("is empty"));
}

}  // namespace atomic_folder_test
