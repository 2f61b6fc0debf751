#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace faster::test {

/// A small workspace with sweep.yaml: 24 points of four functions; 8 deadlock, the first of each function among them.
class SweepWorkspace {
  public:
    SweepWorkspace() {
        folder().write("config.yaml",
                       "accelerator: {raster_cores: 2, window: 60}\n"
                       "workload:\n"
                       "  object: tomato_soup_can\n"
                       "  max_triangles: 300\n"
                       "  pose: {translation_m: [0, 0, 0.65], rotation_deg: [120, 0, 0]}\n"
                       "  scene: {downscale: 4}\n");
        folder().write("plain.yaml", "accelerator: {}\n");
        folder().write("quick.yaml", "accelerator: {inlier_unit: {neighbour_access: window}}\n");
        folder().write(
            "sweep.yaml",
            head() +
                "  - {overlay: design, files: [plain.yaml, quick.yaml]}\n"
                "  - {zip: {workload.samples.count: [1, 3], accelerator.architecture: [faster, inner_border]}}\n"
                "  - {key: accelerator.fifos.fragment_depth.depth, values: [1, 2, 8]}\n"
                "  - {key: accelerator.raster_cores, values: [1, 2]}\n");
    }
    static std::string head() {
        return "format: faster-sweep\nversion: 1\nbase: config.yaml\nset: {accelerator.window: 40}\ndimensions:\n";
    }

    CommandResult tool(std::vector<std::string> const& words) const {
        return run_command(FASTER_SIM_BINARY, words, folder().path());
    }
    CommandResult sweep(std::string const& out, std::vector<std::string> const& more = {}) const {
        std::vector<std::string> words{"sweep", "sweep.yaml", "--out", out};
        words.insert(words.end(), more.begin(), more.end());
        return tool(words);
    }
    TempFolder const& folder() const { return small_.folder(); }
    std::string text(std::string const& name) const { return small_.text(name); }
    nlohmann::ordered_json summary(std::string const& run) const { return small_.summary(run); }
    bool has(std::string const& name) const { return std::filesystem::exists(folder() / name); }

  private:
    SmallWorkspace small_;
};

}  // namespace faster::test
