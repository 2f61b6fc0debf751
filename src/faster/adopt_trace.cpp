#include "faster/adopt_trace.hpp"

#include <fmt/format.h>

#include "faster/faster_config.hpp"
#include "kernel/config/config_sources.hpp"
#include "kernel/config/key_faults.hpp"
#include "kernel/config/keys.hpp"

namespace faster {
namespace {

/// The keys a trace speaks about; others keep their values.
constexpr char const* trace_keys[] = {"accelerator.window",
                                      "accelerator.fraction_bits.vertex_xy",
                                      "accelerator.fraction_bits.vertex_z",
                                      "accelerator.fraction_bits.area_reciprocal",
                                      "accelerator.fraction_bits.fragment_depth",
                                      "accelerator.fraction_bits.depth_buffer",
                                      "workload.camera.width",
                                      "workload.camera.height"};

}  // namespace

void adopt_trace(LoadedConfig& loaded, int width, int height, int window, FractionBits const& fraction) {
    RunConfig of_trace;
    accelerator_of(of_trace).window = window;
    accelerator_of(of_trace).fraction_bits = fraction;
    workload_of(of_trace).camera.width = width;
    workload_of(of_trace).camera.height = height;

    std::vector<std::string> contradictions;
    for (char const* const name : trace_keys) {
        Key const& key = *find_key(name);
        KeyValue const value = key.read(of_trace);
        bool const is_demanded = loaded.origins.of(name).source == KeySource::command_line;
        if (is_demanded && json_text(key.read(loaded.config)) != json_text(value)) {
            contradictions.push_back(complaint(loaded, name, fmt::format("{}, as in the trace", json_text(value))));
        }
    }
    throw_first(contradictions);
    for (char const* const name : trace_keys) {
        Key const& key = *find_key(name);
        key.write(loaded.config, key.read(of_trace));
        loaded.origins.record(name, {KeySource::trace, "trace"});
    }
    throw_first(cross_check(loaded));
}

}  // namespace faster
