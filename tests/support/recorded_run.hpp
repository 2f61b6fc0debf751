#pragma once
#include <catch2/catch.hpp>

#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/tools/sizing/size_fifos.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/random_stimulus.hpp"
#include "support/raster_machine.hpp"
#include "support/temp_folder.hpp"
#include "support/test_run.hpp"

namespace faster::testing {

/// A run whose FIFOs can be sized.
struct RecordedRun {
    Stimulus stimulus;
    AcceleratorConfig config;  ///< as it was recorded
    events::EventFile file;
    Machine machine;

    RecordedRun(Stimulus of, AcceleratorConfig const& on) : stimulus(std::move(of)) {
        test::TempFolder const folder;
        TestRunOptions options;
        options.events = folder / "events";
        REQUIRE_FALSE(test_run(on, stimulus, Engine::decoupled, options).statistics.deadlocked());
        file = events::read_event_file(folder / "events");
        config = accelerator_of(file.loaded.config);
        machine = raster_machine(config);
    }

    Cycles cycles(sizing::Choice const& choice) const { return cycles_on(machine, choice); }
    Cycles cycles_on(Machine const& on, sizing::Choice const& choice) const {
        RunStatistics const run = replay::retime(file.run, sizing::with_choice(on, choice));
        return run.deadlocked() ? sizing::Cut::deadlock : run.total_cycles;
    }
};

/// Small, for its run is timed anew with every choice that is tried.
inline RandomStimulusOptions sizing_workload(int samples, int triangles) {
    RandomStimulusOptions workload;
    workload.width = {24, 48};
    workload.height = {24, 48};
    workload.window = {4, 12};
    workload.samples = {1, samples};
    workload.triangles = {0, triangles};
    return workload;
}

}  // namespace faster::testing
