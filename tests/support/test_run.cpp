#include "support/test_run.hpp"

#include <utility>

#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/replay/sensitivities.hpp"
#include "dataflow/tools/report/summary.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/kept_maps.hpp"
#include "support/fresh_kernel.hpp"
#include "support/shared_out.hpp"

namespace faster::testing {

namespace {

/// Of every sample; of those that the run did not get to, none.
std::vector<SampleMaps> maps_of(KeptMaps const& kept, std::size_t samples) {
    std::vector<SampleMaps> maps(samples);
    for (auto const& [sample, of_sample] : kept.all())
        maps[sample] = of_sample;
    return maps;
}

LoadedConfig loaded_from(AcceleratorConfig const& config) {
    LoadedConfig loaded;
    accelerator_of(loaded.config) = config;
    return loaded;
}

void write_events(std::filesystem::path const& file, AcceleratorConfig const& config,
                  replay::RecordedRun const& recorded, RunStatistics const& run) {
    RunConfig const whole = loaded_from(config).config;
    events::write_event_file(io::OutputFile(file), whole, recorded, run,
                             report::summary_json(resolved_keys(whole), run, {}));
}

}  // namespace

TestRun test_run(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine,
                 TestRunOptions const& wanted) {
    FreshKernel const kernel;
    KeptMaps maps;
    SimulationOptions options = shared_out(stimulus.samples.size());
    options.figures_alone = options.figures_alone && !wanted.with_maps && wanted.probe == nullptr;
    options.critical_path = wanted.critical_path;
    options.hazards = wanted.hazards;
    options.trail_length = wanted.trail_length;
    options.recordings = wanted.recordings;
    replay::RecordedRun recorded;
    options.recorded = wanted.sensitivities || !wanted.events.empty() ? &recorded : nullptr;
    RunStatistics run = simulate(config, stimulus, engine, options, wanted.with_maps ? &maps : wanted.probe);
    if (wanted.sensitivities) {
        run.sensitivities = replay::sensitivities(recorded, loaded_from(config));
        run.alternatives = replay::alternatives(recorded, loaded_from(config));
    }
    if (!wanted.events.empty() && !run.deadlocked())
        write_events(wanted.events, config, recorded, run);
    return {std::move(run), maps_of(maps, wanted.with_maps ? stimulus.samples.size() : 0)};
}

}  // namespace faster::testing
