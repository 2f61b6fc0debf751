#include "support/forked_simulation.hpp"

#include <exception>
#include <stdexcept>
#include <string>

#include "channels/figure_fields.hpp"
#include "dataflow/base/byte_stream.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/replay/sensitivities.hpp"
#include "dataflow/tools/report/summary.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/forked_bytes.hpp"
#include "support/idle_run.hpp"
#include "support/raster_machine.hpp"

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

    std::vector<SampleMaps> const& maps() const { return maps_; }

  private:
    Image<std::uint8_t> picture(std::uint8_t const* map) const {
        Image<std::uint8_t> image(window_, window_);
        std::copy_n(map, image.pixels().size(), image.pixels().begin());
        return image;
    }

    std::vector<SampleMaps> maps_;
    int window_;
};

template <class Visit, class Row> void visit_stuck(Visit visit, Row& row) {
    visit(row.core, row.process, row.position, row.fifo, row.to_write, row.occupancy, row.capacity, row.since_cycle,
          row.waits_for, row.source);
}

template <class Visit, class Row> void visit_path(Visit visit, Row& row) {
    visit(row.module, row.loop, row.cause, row.fifo, row.bram, row.cycles, row.crossings);
}

template <class Visit, class Row> void visit_sensitivity(Visit visit, Row& row) {
    visit(row.key, row.value);
    for (auto* step : {&row.down, &row.up})
        visit(step->valid, step->deadlocks, step->total_cycles);
}

template <class Visit, class Row> void visit_alternative(Visit visit, Row& row) {
    visit(row.key, row.value, row.other, row.step.valid, row.step.deadlocks, row.step.total_cycles);
}

template <class Visit, class Memory> void visit_memory(Visit visit, Memory& memory) {
    for (auto& row : memory.masters)
        visit(row.core, row.master, row.port, row.bursts, row.bytes, row.latency_least, row.latency_median,
              row.latency_90, row.latency_most);
    visit(memory.port_beats, memory.controller_busy_ps, memory.largest_queue, memory.period_ps);
}

std::string to_bytes(RunStatistics const& run, std::vector<SampleMaps> const& maps) {
    ValueWriter writer;
    auto const put = [&writer](auto const&... values) { writer.put(values...); };
    CriticalPath const path = run.critical_path.value_or(CriticalPath{});
    MemoryTraffic const memory = run.memory.value_or(MemoryTraffic{});
    put(std::string{}, run.total_cycles, run.load_cycles, run.memory.has_value(), memory.masters.size(),
        run.critical_path.has_value(), path.core, run.samples.size(), run.cores.size(), run.stuck.size(),
        path.rows.size(), run.sensitivities.size(), run.alternatives.size(),
        run.cores.empty() ? std::size_t{0} : run.cores.front().dependences.size(), maps.size());
    for (auto const& row : run.samples)
        visit_sample(put, row);
    for (auto const& row : run.cores)
        visit_core(put, row);
    for (auto const& row : run.stuck)
        visit_stuck(put, row);
    for (auto const& row : path.rows)
        visit_path(put, row);
    for (auto const& row : run.sensitivities)
        visit_sensitivity(put, row);
    for (auto const& row : run.alternatives)
        visit_alternative(put, row);
    visit_memory(put, memory);
    for (auto const& row : maps)
        put(row.edge_map.pixels(), row.object_map.pixels(), row.depth_buffer.pixels());
    return writer.bytes();
}

template <class Pixel> void get_image(ValueReader& reader, int window, Image<Pixel>& image) {
    std::vector<Pixel> pixels;
    reader.get(pixels);
    if (pixels.empty())
        return;
    image = Image<Pixel>(window, window);
    image.pixels() = std::move(pixels);
}

ForkedRun from_bytes(std::string bytes, Machine const& machine, int window) {
    ValueReader reader(std::move(bytes));
    auto const get = [&reader](auto&... values) { reader.get(values...); };
    std::string error;
    get(error);
    if (!error.empty())
        throw std::runtime_error("simulate: " + error);
    ForkedRun run;
    run.statistics.machine = machine;
    bool has_path = false;
    CriticalPath path;
    bool has_memory = false;
    MemoryTraffic memory;
    get(run.statistics.total_cycles, run.statistics.load_cycles, has_memory);
    memory.masters.resize(reader.get_size());
    get(has_path, path.core);
    run.statistics.samples.resize(reader.get_size());
    run.statistics.cores.resize(reader.get_size(), idle_core(machine));
    run.statistics.stuck.resize(reader.get_size());
    path.rows.resize(reader.get_size());
    run.statistics.sensitivities.resize(reader.get_size());
    run.statistics.alternatives.resize(reader.get_size());
    std::size_t const dependences = reader.get_size();
    for (CoreStatistics& core : run.statistics.cores)
        core.dependences.resize(dependences);
    run.maps.resize(reader.get_size());
    for (auto& row : run.statistics.samples)
        visit_sample(get, row);
    for (auto& row : run.statistics.cores)
        visit_core(get, row);
    for (auto& row : run.statistics.stuck)
        visit_stuck(get, row);
    for (auto& row : path.rows)
        visit_path(get, row);
    for (auto& row : run.statistics.sensitivities)
        visit_sensitivity(get, row);
    for (auto& row : run.statistics.alternatives)
        visit_alternative(get, row);
    visit_memory(get, memory);
    if (has_memory)
        run.statistics.memory = std::move(memory);
    if (has_path)
        run.statistics.critical_path = path;
    for (auto& row : run.maps) {
        get_image(reader, window, row.edge_map);
        get_image(reader, window, row.object_map);
        get_image(reader, window, row.depth_buffer);
    }
    return run;
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

std::string simulated_bytes(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine,
                            ForkOptions const& wanted) {
    try {
        MapCollector collector(wanted.with_maps ? stimulus.samples.size() : 0, stimulus.window);
        SimulationOptions options;
        options.jobs = 1 + stimulus.samples.size() % 3;  // how a run is shared between host cores makes no difference
        options.figures_alone = stimulus.samples.size() % 4 < 2 && !wanted.with_maps && wanted.probe == nullptr;
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
        return to_bytes(run, collector.maps());
    } catch (std::exception const& error) {
        ValueWriter writer;
        writer.put(std::string("threw: ") + error.what());
        return writer.bytes();
    }
}

}  // namespace

ForkedRun run_forked(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine,
                     ForkOptions const& options) {
    std::string bytes = forked_bytes([&] { return simulated_bytes(config, stimulus, engine, options); });
    return from_bytes(std::move(bytes), raster_machine(config), stimulus.window);
}

}  // namespace faster::testing
