// Where a command's outputs go: never onto each other or onto what is read, into folders that are made, and all listed.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace outputs_test {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using namespace faster::test;
using Words = std::vector<std::string>;

class Workspace {
  public:
    Workspace() {
        fs::copy(FASTER_SOURCE_DIR "/traces/one_triangle", small_.folder() / "trace");
        fs::create_symlink("nowhere", small_.folder() / "dangling");
        small_.folder().write("config.yaml", "accelerator: {raster_cores: 2}\nworkload: {trace: trace}\n");
    }
    CommandResult tool(Words const& words) const { return run_command(FASTER_SIM_BINARY, words, folder().path()); }
    /// In one line, and nothing is written.
    void check_refused(Words const& words, Words const& parts) const {
        std::size_t const files = entries_in(folder().path());
        CAPTURE(words);
        check_bad_input(tool(words), parts);
        CHECK(entries_in(folder().path()) == files);
        CHECK_THAT(small_.text("config.yaml"), Contains("workload: {trace: trace}"));
    }
    TempFolder const& folder() const { return small_.folder(); }
    SmallWorkspace const& small() const { return small_; }

  private:
    SmallWorkspace small_;
};

TEST_CASE("How many host cores a run uses changes no figure, and nothing that it records") {
    Workspace const workspace;
    for (std::string const jobs : {"1", "2", "7"})
        require_done(workspace.tool({"run", "config.yaml", "-j", jobs, "--out", jobs, "--events", jobs + ".events"}));
    for (std::string const jobs : {"2", "7"}) {
        CAPTURE(jobs);
        std::string const alone = jobs + "_alone";  // with some of the cores in each of several processes
        require_done(workspace.tool({"run", "config.yaml", "-j", jobs, "--out", alone}));
        for (std::string const table : {"samples.csv", "fifos.csv", "loops.csv"}) {
            CHECK(workspace.small().text(jobs + "/" + table) == workspace.small().text("1/" + table));
            CHECK(workspace.small().text(alone + "/" + table) == workspace.small().text("1/" + table));
        }
        CHECK(workspace.small().text(jobs + ".events") == workspace.small().text("1.events"));
    }
    workspace.check_refused({"run", "config.yaml", "-j", "0"}, {"--jobs"});
}

TEST_CASE("Two outputs of a command to one path are refused") {
    Workspace const workspace;
    std::string const both = "one would replace the other";
    workspace.check_refused({"run", "config.yaml", "--report", "a", "--events", "./a"},
                            {"--report a and --events ./a", both});
    workspace.check_refused({"run", "config.yaml", "--vcd", "a.vcd", "--timeline", "a.vcd"}, {"--vcd a.vcd", both});
    workspace.check_refused({"run", "config.yaml", "--vcd", "a.vcd", "--timeline", "a.gtkw"}, {"a.gtkw", both});
    workspace.check_refused({"run", "config.yaml", "--vcd", "a.gtkw"}, {"a.gtkw", both});
    workspace.check_refused({"run", "config.yaml", "--out", "o", "--report", "o"}, {"--out o and --report o", both});
    workspace.check_refused({"run", "config.yaml", "--out", "o", "--vcd", "o/summary.json"}, {"o/summary.json", both});
    workspace.check_refused({"run", "config.yaml", "--out", "o", "--report", "o/images/r.html"}, {"images", both});
    workspace.check_refused({"run", "config.yaml", "--report", "a/b", "--events", "a"}, {both});
    workspace.check_refused({"run", "config.yaml", "--report", "dangling/r"}, {"dangling/r: cannot be written"});
    fs::create_directory(workspace.folder() / "real");
    fs::create_symlink("real", workspace.folder() / "link");
    workspace.check_refused({"run", "config.yaml", "--report", "link/r", "--events", "real/r"}, {both});
}

TEST_CASE("An output onto what is read is refused") {
    Workspace const workspace;
    require_done(workspace.tool({"run", "config.yaml", "--out", "a", "--events", "a.events"}));
    require_done(workspace.tool({"check", "--init", "config.yaml", "--out", "b.yaml"}));
    std::string const read = "is read, expected another path";
    for (std::string const option : {"--vcd", "--timeline", "--report", "--events", "--out"}) {
        workspace.check_refused({"run", "config.yaml", option, "config.yaml"}, {option + " config.yaml", read});
        workspace.check_refused({"run", "config.yaml", option, "trace/samples.csv"}, {"trace/samples.csv", read});
    }
    workspace.check_refused({"run", "config.yaml", "--out", "trace"}, {"--out trace", read});
    workspace.check_refused({"record", "config.yaml", "--out", "trace"}, {"--out trace", read});
    workspace.check_refused({"whatif", "a.events", "--out", "a.events"}, {"--out a.events", read});
    workspace.check_refused({"sensitivities", "a.events", "--csv", "a.events"}, {"--csv a.events", read});
    workspace.check_refused({"size-fifos", "a.events", "--within", "5", "--out", "a.events"}, {read});
    workspace.check_refused({"compare", "a", "a", "--json", "a/summary.json"}, {"--json a/summary.json", read});
    workspace.check_refused({"check", "b.yaml", "--json", "b.yaml"}, {"--json b.yaml", read});
    workspace.check_refused({"check", "b.yaml", "--junit", "config.yaml"}, {"--junit config.yaml", read});
    workspace.check_refused({"check", "--init", "config.yaml", "--out", "config.yaml"}, {"is there already"});
}

TEST_CASE("A folder that is called like the object is no file of it") {
    SmallWorkspace const small;
    require_done(small.run({"--out", "tomato_soup_can"}));
    require_done(small.run({"--out", "tomato_soup_can"}));
}

TEST_CASE("All outputs of a run may lie in its folder, and appear with it") {
    Workspace const workspace;
    Words const words{"run",        "config.yaml",    "--out",    "new/o",          "--vcd",    "new/o/w.vcd",
                      "--timeline", "new/o/t/t.json", "--events", "new/o/e.events", "--report", "new/o/r.html"};
    CommandResult const result = workspace.tool(words);
    require_done(result);
    CHECK_THAT(result.out, Contains("written: new/o\n") && Contains("written: new/o/e.events\n") &&
                               Contains("written: new/o/r.html\n") &&
                               Contains("written: new/o/t/t.json, new/o/w.vcd, new/o/w.command_command.txt, "));
    CHECK(workspace.small().files_in("new/o") == 14);
    CHECK_THAT(workspace.small().text("new/o/w.gtkw"), Contains("\"w.vcd\"") && Contains(" w.states.txt\n"));

    std::string const waves = workspace.small().text("new/o/w.vcd");
    workspace.folder().write("new/o/notes.txt", "mine");
    workspace.folder().write("new/o/w.vcd", "older");
    workspace.folder().write("new/o/w.txt", "not of the waveform");
    CommandResult const again = workspace.tool(words);
    require_done(again);
    CHECK(again.out.find("w.txt") == std::string::npos);
    CHECK(workspace.small().text("new/o/notes.txt") == "mine");
    CHECK(workspace.small().text("new/o/w.vcd") == waves);
    CHECK(workspace.small().files_in("new/o") == 16);
    CHECK(workspace.small().files_in("new") == 1);
}

TEST_CASE("A page of an older run leaves its folder, unless this run writes it") {
    Workspace const workspace;
    Words const plain{"run", "config.yaml", "--out", "o"};
    Words with_page = plain;
    with_page.insert(with_page.end(), {"--report", "o/report.html"});
    fs::path const page = workspace.folder() / "o" / "report.html";
    require_done(workspace.tool(with_page));
    fs::permissions(page, fs::perms(0600));
    require_done(workspace.tool(with_page));
    CHECK(fs::status(page).permissions() == fs::perms(0600));
    require_done(workspace.tool(plain));
    CHECK_FALSE(fs::exists(page));
    workspace.folder().write("o/report.html", "mine");
    require_done(workspace.tool(plain));
    CHECK(workspace.small().text("o/report.html") == "mine");
}

TEST_CASE("A waveform has no name of the other format") {
    Workspace const workspace;
    workspace.check_refused({"run", "config.yaml", "--vcd", "w.fst"}, {"--vcd", "w.fst, expected", "--fst"});
    workspace.check_refused({"run", "config.yaml", "--fst", "w.vcd"}, {"--fst", "w.vcd, expected", "--vcd"});
}

TEST_CASE("Every output makes the folders that are missing") {
    Workspace const workspace;
    require_done(workspace.tool({"run", "config.yaml", "--events", "a/a/e", "--vcd", "a/b/w.vcd", "--timeline",
                                 "a/c/t.json", "--report", "a/d/r.html", "--out", "a/e/o"}));
    require_done(workspace.tool({"compare", "a/e/o", "a/e/o", "--json", "a/f/c.json"}));
    CommandResult const started = workspace.tool({"check", "--init", "config.yaml", "--out", "a/g/h/b.yaml"});
    require_done(started);
    CommandResult const checked =
        workspace.tool({"check", "a/g/h/b.yaml", "--json", "a/i/j.json", "--junit", "a/j/j.xml"});
    require_done(checked);
    CHECK_THAT(checked.out, Contains("written: a/j/j.xml\n") && Contains("written: a/i/j.json\n"));
    CHECK(workspace.small().files_in("a") == 9);
    CHECK(workspace.small().files_in("a/g/h") == 1);
}

TEST_CASE("A dump into a pipe has nothing beside it") {
    Workspace const workspace;
    CommandResult const result = run_command(
        "/bin/sh", {"-c", "mkfifo w.vcd; cat w.vcd > copy & " FASTER_SIM_BINARY " run config.yaml --vcd w.vcd; wait"},
        workspace.folder().path());
    require_done(result);
    CHECK_THAT(workspace.small().text("copy"), Contains("$enddefinitions"));
    CHECK(workspace.small().files_in("") == 5);
}

TEST_CASE("An FST is no pipe and no device, and removes none") {
    Workspace const workspace;
    run_command("/bin/sh", {"-c", "mkfifo w.fst"}, workspace.folder().path());
    std::size_t const files = workspace.small().files_in("");
    check_bad_input(run_command(FASTER_SIM_BINARY, {"run", "config.yaml", "--fst", "w.fst"}, workspace.folder().path()),
                    {"w.fst: is no regular file, expected a new file or one to replace"});
    CHECK(fs::is_fifo(workspace.folder() / "w.fst"));
    CHECK(workspace.small().files_in("") == files);
}

TEST_CASE("A folder with a summary of something else is refused, and nothing in it is lost") {
    Workspace const workspace;
    fs::create_directories(workspace.folder() / "p" / "images");
    workspace.folder().write("p/summary.json", "{\"mine\": 1}");
    workspace.folder().write("p/samples.csv", "mine");
    workspace.folder().write("p/images/photo.jpg", "mine");
    for (std::string const command : {"run", "grip"})
        workspace.check_refused({command, "config.yaml", "--out", "p"},
                                command == "grip" ? Words{} : Words{"p: holds a summary.json of something else"});
    CHECK(workspace.small().text("p/summary.json") == "{\"mine\": 1}");
    CHECK(workspace.small().text("p/samples.csv") == "mine");
    CHECK(workspace.small().text("p/images/photo.jpg") == "mine");
}

TEST_CASE("Outputs that are replaced keep the rights that they had") {
    Workspace const workspace;
    Words const words{"run", "config.yaml", "--out", "o",     "--report", "r.html",     "--events",
                      "e",   "--vcd",       "w.vcd", "--fst", "w.fst",    "--timeline", "t.json"};
    require_done(workspace.tool(words));
    auto const rights = [&](std::string const& name) { return fs::status(workspace.folder() / name).permissions(); };
    Words const files{"r.html", "e", "w.vcd", "w.fst", "w.gtkw", "t.json", "o/summary.json", "o/samples.csv"};
    for (std::string const& file : files)
        fs::permissions(workspace.folder() / file, fs::perms(0660));
    fs::permissions(workspace.folder() / "o", fs::perms(02775));
    require_done(workspace.tool(words));
    for (std::string const& file : files) {
        CAPTURE(file);
        CHECK(rights(file) == fs::perms(0660));
    }
    CHECK(rights("o") == fs::perms(02775));
}

}  // namespace outputs_test
