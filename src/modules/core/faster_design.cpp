#include "modules/core/faster_design.hpp"

#include <string_view>

#include "dataflow/run/config/config_sources.hpp"
#include "faster/config/clear_design.hpp"
#include "faster/config/faster_complaints.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/config/faster_keys.hpp"
#include "faster/config/faster_presets.hpp"
#include "faster/data/sample_counters.hpp"
#include "faster/workload/files/trace_manifest.hpp"
#include "faster/workload/object_mesh.hpp"
#include "modules/core/raster_core_description.hpp"

namespace faster {
namespace {

bool starts_with(std::string const& text, std::string_view start) { return text.compare(0, start.size(), start) == 0; }

/// The block RAM that a key `accelerator.brams.NAME.partition.*` splits; empty for any other key.
std::string memory_split_by(std::string const& key) {
    constexpr std::string_view section = "accelerator.brams.";
    std::size_t const end = key.find(".partition.");
    if (!starts_with(key, section) || end == std::string::npos)
        return {};
    return key.substr(section.size(), end - section.size());
}

/// Before anything is simulated: a sweep names a class that there is not before its first point.
void check_object(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    WorkloadConfig const& workload = workload_of(loaded.config);
    std::string const expected = workload::object_fault(workload.target.object);
    if (workload.trace.empty() && !expected.empty())
        complaints.push_back(complaint(loaded, "workload.object", expected));
}

}  // namespace

std::unique_ptr<DesignConfig> FasterDesign::default_config() const { return std::make_unique<FasterConfig>(); }

std::vector<Key> FasterDesign::keys() const { return faster_keys(describe_raster_core(AcceleratorConfig())); }

CoreDescription FasterDesign::core(RunConfig const& config) const {
    return describe_raster_core(accelerator_of(config));
}

std::vector<std::string> FasterDesign::complaints(LoadedConfig const& loaded) const {
    std::vector<std::string> complaints = faster_complaints(loaded);
    check_object(loaded, complaints);
    return complaints;
}

IdleKeys FasterDesign::idle_keys(RunConfig const& config) const {
    constexpr char const* flow = "accelerator.flow";
    IdleKeys idle;
    if (accelerator_of(config).flow == Flow::faster) {
        idle.add("accelerator.edge_extraction.", flow);
    } else {
        idle.add("accelerator.edge_map.", flow);
        idle.add("accelerator.inlier_unit.neighbour_access", flow);
        idle.add("accelerator.rasterizer.edge_tokens", flow);
    }
    return idle;
}

/// A loop that clears a word of every bank takes more or less of them.
bool FasterDesign::decides_function(std::string const& key, RunConfig const& config) const {
    std::string const memory = memory_split_by(key);
    return !memory.empty() && clearing_of(memory, accelerator_of(config)) == MapClearing::wide;
}

std::string FasterDesign::why_not_retimable(std::string const& key) const {
    if (key == "accelerator.memory.model")
        return "was ideal in the recorded run, of which nobody knows what it would fetch";
    if (starts_with(key, "accelerator.memory."))
        return "decides what is fetched, which was recorded";
    if (starts_with(key, "estimator.") || starts_with(key, "host."))
        return "is a key of estimate";
    if (starts_with(key, "workload."))
        return "is part of the workload, which was recorded";
    if (starts_with(key, "accelerator.rasterizer.") || key == "accelerator.inlier_unit.fragment_loop")
        return "decides which operations there are, not when";
    if (starts_with(key, "accelerator.brams."))
        return "decides how many iterations a wide clearing loop has";
    if (key == "accelerator.inlier_unit.hidden")
        return "decides what is counted";
    if (starts_with(key, "accelerator.inlier_unit.") || key == "accelerator.edge_map.clearing")
        return "decides which operations there are, not only when";
    return Design::why_not_retimable(key);
}

std::vector<Preset> const& FasterDesign::presets() const { return faster_presets(); }

std::vector<std::filesystem::path> FasterDesign::files_of(std::filesystem::path const& folder) const {
    std::filesystem::path const manifest = folder / files::TraceManifest::file_name;
    files::TraceManifest::Files const files = files::read_manifest(manifest).files;
    return {manifest, folder / files.samples, folder / files.triangles, folder / files.depth, folder / files.edges};
}

std::vector<ColumnFacts> const& FasterDesign::counters() const {
    static std::vector<ColumnFacts> const all(std::begin(sample_counters), std::end(sample_counters));
    return all;
}

std::size_t FasterDesign::counters_of_all() const { return faster::counters_of(false); }

std::size_t FasterDesign::counters_of(RunConfig const& config) const {
    return faster::counters_of(counts_hidden(accelerator_of(config).inlier_unit));
}

bool FasterDesign::leaves_out_of_loops_csv(std::string const& loop) const {
    return loop == "vertex_transform.vertex" || loop == "observation_reader.read";
}

}  // namespace faster

dataflow::Design const& dataflow::design() {
    static faster::FasterDesign const faster;
    return faster;
}
