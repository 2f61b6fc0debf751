#include "dataflow/base/files/atomic_folder.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <csignal>
#include <functional>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace atomic_folder_test {

using namespace dataflow::io;
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

/// Of another process, which does `work`: how it ended, as waitpid() says.
int status_of_process(std::function<void()> const& work) {
    pid_t const process = fork();
    if (process == 0) {
        for (int const signal : {SIGTERM, SIGINT})
            std::signal(signal, SIG_DFL);  // not the test framework's report
        work();
        _exit(0);
    }
    int status = 0;
    waitpid(process, &status, 0);
    return status;
}

bool is_ended_by(int signal, int status) { return WIFSIGNALED(status) && WTERMSIG(status) == signal; }

/// Writes half of a result and is killed.
void leave_half(fs::path const& target) {
    int const status = status_of_process([&] {
        AtomicFolder output(target, kind);
        fs::create_directory(output.path() / "images");
        write_file(output.path() / "images" / "a.png", "half");
        raise(SIGKILL);
    });
    REQUIRE(is_ended_by(SIGKILL, status));
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

TEST_CASE("The current folder and those above it are refused, for they would be gone", "[atomic_folder]") {
    TempFolder const folder;
    fs::create_directories(folder / "a" / "b");
    int const status = status_of_process([&] {
        fs::current_path(folder / "a" / "b");
        for (std::string const name : {".", "..", "../../a", "./"}) {
            std::string const text = input_error_text([&] { AtomicFolder(name, kind); });
            if (text.find(name + ": is the current folder or one above it") != 0)
                _exit(1);
        }
        write_result("../bc", "new");
    });
    CHECK(status == 0);
    CHECK(entries_in(folder / "a" / "b") == 0);
    CHECK(entries_in(folder / "a") == 2);
}

TEST_CASE("Foreign files stay the same files, with their links and folders", "[atomic_folder]") {
    TempFolder const folder;
    write_result(folder / "out", "old");
    fs::create_directories(folder / "out" / "mine" / "deep");
    folder.write("out/mine/deep/notes.txt", "mine");
    fs::create_symlink("nowhere", folder / "out" / "link");
    fs::create_hard_link(folder / "out" / "mine" / "deep" / "notes.txt", folder / "outside");
    write_result(folder / "out", "new");
    CHECK(fs::equivalent(folder / "outside", folder / "out" / "mine" / "deep" / "notes.txt"));
    CHECK(fs::read_symlink(folder / "out" / "link") == "nowhere");
    CHECK(content_of(folder / "out" / "summary.json") == "new");
    CHECK(entries_in(folder.path()) == 2);
}

TEST_CASE("What was left by a process that was killed is removed, what is of a living one is not", "[atomic_folder]") {
    TempFolder const folder;
    leave_half(folder / "out");
    folder.write(".out.partial-12", "left of a file");
    folder.write(".out.partial-x", "not of ours");
    folder.write(".out2.partial-12", "of another");
    CHECK(entries_in(folder.path()) == 4);
    AtomicFolder living(folder / "out", kind);
    write_file(living.path() / "summary.json", "living");
    CHECK(entries_in(folder.path()) == 3);
    CHECK(status_of_process([&] { write_result(folder / "out", "quicker"); }) == 0);
    CHECK(content_of(folder / "out" / "summary.json") == "quicker");
    living.commit();
    CHECK(content_of(folder / "out" / "summary.json") == "living");
    CHECK(entries_in(folder.path()) == 3);
}

TEST_CASE("What was left of a file by a process that was killed is removed", "[output_file]") {
    TempFolder const folder;
    int const status = status_of_process([&] {
        OutputFile(folder / "page.html").commit([](std::ostream& stream) {
            stream << "half" << std::flush;
            raise(SIGKILL);
        });
    });
    CHECK(is_ended_by(SIGKILL, status));
    CHECK(entries_in(folder.path()) == 1);
    OutputFile(folder / "page.html").commit("whole");
    CHECK(content_of(folder / "page.html") == "whole");
    CHECK(entries_in(folder.path()) == 1);
}

TEST_CASE("A process that is told to end takes away what is half-written", "[atomic_folder]") {
    for (int const signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) {
        TempFolder const folder;
        write_result(folder / "out", "old");
        int const of_folder = status_of_process([&] {
            AtomicFolder output(folder / "out", kind);
            write_file(output.path() / "summary.json", "half");
            raise(signal);
            write_file(output.path() / "samples.csv", "half");
            output.commit();
        });
        int const of_file = status_of_process([&] {
            OutputFile(folder / "a" / "page.html").commit([&](std::ostream& stream) {
                stream << "half" << std::flush;
                raise(signal);
                stream << "more" << std::flush;
            });
        });
        CAPTURE(signal, of_folder, of_file);
        CHECK(is_ended_by(signal, of_folder));
        CHECK(is_ended_by(signal, of_file));
        CHECK(content_of(folder / "out" / "summary.json") == "old");
        CHECK(entries_in(folder.path()) == 1);
    }
}

TEST_CASE("A folder that is replaced is there at any moment, and whole", "[atomic_folder]") {
    TempFolder const folder;
    write_result(folder / "out", "0");
    folder.write("out/notes.txt", "mine");
    std::atomic<bool> is_done{false};
    std::atomic<int> missing{0};
    std::thread reader([&] {
        while (!is_done)
            if (!fs::exists(folder / "out" / "summary.json") || !fs::exists(folder / "out" / "notes.txt"))
                ++missing;
    });
    for (int i = 0; i < 100; ++i)
        write_result(folder / "out", std::to_string(i));
    is_done = true;
    reader.join();
    CHECK(missing == 0);
}

// What a process leaves that is killed between the two renames of a file system without exchange.
TEST_CASE("An older folder that lost its name gets it back, with what the user kept in it", "[atomic_folder]") {
    TempFolder const folder;
    write_result(folder / "out", "old");
    folder.write("out/notes.txt", "mine");
    folder.write("out/samples.csv", "old");
    fs::rename(folder / "out", folder / ".out.older-7");
    leave_half(folder / "out");
    { AtomicFolder const look(folder / "out", kind); }
    CHECK(content_of(folder / "out" / "summary.json") == "old");
    CHECK(content_of(folder / "out" / "notes.txt") == "mine");
    CHECK(entries_in(folder.path()) == 1);

    fs::rename(folder / "out", folder / ".out.older-7");
    fs::create_directory(folder / "out");
    folder.write("out/summary.json", "another");
    { AtomicFolder const look(folder / "out", kind); }
    CHECK(content_of(folder / "out" / "summary.json") == "another");
    CHECK(content_of(folder / "out" / "notes.txt") == "mine");
    CHECK_FALSE(fs::exists(folder / "out" / "samples.csv"));
    CHECK(entries_in(folder.path()) == 1);
}

/// A kind whose marker says what it is, and in whose images people may keep something.
FolderKind const marked{"result", "summary.json", {"samples.csv", "images/sample_*.png"}, "faster-test"};
constexpr char const* own_marker = R"({"format": "faster-test", "version": 1})";

void write_marked(fs::path const& target) {
    AtomicFolder output(target, marked);
    write_file(output.path() / "summary.json", own_marker);
    fs::create_directory(output.path() / "images");
    write_file(output.path() / "images" / "sample_0.png", "new");
    output.commit();
}

TEST_CASE("A folder whose marker is another's is refused, and all in it stays", "[atomic_folder]") {
    for (char const* const foreign : {"{}", "[]", "3", "", "{\"format\": 3}", "{\"format\": \"another\"}",
                                      "{\"run\": {\"format\": \"faster-test\"}}", "{\"format\": \"faster-test"}) {
        CAPTURE(foreign);
        TempFolder const folder;
        fs::create_directories(folder / "out" / "images");
        folder.write("out/summary.json", foreign);
        folder.write("out/samples.csv", "mine");
        folder.write("out/images/photo.jpg", "mine");
        CHECK(input_error_text([&] { write_marked(folder / "out"); }) ==
              (folder / "out").string() +
                  ": holds a summary.json of something else, expected a new or empty folder or an older result");
        CHECK(content_of(folder / "out" / "summary.json") == foreign);
        CHECK(content_of(folder / "out" / "samples.csv") == "mine");
        CHECK(content_of(folder / "out" / "images" / "photo.jpg") == "mine");
    }
}

TEST_CASE("A marker may be YAML, a table, or laid out in another way", "[atomic_folder]") {
    auto const is_kind = [](std::string const& marker, std::string const& format, std::string const& content) {
        TempFolder const folder;
        folder.write(marker, content);
        return FolderKind{"result", marker, {}, format}.is_kind_of(folder.path());
    };
    CHECK(is_kind("m.json", "faster-test", "{\n\"version\":1,\"format\"\n:\"faster-test\"}"));
    CHECK(is_kind("m.yaml", "faster-test", "# x\nversion: 1\nformat: 'faster-test'\n"));
    CHECK_FALSE(is_kind("m.yaml", "faster-test", "below: {format: faster-test}\n"));
    CHECK_FALSE(is_kind("m.yaml", "faster-test", "format: [\n"));
    CHECK(is_kind("m.csv", "a,b,", "a,b,c\n"));
    CHECK_FALSE(is_kind("m.csv", "a,b,", "b,a,c\n"));
    CHECK_FALSE(is_kind("m.csv", "a,b,", ""));
}

TEST_CASE("A page of ours goes with the results that it tells of, a page of somebody else stays", "[atomic_folder]") {
    FolderKind const with_page{"result", "summary.json", {"images"}, "", "report.html", {"format: ours"}};
    auto const is_page = [&](std::string const& name, std::string const& content) {
        TempFolder const folder;
        write_result(folder / "out", "old");
        folder.write("out/" + name, content);
        AtomicFolder output(folder / "out", with_page);
        write_file(output.path() / "summary.json", "new");
        output.commit();
        return !fs::exists(folder / "out" / name);
    };
    CHECK(is_page("report.html", "<p>format: ours</p>"));
    CHECK_FALSE(is_page("report.html", "<p>format: another</p>"));
    CHECK_FALSE(is_page("report.html", ""));
    CHECK_FALSE(is_page("mine.html", "<p>format: ours</p>"));
}

TEST_CASE("What people keep beside pictures of ours survives, and the pictures do not", "[atomic_folder]") {
    TempFolder const folder;
    write_marked(folder / "out");
    folder.write("out/images/sample_7.png", "old");
    folder.write("out/images/photo.jpg", "mine");
    fs::create_directories(folder / "out" / "images" / "sample_album" / "deep");
    folder.write("out/images/sample_album/deep/sample_1.png", "mine");
    write_marked(folder / "out");
    CHECK_FALSE(fs::exists(folder / "out" / "images" / "sample_7.png"));
    CHECK(content_of(folder / "out" / "images" / "sample_0.png") == "new");
    CHECK(content_of(folder / "out" / "images" / "photo.jpg") == "mine");
    CHECK(content_of(folder / "out" / "images" / "sample_album" / "deep" / "sample_1.png") == "mine");

    // And where the older folder lost its name when a process was killed.
    fs::rename(folder / "out", folder / ".out.older-7");
    fs::create_directory(folder / "out");
    folder.write("out/summary.json", own_marker);
    { AtomicFolder const look(folder / "out", marked); }
    CHECK(content_of(folder / "out" / "images" / "photo.jpg") == "mine");
    CHECK_FALSE(fs::exists(folder / "out" / "images" / "sample_0.png"));
    CHECK(entries_in(folder.path()) == 1);
}

TEST_CASE("A folder that is replaced keeps its rights, and so do files in it", "[atomic_folder]") {
    TempFolder const folder;
    write_marked(folder / "out");
    fs::permissions(folder / "out", fs::perms(02775));
    fs::permissions(folder / "out" / "summary.json", fs::perms(0660));
    fs::permissions(folder / "out" / "images", fs::perms(0700));
    write_marked(folder / "out");
    CHECK(fs::status(folder / "out").permissions() == fs::perms(02775));
    CHECK(fs::status(folder / "out" / "summary.json").permissions() == fs::perms(0660));
    CHECK(fs::status(folder / "out" / "images").permissions() == fs::perms(0700));
    fs::permissions(folder / "out", fs::perms(0500));
    write_marked(folder / "out");
    CHECK(fs::status(folder / "out").permissions() == fs::perms(0500));
}

TEST_CASE("What is written for a private folder is private meanwhile", "[atomic_folder]") {
    TempFolder const folder;
    write_marked(folder / "out");
    fs::permissions(folder / "out", fs::perms(0750));
    AtomicFolder output(folder / "out", marked);
    CHECK(fs::status(output.path()).permissions() == fs::perms(0750));
}

}  // namespace atomic_folder_test
