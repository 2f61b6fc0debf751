#include "kernel/replay/sensitivities.hpp"

#include "kernel/config/config_sources.hpp"
#include "kernel/config/design.hpp"
#include "kernel/config/keys.hpp"
#include "kernel/replay/retime_many.hpp"

namespace faster::replay {

namespace {

/// The retimings to do, and where their results go.
struct Tasks {
    std::vector<Machine> machines;
    std::vector<SensitivityStep*> steps;
};

void add_step(LoadedConfig const& loaded, Key const& key, std::int64_t value, SensitivityStep& step, Tasks& tasks) {
    LoadedConfig changed = loaded;
    key.write(changed.config, KeyValue{value});
    step.valid = accepts(key.integers, value) && cross_check(changed).empty();
    if (!step.valid)
        return;
    tasks.machines.push_back(machine_of(changed.config));
    tasks.steps.push_back(&step);
}

}  // namespace

std::vector<Sensitivity> sensitivities(RecordedRun const& run, LoadedConfig const& loaded,
                                       std::function<void(std::size_t, std::size_t)> const& progress) {
    Keys const keys = timing_keys(loaded.config);
    std::vector<Sensitivity> rows(keys.size());
    Tasks tasks;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        rows[i].key = keys[i].name();
        rows[i].value = std::get<std::int64_t>(keys[i].read(loaded.config));
        add_step(loaded, keys[i], rows[i].value - 1, rows[i].down, tasks);
        add_step(loaded, keys[i], rows[i].value + 1, rows[i].up, tasks);
    }
    std::size_t done = 0;
    retime_many(run, tasks.machines, [&](std::size_t i, RunStatistics const& retimed) {
        tasks.steps[i]->deadlocks = retimed.deadlocked();
        tasks.steps[i]->total_cycles = retimed.deadlocked() ? 0 : retimed.total_cycles;
        if (progress)
            progress(++done, tasks.machines.size());
    });
    return rows;
}

}  // namespace faster::replay
