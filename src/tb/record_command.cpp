#include <memory>
#include <string>
#include <vector>

#include "faster/faster_config.hpp"
#include "kernel/config/load_config.hpp"
#include "tb/commands.hpp"
#include "tb/workload_source.hpp"
#include "tool/command_paths.hpp"
#include "tool/exit_codes.hpp"
#include "tool/options.hpp"
#include "tool/say.hpp"
#include "workload/files/trace.hpp"

namespace faster {

namespace {

/// `record`.
struct RecordRequest {
    std::string config;
    std::vector<std::string> overrides;
    std::string out;
};

/// Returns the exit code; throws InputError on bad input.
int record(RecordRequest const& request) {
    LoadedConfig loaded = load_config(request.config, request.overrides);
    CommandPaths paths;
    paths.reads(request.config);
    paths.reads(loaded.config);
    paths.writes("--out", request.out, io::trace_kind());
    Stimulus const posed = load_stimulus(loaded);
    say_warnings(stimulus_warnings(posed, workload_of(loaded.config)));
    Stimulus const stimulus = with_explicit_triangles(posed);
    io::write_trace(stimulus, request.out);
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
            return [request] { return record(*request); };
        }};
}

}  // namespace faster
