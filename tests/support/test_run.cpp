#include "support/test_run.hpp"

#include <algorithm>
#include <utility>

#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/replay/sensitivities.hpp"
#include "dataflow/tools/report/summary.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/fresh_kernel.hpp"
#include "support/shared_out.hpp"

namespace faster::testing {

namespace {

/// Keeps the maps of every sample.
class MapCollector : public SampleProbe {
  public:
    MapCollector(std::size_t samples, int window) : maps_(samples), window_(window) {}

    void edge_maps_done(std::size_t sample, EdgeMapView const& maps) override {
        maps_[sample].edge_map = picture(maps.edge);
        maps_[sample].object_map = picture(maps.object);
    }
    void depth_buffer_done(std::size_t sample, std::vector<std::uint16_t> const& depth_buffer) override {
        maps_[sample].depth_buffer = Image<std::uint16_t>(window_, window_);
        maps_[sample].depth_buffer.pixels() = depth_buffer;
    }

    std::vector<SampleMaps> take() { return std::move(maps_); }

  private:
    Image<std::uint8_t> picture(std::uint8_t const* map) const {
        Image<std::uint8_t> image(window_, window_);
        std::copy_n(map, image.pixels().size(), image.pixels().begin());
        return image;
    }

    std::vector<SampleMaps> maps_;
    int window_;
};

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
    MapCollector collector(wanted.with_maps ? stimulus.samples.size() : 0, stimulus.window);
    SimulationOptions options = shared_out(stimulus.samples.size());
    options.figures_alone = options.figures_alone && !wanted.with_maps && wanted.probe == nullptr;
    options.critical_path = wanted.critical_path;
    options.hazards = wanted.hazards;
    options.trail_length = wanted.trail_length;
    options.recordings = wanted.recordings;
    replay::RecordedRun recorded;
    options.recorded = wanted.sensitivities || !wanted.events.empty() ? &recorded : nullptr;
    RunStatistics run = simulate(config, stimulus, engine, options, wanted.with_maps ? &collector : wanted.probe);
    if (wanted.sensitivities) {
        run.sensitivities = replay::sensitivities(recorded, loaded_from(config));
        run.alternatives = replay::alternatives(recorded, loaded_from(config));
    }
    if (!wanted.events.empty() && !run.deadlocked())
        write_events(wanted.events, config, recorded, run);
    return {std::move(run), collector.take()};
}

}  // namespace faster::testing
