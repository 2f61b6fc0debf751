#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/temp_folder.hpp"

namespace faster::test {

/// A folder with config.yaml: three samples on two cores.
class SmallWorkspace {
  public:
    SmallWorkspace() {
        folder_.write("config.yaml",
                      "accelerator: {raster_cores: 2, window: 60}\n"
                      "workload:\n"
                      "  object: tomato_soup_can\n"
                      "  pose: {translation_m: [0, 0, 0.65], rotation_deg: [120, 0, 0]}\n"
                      "  samples: {count: 3}\n");
    }

    CommandResult run(std::vector<std::string> const& arguments) const {
        std::vector<std::string> words{"run", "config.yaml"};
        words.insert(words.end(), arguments.begin(), arguments.end());
        return run_command(FASTER_SIM_BINARY, words, folder_.path());
    }
    TempFolder const& folder() const { return folder_; }
    std::string text(std::string const& name) const { return content_of(folder_ / name); }
    /// summary.json of a run's folder
    nlohmann::ordered_json summary(std::string const& run) const {
        return nlohmann::ordered_json::parse(text(run + "/summary.json"));
    }
    std::size_t files_in(std::string const& run) const { return entries_in(folder_ / run); }

  private:
    TempFolder folder_;
};

}  // namespace faster::test
