#include "support/writing_commands.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>

#include "faster/dataflow_names.hpp"
#include "poses/bop/pose_results.hpp"
#include "support/bop_folder.hpp"
#include "support/command.hpp"

namespace faster::test {

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

void require(CommandResult const& result, Words const& words) {
    if (result.exit_code != 0)
        throw std::runtime_error(words.front() + ": " + result.err);
}

CommandResult tool(fs::path const& folder, Words const& words) {
    CommandResult result = run_command(FASTER_SIM_BINARY, words, folder);
    require(result, words);
    return result;
}

std::string configuration(int angle) {
    return "accelerator: {raster_cores: 2, window: 40}\n"
           "workload:\n"
           "  object: tomato_soup_can\n"
           "  max_triangles: 60\n"
           "  pose: {translation_m: [0, 0, 0.65], rotation_deg: [" +
           std::to_string(angle) +
           ", 0, 0]}\n"
           "  camera: {width: 80, height: 60, fx: 70, fy: 70, cx: 39.5, cy: 29.5}\n"
           "  samples: {count: 2}\n"
           "estimator: {iterations: 2, weights: {least_drawn_px: 4}}\n";
}

std::string results(double shift_m) {
    std::vector<bop::PoseEstimate> estimates;
    for (int const scene : {1, 2})
        for (int const image : {0, 3}) {
            estimates.push_back(
                {{scene, image}, BopFolder::box, 0.5, BopFolder::pose_of(BopFolder::box, image), 0.25, 0});
            estimates.back().pose.translation.z() += shift_m;
        }
    return bop::pose_results_csv(estimates);
}

/// What all commands read.
void write_inputs(TempFolder const& folder, int angle) {
    folder.write("config.yaml", configuration(angle));
    folder.write("matrix.yaml", "- {accelerator.raster_cores: " + std::to_string(angle % 3 + 1) + "}\n");
    folder.write("results.csv", results(angle * 1e-4));
    folder.write("sweep.yaml",
                 "format: faster-sweep\nversion: 1\nbase: config.yaml\ndimensions:\n"
                 "  - {key: workload.samples.count, values: [1, 2]}\n"
                 "  - {key: accelerator.raster_cores, values: [1, 2]}\n");
    folder.write("experiment.yaml",
                 "format: faster-experiment\nversion: 1\n"
                 "set: {workload.samples.count: 4, estimator.iterations: 1, workload.max_triangles: 60}\n"
                 "scenes: {dark: {objects: [banana], images: 1, visible: [0.8, 1]}}\n"
                 "methods: {faster: {}}\n");
    tool(folder.path(), {"run", "config.yaml", "--events", "in.events", "--out", "a"});
    tool(folder.path(), {"run", "config.yaml", "--set", "accelerator.raster_cores=1", "--out", "b"});
    folder.write("started.yaml",
                 "format: faster-budget\nversion: 1\nconfiguration: config.yaml\n"
                 "limits: {total_cycles: {max: baseline}}\n");
    fs::remove(folder / "budget.yaml");
    tool(folder.path(), {"check", "--init", "config.yaml", "--out", "budget.yaml"});
    for (std::string const part : {"1/2", "2/2"})
        tool(folder.path(), {"sweep", "sweep.yaml", "--shard", part, "--out", "part" + part.substr(0, 1)});
}

void copy_over(fs::path const& from, fs::path const& to) {
    fs::copy(from, to, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
}

/// Inputs of the time before and of now; the dataset is that of both.
struct Inputs {
    Inputs() {
        write_inputs(before, 120);
        write_inputs(now, 100);
    }
    TempFolder before, now;
    BopFolder dataset;
};

Inputs const& inputs() {
    static Inputs const all;
    return all;
}

/// Without what stands between each `before` and the next of `ends`.
std::string without_values(std::string const& text, std::string const& before, std::string const& ends) {
    std::string plain;
    std::size_t kept = 0;
    for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, kept)) {
        plain.append(text, kept, at + before.size() - kept);
        kept = std::min(text.find_first_of(ends, at + before.size()), text.size());
    }
    return plain.append(text, kept);
}

/// Without the folder in which a test works.
std::string without_scratch(std::string const& text) {
    std::string const mark = "/faster-test-";
    std::string plain;
    std::size_t kept = 0;
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, kept)) {
        std::size_t const word = text.find_last_of(" \"\n", at);
        std::size_t const path = text.find('/', word == std::string::npos ? 0 : word);
        plain.append(text, kept, path - kept);
        kept = std::min(text.find_first_not_of("0123456789", at + mark.size()), text.size());
    }
    return plain.append(text, kept);
}

/// Without what the host's clock says, and the folder that a save file of GTKWave names. Not by regular expressions,
/// which take longer than the commands.
std::string same_every_time(std::string const& text) {
    std::string plain = without_values(text, "\"host\":", "}");
    plain = without_values(plain, "seconds\":", ",}\n");
    return without_scratch(without_values(plain, "time=\"", "\""));
}

bool is_hidden(std::string const& file) {
    fs::path const path = file;
    return std::any_of(path.begin(), path.end(),
                       [](fs::path const& part) { return part.string().front() == '.' && part != ".lock"; });
}

std::string top_of(std::string const& file) { return fs::path(file).begin()->string(); }

/// What of a tree has that first name, but for what is hidden.
Tree part_of(Tree const& tree, std::string const& top) {
    Tree part;
    for (auto const& [file, content] : tree)
        if (top_of(file) == top && !is_hidden(file))
            part[file] = content;
    return part;
}

bool is_in(Words const& words, std::string const& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

std::string content_in(Tree const& tree, std::string const& file) {
    auto const found = tree.find(file);
    return found == tree.end() ? "(missing)" : found->second;
}

}  // namespace

std::vector<WritingCommand> writing_commands() {
    std::string const dataset = inputs().dataset.path().string();
    return {
        {"run into a folder",
         {"run", "config.yaml", "--out", "o", "--images", "1", "--vcd", "o/w.vcd", "--timeline", "o/t.json"}},
        {"run into files",
         {"run", "config.yaml", "--report", "r.html", "--events", "e.events", "--vcd", "w.vcd", "--timeline",
          "t.json"}},
        {"run into an FST", {"run", "config.yaml", "--vcd", "w.vcd", "--fst", "f.fst"}},
        {"record", {"record", "config.yaml", "--out", "t"}},
        {"whatif", {"whatif", "in.events", "--set", "accelerator.fifos.vertex.depth=9", "--out", "w"}},
        {"whatif of a matrix", {"whatif", "in.events", "--matrix", "matrix.yaml", "--csv", "m.csv"}},
        {"sensitivities", {"sensitivities", "in.events", "--csv", "s.csv", "--json", "s.json"}},
        {"size-fifos", {"size-fifos", "in.events", "--within", "5", "--points", "0", "--out", "z"}},
        {"compare", {"compare", "a", "b", "--json", "c.json"}},
        {"check", {"check", "budget.yaml", "--json", "j.json", "--junit", "j.xml"}, {}, {}, {"j.json", "j.xml"}},
        {"check --update", {"check", "started.yaml", "--update", "--reason", "it moved"}},
        {"grip", {"grip", "config.yaml", "--out", "g", "-j", "1"}},
        {"estimate",
         {"estimate", "config.yaml", "--out", "es", "--events", "ee", "--vcd", "es/w.vcd", "-j", "2", "--pictures",
          "1"}},
        {"edge-quality",
         {"edge-quality", "--poses", "1", "--classes", "sugar_box", "--algorithms", "inner_border", "--out", "q"}},
        {"evaluate", {"evaluate", "results.csv", dataset, "--out", "ev", "-j", "1"}},
        {"sweep",
         {"sweep", "sweep.yaml", "--out", "sw", "-j", "2"},
         {"sw"},
         {"sw/results.csv", "sw/index.html", "sw/sweep.json"},
         {"sw/results.csv", "sw/index.html"}},
        {"sweep merge",
         {"sweep", "merge", "part1", "part2", "--out", "sm"},
         {"sm"},
         {"sm/results.csv", "sm/index.html", "sm/sweep.json", "sm/journal"}},
        {"experiment",
         {"experiment", "experiment.yaml", "--out", "ex", "-j", "2"},
         {"ex"},
         {"ex/estimates.csv", "ex/convergence.csv", "ex/boxes/dark.json", "ex/scenes/dark/camera.json",
          "ex/evaluation/dark/scores.csv", "ex/evaluation/dark/evaluation.html"},
         {"ex/estimates.csv", "ex/convergence.csv", "ex/evaluation/dark/scores.csv",
          "ex/evaluation/dark/evaluation.html"}},
    };
}

Tree tree_of(fs::path const& folder) {
    Tree tree;
    for (auto const& entry : fs::recursive_directory_iterator(folder)) {
        std::string const name = entry.path().lexically_relative(folder).string();
        tree[name] = entry.is_directory() ? "(folder)" : same_every_time(content_of(entry.path()));
    }
    return tree;
}

WritingScene::WritingScene(WritingCommand const& command) : command_(command) {
    copy_over(inputs().before.path(), before_.path());
    std::set<std::string> inputs_only;
    for (auto const& [file, content] : tree_of(before_.path()))
        inputs_only.insert(top_of(file));
    if (command_.in_place.empty()) {
        tool(before_.path(), command_.words);
        for (auto const& entry : fs::directory_iterator(before_.path()))
            if (entry.is_directory() && inputs_only.count(entry.path().filename().string()) == 0)
                before_.write((entry.path().filename() / "notes.txt").string(), "mine");
    }
    copy_over(inputs().now.path(), before_.path());
    older_ = tree_of(before_.path());

    TempFolder const after;
    lay_out(after.path());
    seconds_ = tool(after.path(), command_.words).seconds;
    newer_ = tree_of(after.path());
}

std::size_t WritingScene::pages() const {
    std::size_t count = 0;
    for (auto const& [file, content] : newer_)
        if (content != content_in(older_, file))
            count += content.size() / 4096 + 1;
    return count;
}

void WritingScene::lay_out(fs::path const& folder) const { copy_over(before_.path(), folder); }

bool WritingScene::is_in_place(std::string const& file) const { return is_in(command_.in_place, top_of(file)); }

std::string WritingScene::complaint(fs::path const& folder, bool may_be_left, bool may_be_missing,
                                    bool has_failed) const {
    Tree const tree = tree_of(folder);
    std::string text;
    std::set<std::string> tops;
    for (Tree const& each : {older_, newer_, tree})
        for (auto const& [file, content] : each) {
            if (is_hidden(file))
                text += may_be_left ? "" : file + " is left\n";
            else if (!is_in_place(file))
                tops.insert(top_of(file));
        }
    for (std::string const& top : tops) {
        if (has_failed && is_in(command_.reports, top))
            continue;
        Tree const is = part_of(tree, top);
        if (is != part_of(older_, top) && !(may_be_missing && is.empty()) && is != part_of(newer_, top))
            text += top + " is neither the older one nor the new one\n";
    }
    for (std::string const& file : command_.whole_files_in_place) {
        std::string const is = content_in(tree, file);
        bool const may_differ = has_failed && is_in(command_.reports, file);
        if (!may_differ && is != content_in(older_, file) && is != content_in(newer_, file))
            text += file + " is neither missing nor the new one\n";
    }
    return text;
}

std::string WritingScene::complaint_after_repeat(fs::path const& folder) const {
    Tree const tree = tree_of(folder);
    std::string text;
    for (auto const& [file, content] : tree)
        if (newer_.count(file) == 0)
            text += file + " should not be there\n";
    for (auto const& [file, content] : newer_) {
        bool const is_whole = is_in(command_.whole_files_in_place, file);
        if ((is_whole || !is_in_place(file)) && content_in(tree, file) != content)
            text += file + " is not the new one\n";
    }
    return text;
}

}  // namespace faster::test
