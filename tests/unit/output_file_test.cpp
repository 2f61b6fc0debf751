#include "dataflow/base/files/output_file.hpp"

#include <catch2/catch.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include "dataflow/base/files/atomic_folder.hpp"
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

/// Its link leads to no path.
TEST_CASE("A pipe that is a link of /proc is no regular file, and no folder", "[output_file]") {
    int ends[2];
    REQUIRE(::pipe(ends) == 0);
    std::string const pipe = "/proc/self/fd/" + std::to_string(ends[1]);
    CHECK_THAT(input_error_text([&] { OutputFile{pipe}; }), Catch::Contains(pipe + ": is no regular file"));
    CHECK_THAT(input_error_text([&] { AtomicFolder(pipe, {}); }), Catch::Contains(pipe + ": is a file, expected a"));
    ::close(ends[0]);
    ::close(ends[1]);
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

TEST_CASE("A file that is replaced keeps its rights, and a new one has what the umask leaves", "[output_file]") {
    TempFolder const folder;
    for (auto const rights : {fs::perms(0660), fs::perms(0664), fs::perms(0600), fs::perms(0444), fs::perms(0755)}) {
        folder.write("report.html", "old");
        fs::permissions(folder / "report.html", rights);
        OutputFile(folder / "report.html").commit("new");
        CHECK(content_of(folder / "report.html") == "new");
        CHECK(fs::status(folder / "report.html").permissions() == rights);
        fs::remove(folder / "report.html");
    }
    OutputFile(folder / "new.html").commit("new");
    folder.write("usual.html", "");
    CHECK(fs::status(folder / "new.html").permissions() == fs::status(folder / "usual.html").permissions());
}

TEST_CASE("What is written for a private file is private meanwhile", "[output_file]") {
    TempFolder const folder;
    folder.write("report.html", "old");
    fs::permissions(folder / "report.html", fs::perms(0640));
    OutputFile(folder / "report.html").commit([&](std::ostream& stream) {
        stream << "new";
        for (auto const& entry : fs::directory_iterator(folder.path()))
            CHECK(entry.status().permissions() == fs::perms(0640));
        CHECK(entries_in(folder.path()) == 2);
    });
}

TEST_CASE("A file that is replaced keeps owner and group, where we may give it away", "[output_file]") {
    constexpr unsigned somebody = 12345;
    TempFolder const folder;
    folder.write("report.html", "old");
    if (chown((folder / "report.html").c_str(), somebody, somebody) != 0) {
        WARN("skipped: only root gives files away");
        return;
    }
    fs::permissions(folder / "report.html", fs::perms(0640));
    OutputFile(folder / "report.html").commit("new");
    struct stat is {};
    REQUIRE(stat((folder / "report.html").c_str(), &is) == 0);
    CHECK(is.st_uid == somebody);
    CHECK(is.st_gid == somebody);
    CHECK((is.st_mode & 07777U) == 0640);
}

}  // namespace output_file_test
