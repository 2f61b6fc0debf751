#include "fuzz/targets.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include "dataflow/base/files/csv_integers.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/config/settings_list.hpp"
#include "dataflow/tools/budgets/budget_file.hpp"
#include "dataflow/tools/compare/read_run.hpp"
#include "dataflow/tools/sweeps/journal.hpp"
#include "dataflow/tools/sweeps/manifest.hpp"
#include "dataflow/tools/sweeps/point_result.hpp"
#include "dataflow/tools/sweeps/sweep.hpp"
#include "dataflow/tools/sweeps/sweep_file.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/depth_image.hpp"
#include "faster/workload/files/mesh_import.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/files/trace.hpp"
#include "faster/workload/pose_list.hpp"
#include "fuzz/engine_target.hpp"
#include "poses/bop/detections.hpp"
#include "poses/bop/pose_results.hpp"
#include "poses/bop/read_dataset.hpp"

namespace faster::fuzz {

namespace {

namespace fs = std::filesystem;

/// A folder for the files that readers get: in memory if the host has such a place, and nobody says where.
class Folder {
  public:
    Folder() : path_(root() / ("faster-fuzz-" + std::to_string(getpid()))) { fs::create_directories(path_); }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(Folder const&) = delete;
    Folder& operator=(Folder const&) = delete;

    fs::path write(char const* name, std::string_view bytes) const {
        fs::path file = path_ / name;
        fs::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary | std::ios::trunc).write(bytes.data(), std::streamsize(bytes.size()));
        return file;
    }

  private:
    static fs::path root() {
        bool const is_told = std::getenv("TMPDIR") != nullptr;
        return !is_told && fs::is_directory("/dev/shm") ? fs::path("/dev/shm") : fs::temp_directory_path();
    }

    fs::path path_;
};

fs::path file_of(char const* name, std::string_view bytes) {
    static Folder const folder;
    return folder.write(name, bytes);
}

/// Takes the bytes up to a line of `%%` off the front, so that one input feeds several files.
std::string_view take_part(std::string_view& bytes) {
    constexpr std::string_view mark = "\n%%\n";
    std::size_t const end = bytes.find(mark);
    std::string_view const part = bytes.substr(0, end);
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + mark.size());
    return part;
}

void read_settings(std::string_view bytes) {
    std::vector<std::string> settings;
    for (; !bytes.empty() && settings.size() < 20;
         bytes.remove_prefix(std::min(bytes.size(), settings.back().size() + 1)))
        settings.emplace_back(bytes.substr(0, bytes.find('\n')));
    load_config(file_of("empty.yaml", ""), settings);
}

void read_sweep(std::string_view bytes) {
    file_of("base.yaml", "accelerator: {window: 60}\n");
    auto const sweep = sweeps::read_sweep_file(file_of("sweep.yaml", bytes));
    for (std::size_t point = 0; point < std::min<std::size_t>(3, sweep.points()); ++point)
        sweep.configuration(point);
}

void read_stimulus(std::string_view bytes) {
    fs::path const manifest = file_of("trace/trace.yaml", take_part(bytes));
    file_of("trace/samples.csv", take_part(bytes));
    file_of("trace/triangles.csv", take_part(bytes));
    file_of("trace/depth.png", take_part(bytes));
    file_of("trace/edges.png", take_part(bytes));
    files::read_trace(manifest.parent_path());
}

void read_run_folder(std::string_view bytes) {
    fs::path const summary = file_of("run/summary.json", take_part(bytes));
    file_of("run/samples.csv", take_part(bytes));
    file_of("run/fifos.csv", take_part(bytes));
    file_of("run/loops.csv", take_part(bytes));
    runs::read_run(summary.parent_path());
}

void read_bop_folder(std::string_view bytes) {
    fs::path const camera = file_of("bop/test/000001/scene_camera.json", take_part(bytes));
    file_of("bop/test/000001/scene_gt.json", take_part(bytes));
    file_of("bop/test/000001/scene_gt_info.json", take_part(bytes));
    file_of("bop/models/models_info.json", take_part(bytes));
    file_of("bop/models/obj_000001.ply", take_part(bytes));
    file_of("bop/test/000001/depth/000000.png", take_part(bytes));
    bop::Dataset const dataset = bop::read_dataset(camera.parent_path().parent_path().parent_path());
    for (bop::DatasetImage const& image : dataset.images)
        bop::load_observation(image);
}

template <std::size_t place> void read_mesh(std::string_view bytes) {
    constexpr char const* names[] = {"mesh.obj", "mesh.ply", "mesh.stl", "mesh.off"};
    files::import_mesh(file_of(names[place], bytes));
}

}  // namespace

std::vector<Target> const& targets() {
    static std::vector<Target> const all{
        {"config", "a configuration file", [](auto bytes) { load_config(file_of("config.yaml", bytes)); }},
        {"settings", "arguments of --set, one per line", read_settings},
        {"matrix", "a file of whatif --matrix",
         [](auto bytes) { read_settings_list(file_of("matrix.yaml", bytes), "a: 1"); }},
        {"budget", "a budget", [](auto bytes) { budgets::read_budget(file_of("budget.yaml", bytes)); }},
        {"sweep", "a sweep file", read_sweep},
        {"journal", "a sweep's journal",
         [](auto bytes) { sweeps::read_journal<sweeps::PointResult>(file_of("journal", bytes)); }},
        {"manifest", "a sweep's sweep.json",
         [](auto bytes) { sweeps::manifest_from_text(std::string(bytes), "sweep.json"); }},
        {"trace", "files of a trace, with lines of %% between them", read_stimulus},
        {"depth_png", "a depth image",
         [](auto bytes) {
             workload::load_depth_image(file_of("depth.png", bytes), 0.001, Camera{64, 48, 57, 57, 32, 24}, 1);
         }},
        {"edges_png", "an image of 8 bits", [](auto bytes) { files::read_png8(file_of("edges.png", bytes)); }},
        {"run_folder", "files of a run, with lines of %% between them", read_run_folder},
        {"poses", "results in the format of BOP",
         [](auto bytes) {
             std::vector<std::string> warnings;
             bop::read_pose_results(file_of("p.csv", bytes), warnings);
         }},
        {"pose_list", "a table of poses", [](auto bytes) { workload::read_pose_list(file_of("l.csv", bytes)); }},
        {"detections", "detections in the format of BOP",
         [](auto bytes) {
             std::vector<std::string> warnings;
             bop::read_detections(file_of("d.json", bytes), warnings);
         }},
        {"bop_folder", "files of a dataset, with lines of %% between them", read_bop_folder},
        {"obj", "a mesh", read_mesh<0>},
        {"ply", "a mesh", read_mesh<1>},
        {"stl", "a mesh", read_mesh<2>},
        {"off", "a mesh", read_mesh<3>},
        {"events", "changes of an event file", run_events},
        {"engine", "the seed of a machine and a trace", run_engine},
    };
    return all;
}

Target const* find_target(std::string_view name) {
    auto const found =
        std::find_if(targets().begin(), targets().end(), [&](Target const& target) { return name == target.name; });
    return found == targets().end() ? nullptr : &*found;
}

void feed(Target const& target, std::string_view bytes) {
    try {
        target.run(bytes);
    } catch (InputError const&) {  // as it should be
    }
}

}  // namespace faster::fuzz
