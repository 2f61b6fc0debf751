#pragma once
#include <map>
#include <string>
#include <vector>

#include "dataflow/run/config/load_config.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/bop/dataset.hpp"
#include "poses/bop/detections.hpp"
#include "poses/estimation/scene.hpp"
#include "poses/experiments/estimate_journal.hpp"
#include "poses/experiments/experiment_file.hpp"

namespace faster {

/// The scenes of a setting, and where its first stage saw their objects.
struct SettingData {
    std::string name;
    bop::Dataset dataset;
    std::map<std::pair<bop::ImageId, int>, std::vector<bop::Detection>> boxes;  ///< by image and obj_id

    std::vector<bop::Detection> const& boxes_of(bop::Target const& target) const;
};

/// A method with its configuration.
struct MethodData {
    std::string name;
    LoadedConfig loaded;
};

/// One estimate that an experiment wants.
struct WantedEstimate {
    SettingData const* setting = nullptr;
    MethodData const* method = nullptr;
    bop::Target target;
    std::vector<bop::Detection> boxes;  ///< that it looks into
    std::string id;                     ///< hash of all that decides about the result
};

/// Every method for every target; for one of several instances as often, each time in one of the best boxes. The first
/// images of all objects first, so that whatever is done by some time is about the same share of everything. Throws
/// InputError for a file that is not there.
std::vector<WantedEstimate> wanted_estimates(std::vector<SettingData> const& settings,
                                             std::vector<MethodData> const& methods);

/// Calls `take` with each estimate of a method in a setting that is there, and its result, in their order: that of the
/// rows of results_of().
template <class Take>
void for_each_result(std::vector<WantedEstimate> const& wanted, experiments::EstimateJournal const& journal,
                     SettingData const& setting, MethodData const& method, Take take) {
    for (WantedEstimate const& each : wanted)
        if (each.setting == &setting && each.method == &method)
            if (experiments::EstimateResult const* const result = journal.find(each.id))
                take(each, *result);
}

/// What one looks at.
estimation::Scene scene_of(WantedEstimate const& wanted);

/// Does one, on this thread.
experiments::EstimateResult estimated(WantedEstimate const& wanted);

}  // namespace faster
