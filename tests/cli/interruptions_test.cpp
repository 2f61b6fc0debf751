// Whenever a command is told to end, is killed, or a call of the system fails: nothing half-written, nothing of the
// user's lost, and a repeat of the command ends as if nothing had been. Repeats are made in surroundings of any kind
// (locale, time zone, umask, layout of memory, number of processes): the same command writes the same bytes.
//   FASTER_SEED           of what is random
//   FASTER_INTERRUPTIONS  how many (12)                          scripts/test-interruptions.sh
//   FASTER_FAULTS         how many (6), or all                   scripts/test-faults.sh
//   FASTER_DISKS          how many full disks for each command (or one for every other)
//   FASTER_COMMANDS       only those whose name contains it
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/tool_output.hpp"
#include "support/writing_commands.hpp"

namespace interruptions_test {

using namespace faster::test;
using Words = std::vector<std::string>;

std::string text_from(char const* variable, std::string const& otherwise) {
    char const* const text = std::getenv(variable);
    return text == nullptr ? otherwise : text;
}

unsigned long number_from(char const* variable, unsigned long otherwise) {
    return std::stoul(text_from(variable, std::to_string(otherwise)));
}

unsigned long seed_of_test() {
    unsigned long const seed = number_from("FASTER_SEED", std::random_device()());
    std::cout << "seed " << seed << "\n";
    return seed;
}

/// All but the one of that name.
std::vector<WritingCommand> chosen_commands(std::string const& without = "") {
    std::vector<WritingCommand> commands = writing_commands();
    std::string const part = text_from("FASTER_COMMANDS", "");
    commands.erase(std::remove_if(commands.begin(), commands.end(),
                                  [&](WritingCommand const& each) {
                                      return each.name == without || each.name.find(part) == std::string::npos;
                                  }),
                   commands.end());
    return commands;
}

/// Those of commands, made when they are first asked for.
class Scenes {
  public:
    explicit Scenes(std::vector<WritingCommand> commands) : commands_(std::move(commands)), scenes_(commands_.size()) {}
    std::size_t count() const { return commands_.size(); }
    WritingScene const& at(std::size_t which) {
        if (scenes_[which] == nullptr)
            scenes_[which] = std::make_unique<WritingScene>(commands_[which]);
        return *scenes_[which];
    }

  private:
    std::vector<WritingCommand> commands_;
    std::vector<std::unique_ptr<WritingScene>> scenes_;
};

/// A locale that writes decimal commas, where the host has what it is made of.
Words words_of_german() {
    static TempFolder const folder;
    static bool const is_there =
        std::filesystem::exists("/usr/share/i18n/locales/de_DE") &&
        run_command("/usr/bin/localedef", {"-f", "ISO-8859-1", "-i", "de_DE", folder / "de_DE"}, "/").exit_code == 0;
    return is_there ? Words{"LC_ALL=de_DE", "LOCPATH=" + folder.path().string()} : Words{};
}

bool may_place_addresses() {
    static bool const may = run_command("/usr/bin/setarch", {"-R", "true"}, "/").exit_code == 0;
    return may;
}

/// A command with what must not matter chosen at random: locale, time zone, umask, where the system places memory, and
/// the number of processes or threads.
Words in_any_surroundings(Words words, std::mt19937& random) {
    auto const any = [&](Words const& choices) { return choices[random() % choices.size()]; };
    if (auto const jobs = std::find(words.begin(), words.end(), "-j"); jobs != words.end())
        *std::next(jobs) = any({"1", "2", "3", "4"});
    Words around{"-c",           "umask $1; shift; exec \"$@\"",
                 "sh",           any({"000", "022", "077"}),
                 "/usr/bin/env", "TZ=" + any({"UTC", "Asia/Kathmandu", "America/St_Johns", "nonsense"})};
    if (random() % 2 == 0) {
        Words const german = words_of_german();
        around.insert(around.end(), german.begin(), german.end());
    }
    if (random() % 2 == 0 && may_place_addresses())
        around.insert(around.end(), {"/usr/bin/setarch", "-R"});
    around.push_back(FASTER_SIM_BINARY);
    around.insert(around.end(), words.begin(), words.end());
    return around;
}

void check_repeat(WritingScene const& scene, TempFolder const& folder, std::mt19937& random) {
    Words const words = in_any_surroundings(scene.command().words, random);
    CommandResult const repeat = run_command("/bin/sh", words, folder.path());
    CAPTURE(words, repeat.err);
    CHECK(repeat.exit_code == 0);
    CHECK(scene.complaint_after_repeat(folder.path()) == "");
}

constexpr double second_after_s = 0.25;

/// A call of the system that is to fail, or before which the process is to be killed.
struct Fault {
    std::string call;
    unsigned number = 1;  // of these calls in each process
    std::string how;      // an error, or KILL
    bool may_be_left = false;
    std::string line;             // of an undisturbed run, for messages
    bool may_be_missing = false;  // until the command is repeated

    bool kills() const { return how == "KILL"; }
    std::string option() const {
        return "inject=" + call + (kills() ? ":signal=KILL" : ":error=" + how) + ":when=" + std::to_string(number);
    }
};

std::map<std::string, Words> const& errors_of_calls() {
    static std::map<std::string, Words> const errors{{"openat", {"EMFILE"}},
                                                     {"read", {"EIO"}},
                                                     {"pread64", {"EIO"}},
                                                     {"write", {"ENOSPC"}},
                                                     {"writev", {"ENOSPC"}},
                                                     {"rename", {"EIO"}},
                                                     {"renameat2", {"EIO", "EINVAL"}},
                                                     {"link", {"EPERM"}},
                                                     {"linkat", {"EPERM"}},
                                                     {"symlink", {"EIO"}},
                                                     {"unlink", {"EIO"}},
                                                     {"unlinkat", {"EIO"}},
                                                     {"rmdir", {"EIO"}},
                                                     {"mkdir", {"ENOSPC"}},
                                                     {"fsync", {"EIO"}},
                                                     {"fdatasync", {"EIO"}},
                                                     {"ftruncate", {"EIO"}},
                                                     {"flock", {"ENOLCK"}},
                                                     {"fcntl", {"EAGAIN"}},
                                                     {"clone", {"EAGAIN"}},
                                                     {"clone3", {"EAGAIN"}},
                                                     {"pipe2", {"EMFILE"}},
                                                     {"pipe", {"EMFILE"}},
                                                     {"eventfd2", {"EMFILE"}},
                                                     {"chmod", {"EPERM"}},
                                                     {"getdents64", {"EIO"}}};
    return errors;
}

/// Libraries, locales and what the host is like are not the command's.
constexpr std::array<char const*, 5> host_places{"/usr/", "/lib/", "/proc/", "/sys/", "/etc/"};

/// Faults are for our own processes: what a program that they start makes of its own is not ours to say. Graphviz's dot
/// ends well even where it cannot read its fonts; what follows when it fails is in report_test.cpp.
Words traced(WritingCommand const& command, Words const& options) {
    Words words{"-f", "--detach-on=execve", "-y", "-qq", "-s", "0"};
    words.insert(words.end(), options.begin(), options.end());
    words.push_back(FASTER_SIM_BINARY);
    words.insert(words.end(), command.words.begin(), command.words.end());
    return words;
}

bool strace_is_missing() {
    if (std::filesystem::exists("/usr/bin/strace"))
        return false;
    WARN("skipped: strace is not installed (scripts/setup.sh --dev installs it)");
    return true;
}

CommandResult run_traced(WritingCommand const& command, Words const& options, TempFolder const& folder) {
    return run_command("/usr/bin/strace", traced(command, options), folder.path());
}

/// Whether an error of it can keep something from being removed.
bool removes(std::string const& call) {
    static std::set<std::string> const all{"unlink", "unlinkat", "rmdir",  "getdents64",
                                           "flock",  "link",     "linkat", "openat"};
    return all.count(call) > 0;
}

/// Of all calls that an undisturbed run makes, but for those that load libraries or look at the host.
std::vector<Fault> faults_of(WritingScene const& scene) {
    TempFolder const folder, log;
    scene.lay_out(folder.path());
    std::string calls;
    for (auto const& [call, errors] : errors_of_calls())
        calls += (calls.empty() ? "" : ",") + call;
    CommandResult const result =
        run_traced(scene.command(), {"-o", (log / "log").string(), "-e", "trace=" + calls}, folder);
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    std::map<std::pair<std::string, std::string>, unsigned> counts;
    std::map<std::pair<std::string, unsigned>, std::string> found;
    std::set<std::pair<std::string, unsigned>> before_main;  // would keep the command from being started
    std::istringstream lines(content_of(log / "log"));
    std::string first_process;
    for (std::string process, line; lines >> process && std::getline(lines, line);) {
        first_process = first_process.empty() ? process : first_process;
        line.erase(0, line.find_first_not_of(' '));
        std::string const call = line.substr(0, line.find('('));
        if (errors_of_calls().count(call) == 0)
            continue;
        unsigned const number = ++counts[{process, call}];
        bool const is_of_host = std::any_of(host_places.begin(), host_places.end(),
                                            [&](char const* place) { return line.find(place) != std::string::npos; });
        bool const is_of_library = call == "fcntl" && line.find("F_SETLK") == std::string::npos;
        if (!is_of_host && !is_of_library)
            found.try_emplace({call, number}, line);
        else if (process == first_process)
            before_main.emplace(call, number);
    }
    for (auto const& call : before_main)  // a fault hits the call of that number in every process
        found.erase(call);
    std::vector<Fault> faults;
    for (auto const& [which, line] : found) {
        faults.push_back({which.first, which.second, "KILL", true, line});
        for (std::string const& error : errors_of_calls().at(which.first))
            faults.push_back({which.first, which.second, error, removes(which.first), line});
    }
    return faults;
}

void check_fault(WritingScene const& scene, Fault const& fault, std::mt19937& random, Words const& more = {}) {
    TempFolder const folder;
    scene.lay_out(folder.path());
    CAPTURE(scene.command().name, fault.option(), fault.line);
    Words options{"-o", "/dev/null", "-e", "trace=" + fault.call + (more.empty() ? "" : ",renameat2")};
    options.insert(options.end(), {"-e", fault.option()});
    options.insert(options.end(), more.begin(), more.end());
    int exit_code = -1;
    std::string err;
    try {
        CommandResult const result = run_traced(scene.command(), options, folder);
        exit_code = result.exit_code;
        err = result.err;
    } catch (std::runtime_error const& error) {  // strace ends as what it traces does
        std::string const what = error.what();
        bool const is_before_main = what.find("cannot be started") != std::string::npos;  // a library cannot be loaded
        CAPTURE(what);
        CHECK((fault.kills() || is_before_main));
    }
    CAPTURE(exit_code, err);
    CHECK(exit_code <= 2);
    if (!fault.kills() && exit_code == 2)
        CHECK(std::count(err.begin(), err.end(), '\n') <= 1);  // none if that is what cannot be written
    bool const is_of_library = fault.call == "clone3";         // which starts a thread
    if (!is_of_library)
        CHECK(err.find("unexpected error") == std::string::npos);
    CHECK(scene.complaint(folder.path(), fault.may_be_left, fault.may_be_missing, exit_code != 0) == "");
    if (exit_code == 0 && !fault.may_be_left)
        CHECK(scene.complaint_after_repeat(folder.path()) == "");
    check_repeat(scene, folder, random);
}

TEST_CASE("Interruptions at random moments leave the older results or the new ones, and nothing else") {
    unsigned long const count = number_from("FASTER_INTERRUPTIONS", 12), seed = seed_of_test();
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
    Scenes scenes(chosen_commands());
    constexpr std::array<int, 5> signals{SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGKILL};
    unsigned long stopped = 0, sent_twice = 0;
    std::map<std::string, std::pair<unsigned long, unsigned long>> stopped_of;  // of a command: how often, of how often
    for (unsigned long i = 0; i < count; ++i) {
        WritingScene const& scene = scenes.at((seed + i) % scenes.count());  // every command in turn
        int const signal = signals.at(random() % signals.size());
        double const delay = std::uniform_real_distribution<double>(0, 1.1 * scene.seconds())(random);
        TempFolder const folder;
        scene.lay_out(folder.path());
        bool const is_sent_twice = signal != SIGKILL && random() % 8 == 0;
        CAPTURE(scene.command().name, signal, delay, is_sent_twice);
        int const ended_by = interrupted_command(FASTER_SIM_BINARY, scene.command().words, folder.path(), delay, signal,
                                                 is_sent_twice ? second_after_s : 0);
        CAPTURE(ended_by);
        CHECK((ended_by == 0 || ended_by == signal));
        stopped += ended_by != 0 ? 1 : 0;
        sent_twice += is_sent_twice ? 1 : 0;
        auto& [stopped_here, sent_here] = stopped_of[scene.command().name];
        stopped_here += ended_by != 0 ? 1 : 0;
        ++sent_here;
        CHECK(scene.complaint(folder.path(), signal == SIGKILL || is_sent_twice) == "");
        check_repeat(scene, folder, random);
    }
    for (auto const& [name, counts] : stopped_of)
        std::cout << name << ": " << counts.first << " of " << counts.second << " stopped\n";
    std::cout << stopped << " of " << count << " commands were stopped, " << sent_twice << " got the signal twice\n";
    CHECK(stopped > count / 4);
}

TEST_CASE("A call of the system that fails leaves the older results or the new ones, and nothing else") {
    if (strace_is_missing())
        return;
    std::string const wanted = text_from("FASTER_FAULTS", "6");
    unsigned long const seed = seed_of_test();
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
    Scenes scenes(chosen_commands("run into an FST"));  // GTKWave's code does not look at what single writes return
    if (wanted == "all") {
        for (std::size_t which = 0; which < scenes.count(); ++which) {
            std::vector<Fault> const faults = faults_of(scenes.at(which));
            std::cout << scenes.at(which).command().name << ": " << faults.size() << " faults" << std::endl;
            for (Fault const& fault : faults)
                check_fault(scenes.at(which), fault, random);
        }
        return;
    }
    constexpr unsigned long commands = 2;  // each is traced as a whole first
    for (unsigned long i = 0; i < commands; ++i) {
        WritingScene const& scene = scenes.at((seed + i) % scenes.count());
        std::vector<Fault> const faults = faults_of(scene);
        for (unsigned long j = 0; j < std::stoul(wanted) / commands; ++j)
            check_fault(scene, faults[random() % faults.size()], random);
    }
}

TEST_CASE("A folder is replaced in two steps where the file system cannot do it in one, and none of it gets lost") {
    if (strace_is_missing())
        return;
    std::vector<WritingCommand> const commands = writing_commands();
    WritingScene const scene(commands.front());
    Words const without_exchange{"-e", "inject=renameat2:error=EINVAL"};
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed_of_test()));
    check_fault(scene, {"renameat2", 1, "EINVAL", false, ""}, random);
    for (unsigned const number : {5U, 6U, 7U})
        for (std::string const how : {"KILL", "EIO"})
            check_fault(scene, {"rename", number, how, true, "", how == "KILL"}, random, without_exchange);
}

TEST_CASE("A signal that comes when one of two waveforms is finished leaves nothing of the other") {
    if (strace_is_missing())
        return;
    std::vector<WritingCommand> const commands = writing_commands();
    auto const is_it = [](WritingCommand const& each) { return each.name == "run into an FST"; };
    WritingScene const scene(*std::find_if(commands.begin(), commands.end(), is_it));
    for (unsigned const number : {1U, 2U, 3U}) {
        TempFolder const folder;
        scene.lay_out(folder.path());
        std::string const fault = "inject=rename:signal=TERM:when=" + std::to_string(number);
        CAPTURE(fault);
        // strace ends as what it traces does
        CHECK_THROWS(run_traced(scene.command(), {"-o", "/dev/null", "-e", "trace=rename", "-e", fault}, folder));
        CHECK(scene.complaint(folder.path(), false) == "");
    }
}

/// Runs `$4...` on a file system of its own, which has $3 kilobytes of room beside the content of $2, and moves what is
/// there in the end to $2.
constexpr char const* on_small_disk = R"(disk=$1 folder=$2 room=$3; shift 3
mount -t tmpfs -o size=64m none "$disk" && cp -a "$folder"/. "$disk" && cd "$disk" || exit 125
mount -o remount,size=$(($(df --output=used -k . | tail -n 1) + room))k "$disk" || exit 125
TMPDIR=$disk "$@"; code=$?
find "$folder" -mindepth 1 -delete && cp -a "$disk"/. "$folder" || exit 125
exit $code)";

bool file_systems_may_not_be_mounted() {
    TempFolder const folder;
    CommandResult const result =
        run_command("/usr/bin/unshare", {"-rm", "mount", "-t", "tmpfs", "none", folder.path()}, folder.path());
    if (result.exit_code != 0)
        WARN("skipped: no file system may be mounted here: " << result.err);
    return result.exit_code != 0;
}

TEST_CASE("A disk that fills up at any moment leaves the older results or the new ones, and nothing else") {
    if (file_systems_may_not_be_mounted())
        return;
    unsigned long const disks = number_from("FASTER_DISKS", 0), seed = seed_of_test();
    std::mt19937 random(static_cast<std::mt19937::result_type>(seed));
    Scenes scenes(chosen_commands());
    unsigned long const count = disks > 0 ? disks * scenes.count() : (scenes.count() + 1) / 2;
    unsigned long full = 0;
    for (unsigned long i = 0; i < count; ++i) {
        WritingScene const& scene = scenes.at((disks > 0 ? i : 2 * i + seed) % scenes.count());
        TempFolder const folder, disk;
        scene.lay_out(folder.path());
        unsigned long const room = 4 * std::uniform_int_distribution<unsigned long>(0, scene.pages())(random);
        Words words{"-rm",
                    "sh",
                    "-c",
                    on_small_disk,
                    "sh",
                    disk.path(),
                    folder.path(),
                    std::to_string(room),
                    FASTER_SIM_BINARY};
        words.insert(words.end(), scene.command().words.begin(), scene.command().words.end());
        CommandResult const result = run_command("/usr/bin/unshare", words, folder.path());
        CAPTURE(scene.command().name, room, result.exit_code, result.err);
        if (result.exit_code != 0) {
            CHECK(result.exit_code == 2);
            CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
            CHECK_THAT(result.err, Catch::Matchers::Contains("No space left on device"));
        }
        full += result.exit_code != 0 ? 1 : 0;
        CHECK(scene.complaint(folder.path(), false, false, result.exit_code != 0) == "");
        check_repeat(scene, folder, random);
    }
    std::cout << full << " of " << count << " disks were full\n";
    CHECK(full > count / 2);
}

}  // namespace interruptions_test
