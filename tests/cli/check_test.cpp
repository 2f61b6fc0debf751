#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/argument_words.hpp"
#include "support/command.hpp"
#include "support/is_instrumented.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace check_test {

using namespace faster::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

std::string const source = FASTER_SOURCE_DIR;

/// What every budget here starts with: the small trace without triangles on one core, 16429 cycles.
std::string head(std::string const& more = "") {
    return "# ours\nformat: faster-budget\nversion: 1\nconfiguration: " + source +
           "/configs/faster_zcu102.yaml\nset:\n  accelerator.raster_cores: 1\n" + more;
}
std::string const empty_trace = "trace: " + source + "/traces/empty\n";
std::string const some_baseline =
    "baseline: {date: 2026-01-01, reason: x, configuration: fnv1a64:0123456789abcdef, figures: {total_cycles: "
    "16000}}\n";
/// Takes minutes.
std::string const endless =
    head("  workload.samples.count: 1000000\n") + "limits:\n  total_cycles: {max: 5}\n" + some_baseline;

std::string budget(std::string const& limits) { return head() + empty_trace + "limits:\n" + limits + some_baseline; }

CommandResult check(TempFolder const& folder, Words const& more) {
    Words words{"check"};
    words.insert(words.end(), more.begin(), more.end());
    return run_command(FASTER_SIM_BINARY, words, folder.path());
}

Words shipped_budgets() {
    Words files;
    for (auto const& entry : fs::directory_iterator(fs::path(source) / "configs" / "budgets"))
        files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

/// The tool in the background, its output in files of the folder.
pid_t start(TempFolder const& folder, Words const& arguments) {
    ArgumentWords const words(FASTER_SIM_BINARY, arguments);
    std::string const out = folder / "stdout";
    pid_t const process = fork();
    if (process == 0) {
        for (int const signal : {SIGINT, SIGTERM})
            std::signal(signal, SIG_DFL);
        alarm(60);
        int const file = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        if (file >= 0 && dup2(file, STDOUT_FILENO) >= 0 && dup2(file, STDERR_FILENO) >= 0 &&
            chdir(folder.path().c_str()) == 0)
            execv(words.pointers()[0], words.pointers());
        _exit(127);
    }
    return process;
}

std::vector<pid_t> children_of(pid_t process) {
    std::string const name = std::to_string(process);
    std::istringstream list(content_of("/proc/" + name + "/task/" + name + "/children"));
    std::vector<pid_t> children;
    for (pid_t child = 0; list >> child;)
        children.push_back(child);
    return children;
}

/// Waits for that many simulations to be under way.
std::vector<pid_t> wait_for_children(pid_t process, std::size_t count) {
    for (int i = 0; i < 1000 && children_of(process).size() < count; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::vector<pid_t> children = children_of(process);
    REQUIRE(children.size() == count);
    return children;
}

bool is_gone(pid_t process) { return kill(process, 0) != 0; }

TEST_CASE("check prints every limit with its margin, and passes") {
    TempFolder const folder;
    folder.write("fine.yaml", budget("  total_cycles: {max: 85 us, min: 16000}\n"
                                     "  samples.*.latency_cycles: {max: 20000}\n"
                                     "  loops.inlier_unit.sweep.ii: {exact: 3}\n"));
    CommandResult const result = check(folder, {"fine.yaml"});
    require_done(result);
    CHECK_THAT(result.out, Contains("fine.yaml: passed\n"));
    CHECK_THAT(result.out, Contains("total_cycles") && Contains("min 16000, max 85 us") && Contains("16,429"));
    CHECK_THAT(result.out, Contains("+429"));  // to min 16000, nearer than 17000
    CHECK_THAT(result.out, Contains("samples.") && Contains(" of 4\n"));
    CHECK_THAT(result.out, Contains("1 budget: 1 passed\n"));
}

TEST_CASE("check names the breach, the margin and what moved") {
    TempFolder const folder;
    folder.write("b.yaml", head() + empty_trace + "limits:\n  total_cycles: {max: 16428}\n");
    CommandResult const updated = check(folder, {"b.yaml", "--update", "--reason", "see what happens"});
    CHECK(updated.exit_code == 1);  // the limit is broken, whatever the baseline
    CommandResult const same = check(folder, {"b.yaml"});
    CHECK(same.exit_code == 1);
    CHECK_THAT(same.out, Contains("! total_cycles") && Contains("-1  -0.01 %") &&
                             Contains("broken: total_cycles = 16,429, expected max 16428: 1 cycle above") &&
                             Contains("(\"see what happens\"):\n    nothing"));
    CommandResult const slower = check(folder, {"b.yaml", "--set", "accelerator.loops.edge_map_builder.output.ii=2"});
    CHECK(slower.exit_code == 1);
    CHECK_THAT(slower.out, Contains("setting  accelerator.loops.edge_map_builder.output.ii  1 -> 2") &&
                               Contains("shape    loops.edge_map_builder.output.ii"));
}

TEST_CASE("check writes JUnit and JSON, complete and in the order of the budgets") {
    TempFolder const folder;
    folder.write("z.yaml", budget("  total_cycles: {max: 1}\n"));
    folder.write("a.yaml", budget("  total_cycles: {max: 1 ms}\n"));
    CommandResult const result = check(folder, {"z.yaml", "a.yaml", "--junit", "out/j.xml", "--json", "out/c.json"});
    CHECK(result.exit_code == 1);
    auto const json = nlohmann::json::parse(content_of(folder / "out/c.json"));
    CHECK(json.at("format") == "faster-check");
    CHECK(json.at("passed") == false);
    REQUIRE(json.at("budgets").size() == 2);
    CHECK(json.at("budgets")[0].at("name") == "z");
    CHECK(json.at("budgets")[0].at("limits")[0].at("tightest").at("margin") == 1 - 16429);
    CHECK(json.at("budgets")[1].at("status") == "passed");
    std::string const xml = content_of(folder / "out/j.xml");
    CHECK_THAT(xml, Contains("<testsuites name=\"faster-sim check\" tests=\"2\" failures=\"1\" errors=\"0\""));
    CHECK(xml.find("name=\"z\"") < xml.find("name=\"a\""));
}

TEST_CASE("The output of check does not depend on the number of processes, nor on the current folder") {
    TempFolder const folder;
    Words words = shipped_budgets();
    words.emplace_back("-j1");
    CommandResult const one = check(folder, words);
    require_done(one);
    words.back() = "-j4";
    CommandResult const four = check(folder, words);
    CHECK(one.out == four.out);
    words.insert(words.begin(), "check");
    CHECK(run_command(FASTER_SIM_BINARY, words, source).out == one.out);
}

TEST_CASE("A budget may limit what only some configurations have, and such a one") {
    TempFolder const folder;
    std::string const two_buffers = "  accelerator.inlier_unit.buffers: 2\n  accelerator.edge_map.buffers: 2\n";
    std::string const limits =
        "limits:\n  loops.edge_map_output.output.iterations: {min: 1}\n  fifos.map_*.writes: {min: 1}\n";
    folder.write("two.yaml", head(two_buffers) + empty_trace + limits + some_baseline);
    require_done(check(folder, {"two.yaml"}));
    folder.write("one.yaml", head() + empty_trace + limits + some_baseline);
    CommandResult const without = check(folder, {"one.yaml"});
    CHECK(without.exit_code == 2);
    CHECK_THAT(without.err, Contains("one.yaml:9: limits.loops.edge_map_output.output.iterations: matches no figure"));
    require_done(check(folder, {"--init", source + "/configs/architectures/double_buffers.yaml", "--trace",
                                source + "/traces/empty", "--set", "accelerator.raster_cores=1", "--out", "new.yaml"}));
    CHECK_THAT(content_of(folder / "new.yaml"), Contains("modules.inlier_sweep.empty_stall_cycles"));
}

TEST_CASE("A bad budget is one line with its place, and nothing is simulated or written") {
    TempFolder const folder;
    folder.write("good.yaml", endless);
    folder.write("bad.yaml", budget("  total_cycle: {max: 5}\n"));
    CommandResult const result = check(folder, {"good.yaml", "bad.yaml", "--json", "c.json"});
    check_bad_input(result, {"bad.yaml:9: limits.total_cycle: unknown figure, did you mean total_cycles?"});
    CHECK(entries_in(folder.path()) == 2);
    check_bad_input(check(folder, {"nowhere.yaml"}), {"nowhere.yaml: no such file"});
    check_bad_input(check(folder, {"good.yaml", "./good.yaml"}), {"stands twice"});
    check_bad_input(check(folder, {}), {"expected a budget file"});
    check_bad_input(check(folder, {"good.yaml", "-j", "0"}), {"--jobs"});
}

TEST_CASE("What only a run can tell is wrong with a budget ends with code 2 and its line, and the others are checked") {
    TempFolder const folder;
    folder.write("good.yaml", budget("  total_cycles: {max: 1 ms}\n"));
    folder.write("core.yaml", budget("  cores.7.fifos.vertex.writes: {max: 5}\n"));
    folder.write("window.yaml", head("  accelerator.window: 64\n") + empty_trace +
                                    "limits:\n  total_cycles: {max: 5}\n" + some_baseline);
    CommandResult const core = check(folder, {"core.yaml", "good.yaml", "--junit", "j.xml"});
    CHECK(core.exit_code == 2);
    CHECK(core.err ==
          "faster-sim: core.yaml:9: limits.cores.7.fifos.vertex.writes: matches no figure of the run, "
          "expected at least one; it has 4 samples and 1 raster cores\n");
    CHECK_THAT(core.out, Contains("good.yaml: passed") && Contains("2 budgets: 1 passed, 1 bad"));
    CHECK_THAT(content_of(folder / "j.xml"), Contains("errors=\"1\""));
    CommandResult const window = check(folder, {"window.yaml"});
    CHECK(window.exit_code == 2);
    CHECK_THAT(window.err, Contains("window.yaml: ") && Contains("accelerator.window"));
}

TEST_CASE("An update needs a reason, keeps it with date and hash, and leaves comments alone") {
    TempFolder const folder;
    std::string const text = head() + empty_trace + "\nlimits:  # few\n  samples.*.*: {exact: baseline}\n  # end\n";
    folder.write("b.yaml", text);
    check_bad_input(check(folder, {"b.yaml"}), {"b.yaml:1: baseline: missing"});
    check_bad_input(check(folder, {"b.yaml", "--update"}), {"--update: expected --reason TEXT"});
    check_bad_input(check(folder, {"b.yaml", "--update", "--reason", "  "}), {"--update: expected --reason TEXT"});
    check_bad_input(check(folder, {"b.yaml", "--reason", "why"}), {"--reason: expected --update"});
    check_bad_input(check(folder, {"b.yaml", "--update", "--reason", "why", "--set", "accelerator.window=32"}),
                    {"expected no --set"});
    CHECK(content_of(folder / "b.yaml") == text);

    require_done(check(folder, {"b.yaml", "--update", "--reason", "first: \"run\" # 1"}));
    std::string const updated = content_of(folder / "b.yaml");
    CHECK(updated.find(text) == 0);
    CHECK_THAT(updated, Contains("  reason: \"first: \\\"run\\\" # 1\"\n") && Contains("total_cycles: 16429\n"));
    CHECK_THAT(updated.substr(text.size(), 30), Contains("\nbaseline:\n  date: 20"));
    CHECK_THAT(updated, Contains("  configuration: fnv1a64:"));
    require_done(check(folder, {"b.yaml"}));

    CommandResult const again = check(folder, {"b.yaml", "--update", "--reason", "second"});
    require_done(again);
    CHECK_THAT(again.out, Contains("nothing to update"));
    CHECK(content_of(folder / "b.yaml") == updated);
    CHECK(entries_in(folder.path()) == 1);
}

TEST_CASE("Figures of single cores can be limited, all of them together") {
    TempFolder const folder;
    std::string const cores = head().replace(head().find("cores: 1"), 8, "cores: 2");
    folder.write("b.yaml", cores + empty_trace + "limits:\n  cores.*.fifos.*.full_stall_cycles: {exact: baseline}\n" +
                               "  cores.1.modules.inlier_unit.busy_cycles: {max: 1 ms}\n");
    require_done(check(folder, {"b.yaml", "--update", "--reason", "two cores"}));
    CHECK_THAT(content_of(folder / "b.yaml"), Contains("    cores.1.fifos.edge_map: {full_stall_cycles: "));
    CHECK_THAT(check(folder, {"b.yaml"}).out, Contains(" of 28\n"));
    CommandResult const slower = check(folder, {"b.yaml", "--set", "accelerator.loops.inlier_unit.sweep.depth=9"});
    CHECK(slower.exit_code == 1);
    CHECK_THAT(slower.out,
               Contains("broken: cores.0.fifos.") && Contains("work     modules.inlier_unit.fill_drain_cycles"));
    CommandResult const more = check(folder, {"b.yaml", "--set", "accelerator.raster_cores=3"});
    CHECK(more.exit_code == 2);
    CHECK_THAT(more.err, Contains("b.yaml:9: limits.cores.*.fifos.*.full_stall_cycles: no cores.2."));
}

TEST_CASE("A budget started from a run is commented, passes at once, and overwrites nothing") {
    TempFolder const folder;
    fs::create_directory(folder / "sub");
    Words const words{"--init",  source + "/configs/faster_zcu102.yaml",
                      "--trace", source + "/traces/edge_heavy",
                      "--set",   "accelerator.raster_cores=1",
                      "--set",   "accelerator.raster_cores=2",
                      "--out",   "sub/mine.yaml"};
    CommandResult const result = check(folder, words);
    require_done(result);
    CHECK_THAT(result.out, Contains("written: sub/mine.yaml"));
    CHECK_THAT(content_of(folder / "sub/mine.yaml"), Contains("  # No sample takes longer than it does today") &&
                                                         Contains("configuration\n  accelerator.raster_cores: 2\n\n"));
    require_done(check(folder, {"sub/mine.yaml"}));
    CHECK(check(folder, {"sub/mine.yaml", "--set", "accelerator.loops.inlier_unit.sweep.ii=4"}).exit_code == 1);
    check_bad_input(check(folder, words), {"sub/mine.yaml: is there already"});

    folder.write("small.yaml", "accelerator: {raster_cores: 2, window: 16}\nworkload: {samples: {count: 0}}\n");
    require_done(check(folder, {"--init", "small.yaml"}));
    CHECK_THAT(content_of(folder / "small.budget.yaml"), Contains("configuration: \"small.yaml\""));
    require_done(check(folder, {"small.budget.yaml"}));
    check_bad_input(check(folder, {"--init", "nowhere.yaml"}), {"nowhere.yaml: no such file"});
    check_bad_input(check(folder, {"--init", "small.yaml", "--out", "small.yaml/b.yaml"}), {"cannot be written"});
    check_bad_input(check(folder, {"--init", "small.yaml", "small.budget.yaml"}), {"--init: expected no budgets"});
}

TEST_CASE("A deadlocked run fails its budget and says who waits for whom") {
    TempFolder const folder;
    CommandResult const result = check(folder, {source + "/configs/budgets/edge_heavy_1_core.yaml", "--set",
                                                "accelerator.fifos.fragment_index.depth=1"});
    CHECK(result.exit_code == 1);
    CHECK_THAT(result.out, Contains("edge_heavy_1_core.yaml: deadlocked") && Contains("wait-for cycle:") &&
                               Contains("fragment_index, which holds 1 of 1 tokens") &&
                               Contains("setting  accelerator.fifos.fragment_index.depth  2 -> 1"));
}

TEST_CASE("A simulation that takes too long fails its budget only") {
    TempFolder const folder;
    folder.write("slow.yaml", endless + "time_limit_s: 0.3\n");
    folder.write("good.yaml", budget("  total_cycles: {max: 1 ms}\n"));
    CommandResult const result = check(folder, {"slow.yaml", "good.yaml"});
    CHECK(result.exit_code == 1);
    CHECK(result.seconds < 20);
    CHECK_THAT(result.out, Contains("slow.yaml: timed_out\n  no result after 0.3 s") && Contains("good.yaml: passed") &&
                               Contains("1 passed, 1 timed_out"));
    folder.write("slow.yaml", endless);
    CHECK_THAT(check(folder, {"slow.yaml", "--time-limit", "0.2"}).out, Contains("no result after 0.2 s"));
}

TEST_CASE("A simulation that crashes fails its budget only") {
    TempFolder const folder;
    folder.write("crash.yaml", endless);
    folder.write("good.yaml", budget("  total_cycles: {max: 1 ms}\n"));
    pid_t const tool = start(folder, {"check", "-j1", "crash.yaml", "good.yaml"});
    kill(wait_for_children(tool, 1).front(), SIGKILL);
    int status = 0;
    REQUIRE(waitpid(tool, &status, 0) == tool);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 1);
    CHECK_THAT(content_of(folder / "stdout"), Contains("crash.yaml: crashed\n  the simulation was ended by signal 9") &&
                                                  Contains("good.yaml: passed"));
}

TEST_CASE("Ctrl-C leaves no process and no file behind") {
    for (int const signal : {SIGINT, SIGTERM, SIGKILL}) {
        TempFolder const folder;
        folder.write("a.yaml", endless);
        folder.write("b.yaml", endless);
        Words words{"check", "-j2", "a.yaml", "b.yaml", "--junit", "j.xml", "--json", "c.json"};
        if (signal == SIGTERM)
            words = {"check", "-j2", "a.yaml", "b.yaml", "--update", "--reason", "x"};
        pid_t const tool = start(folder, words);
        std::vector<pid_t> const simulations = wait_for_children(tool, 2);
        kill(tool, signal);
        int status = 0;
        REQUIRE(waitpid(tool, &status, 0) == tool);
        CHECK(WIFSIGNALED(status));
        CHECK(WTERMSIG(status) == signal);
        if (signal != SIGKILL)  // then init buries them, in its own time: tested with the process pool
            CHECK(std::all_of(simulations.begin(), simulations.end(), is_gone));
        CHECK(entries_in(folder.path()) == 3);  // two budgets and what we caught of stdout
        CHECK(content_of(folder / "a.yaml") == endless);
    }
}

TEST_CASE("Budgets are shipped for the five classes and the extremes, on one core and on ten, with small traces") {
    Words names;
    for (std::string const& file : shipped_budgets())
        names.push_back(fs::path(file).stem().string());
    for (char const* const what : {"banana", "cracker_box", "mustard_bottle", "potted_meat_can", "tomato_soup_can",
                                   "empty", "full_window", "fragment_heavy", "edge_heavy"})
        for (char const* const cores : {"_1_core", "_10_cores"})
            CHECK(std::find(names.begin(), names.end(), what + std::string(cores)) != names.end());
    std::uintmax_t bytes = 0;
    for (auto const& entry : fs::recursive_directory_iterator(fs::path(source) / "traces"))
        bytes += entry.is_regular_file() ? entry.file_size() : 0;
    CHECK(bytes < 2'000'000);
}

TEST_CASE("All shipped budgets together are quick", "[resources]") {
    TempFolder const folder;
    Words words = shipped_budgets();
    words.emplace_back("-j1");
    double fastest = 100;
    for (int i = 0; i < 3 && fastest >= 8; ++i) {  // the machine may be busy with something else
        CommandResult const result = check(folder, words);
        require_done(result);
        fastest = std::min(fastest, result.seconds);
    }
    CAPTURE(fastest);
    CHECK((is_instrumented || fastest < 8));  // docs/performance.md: below 2 s
}

TEST_CASE("Every test case of JUnit has a class and a name that no other has") {
    TempFolder const folder;
    for (char const* const sub : {"a", "b", "c"})
        fs::create_directory(folder / sub);
    std::string const text = budget("  total_cycles: {max: baseline}\n  milliseconds: {max: baseline}\n");
    for (char const* const file : {"a/budget.yaml", "b/budget.yaml", "c/budget.yaml", "c/budget.yml", "other.yaml"})
        folder.write(file, text);
    check(folder, {"a/budget.yaml", "./b/budget.yaml", "other.yaml", "--junit", "j.xml"});
    std::string const xml = content_of(folder / "j.xml");
    CHECK_THAT(xml, Contains("classname=\"a/budget\" name=\"total_cycles: ") && Contains("classname=\"b/budget\"") &&
                        Contains("classname=\"other\"") && Contains("<testsuite name=\"a/budget\" "));
    check(folder, {"a/budget.yaml", "c/budget.yaml", "c/budget.yml", "--junit", "j.xml"});
    for (std::string const& one : {xml, content_of(folder / "j.xml")}) {
        std::set<std::string> names;
        std::size_t cases = 0;
        for (std::size_t at = one.find("<testcase"); at != std::string::npos; at = one.find("<testcase", at + 1)) {
            names.insert(one.substr(at, one.find(" time=", at) - at));
            ++cases;
        }
        CAPTURE(one);
        CHECK(cases == 6);
        CHECK(names.size() == 6);
    }
}

}  // namespace check_test
