#include "faster/config/adopt_trace.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/key_faults.hpp"
#include "dataflow/run/config/keys.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {
namespace {

/// The keys a trace speaks about; others keep their values.
std::vector<std::string> const trace_keys{"accelerator.window",
                                          "accelerator.fraction_bits.vertex_xy",
                                          "accelerator.fraction_bits.vertex_z",
                                          "accelerator.fraction_bits.area_reciprocal",
                                          "accelerator.fraction_bits.fragment_depth",
                                          "accelerator.fraction_bits.depth_buffer",
                                          "workload.camera.width",
                                          "workload.camera.height",
                                          "workload.samples.count"};

/// Of what a trace replaces.
void refuse_overrides_of_workload(LoadedConfig const& loaded) {
    std::vector<std::string> complaints;
    for (auto const& [name, origin] : loaded.origins.all())
        if (origin.source == KeySource::command_line && name.rfind("workload.", 0) == 0 && name != "workload.trace" &&
            std::find(trace_keys.begin(), trace_keys.end(), name) == trace_keys.end())
            complaints.push_back(
                complaint(loaded, name, "none with " + with_value(loaded, "workload.trace") + ", which replaces it"));
    throw_first(complaints);
}

/// `source`: for messages
void adopt(std::vector<std::string> const& names, RunConfig const& of_source, std::string const& source,
           LoadedConfig& loaded) {
    std::vector<std::string> contradictions;
    for (std::string const& name : names) {
        Key const& key = *find_key(name);
        KeyValue const value = key.read(of_source);
        bool const is_demanded = loaded.origins.of(name).source == KeySource::command_line;
        if (is_demanded && json_text(key.read(loaded.config)) != json_text(value))
            contradictions.push_back(
                complaint(loaded, name, fmt::format("{}, as in the {}", json_text(value), source)));
    }
    throw_first(contradictions);
    for (std::string const& name : names) {
        Key const& key = *find_key(name);
        key.write(loaded.config, key.read(of_source));
        loaded.origins.record(name, {KeySource::trace, source});
    }
    throw_first(cross_check(loaded));
}

}  // namespace

void adopt_trace(LoadedConfig& loaded, int width, int height, int window, FractionBits const& fraction,
                 std::size_t samples) {
    refuse_overrides_of_workload(loaded);
    RunConfig of_trace;
    workload_of(of_trace).samples.count = samples;
    accelerator_of(of_trace).window = window;
    accelerator_of(of_trace).fraction_bits = fraction;
    workload_of(of_trace).camera.width = width;
    workload_of(of_trace).camera.height = height;
    adopt(trace_keys, of_trace, "trace", loaded);
}

std::string setting_of_trace(std::string const& trace, std::vector<std::string> const& settings) {
    std::string const key = "workload.trace=";
    auto const normal = [](std::string const& path) { return std::filesystem::path(path).lexically_normal(); };
    for (std::string const& setting : settings)
        if (setting.rfind(key, 0) == 0 && normal(setting.substr(key.size())) != normal(trace))
            throw InputError(fmt::format("--set {}: expected none with the trace {}, which replaces it",
                                         shortened(setting), shortened(trace)));
    return key + trace;
}

void adopt_poses(LoadedConfig& loaded, std::size_t count) {
    RunConfig of_poses;
    workload_of(of_poses).samples.count = count;
    adopt({"workload.samples.count"}, of_poses, "table of poses", loaded);
}

}  // namespace faster
