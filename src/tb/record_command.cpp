#include <fmt/format.h>
#include <memory>
#include <string>
#include <vector>

#include "dataflow/commands/command_paths.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/trace.hpp"
#include "faster/workload/workload_source.hpp"
#include "modules/vertex_transform/explicit_triangles.hpp"
#include "tb/commands.hpp"

namespace faster {

namespace {

/// `record`.
struct RecordRequest {
    std::string config;
    std::vector<std::string> overrides;
    std::string out;
    bool force = false;  ///< however long it takes, whatever memory there is
};

/// All triangles are held, once as such and once as text.
WorkSize size_of(Stimulus const& stimulus) {
    constexpr double triangles_per_s = 2.5e6;
    constexpr double bytes_per_triangle = 85;
    double const triangles = stimulus.is_posed() ? static_cast<double>(stimulus.samples.size()) *
                                                       static_cast<double>(stimulus.posed.mesh.faces.size())
                                                 : static_cast<double>(stimulus.triangles.size());
    WorkSize size;
    size.command = "record";
    size.amount = fmt::format("{} samples, about {:.2g} triangles", stimulus.samples.size(), triangles);
    size.seconds = triangles / triangles_per_s;
    size.bytes = triangles * bytes_per_triangle;
    return size;
}

/// Returns the exit code; throws InputError on bad input.
int record(RecordRequest const& request) {
    LoadedConfig loaded = load_config(request.config, request.overrides);
    CommandPaths paths;
    paths.reads(request.config);
    paths.reads(loaded.config);
    paths.writes("--out", request.out, files::trace_kind());
    Stimulus const posed = load_stimulus(loaded);
    say_warnings(stimulus_warnings(posed, loaded));
    announce(size_of(posed), request.force);
    Stimulus const stimulus = with_explicit_triangles(posed);
    files::write_trace(stimulus, request.out);
    say("recorded {} samples, {} triangles: {}\n", stimulus.samples.size(), stimulus.triangles.size(), request.out);
    return exit_done;
}

}  // namespace

Subcommand record_command() {
    return {
        "record", "Write a configuration's workload as a stimulus trace", [](CLI::App& command) {
            auto const request = std::make_shared<RecordRequest>();
            command.add_option("config", request->config, "Configuration file (YAML)")->required()->type_name("CONFIG");
            command.add_option("--out", request->out, "Folder of the trace")->required()->type_name("DIR");
            add_overrides(command, request->overrides);
            add_force(command, request->force);
            return [request] { return record(*request); };
        }};
}

}  // namespace faster
