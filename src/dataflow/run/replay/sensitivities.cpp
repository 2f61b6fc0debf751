#include "dataflow/run/replay/sensitivities.hpp"

#include <algorithm>
#include <utility>

#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/replay/retime_many.hpp"

namespace dataflow::replay {

namespace {

/// The retimings to do, and where their results go.
struct Tasks {
    std::vector<Machine> machines;
    std::vector<SensitivityStep*> steps;
};

void add_step(RecordedRun const& run, LoadedConfig const& loaded, Key const& key, std::int64_t value,
              SensitivityStep& step, Tasks& tasks) {
    LoadedConfig changed = loaded;
    key.write(changed.config, KeyValue{value});
    if (!accepts(key.integers, value) || !cross_check(changed).empty())
        return;
    Machine machine = machine_of(changed.config);
    step.valid = allows_run_on(machine, run);
    if (!step.valid)
        return;
    tasks.machines.push_back(std::move(machine));
    tasks.steps.push_back(&step);
}

bool are_alike(MachineFifo const& one, MachineFifo const& other) {
    return one.capacity() == other.capacity() && one.kind == other.kind;
}

/// As far as such a choice goes: FIFOs.
bool are_alike(Machine const& one, Machine const& other) {
    std::vector<std::size_t> const fifos = fifos_of(one);
    return std::all_of(fifos.begin(), fifos.end(),
                       [&](std::size_t i) { return are_alike(one.fifos[i], other.fifos[i]); });
}

void note(std::optional<RunStatistics> const& retimed, SensitivityStep& step) {
    step.needs_run = !retimed;
    step.deadlocks = retimed && retimed->deadlocked();
    step.total_cycles = retimed && !step.deadlocks ? retimed->total_cycles : 0;
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
        add_step(run, loaded, keys[i], rows[i].value - 1, rows[i].down, tasks);
        add_step(run, loaded, keys[i], rows[i].value + 1, rows[i].up, tasks);
    }
    std::size_t done = 0;
    retime_many(run, tasks.machines, [&](std::size_t i, std::optional<RunStatistics> const& retimed) {
        note(retimed, *tasks.steps[i]);
        if (progress)
            progress(++done, tasks.machines.size());
    });
    return rows;
}

std::vector<Alternative> alternatives(RecordedRun const& run, LoadedConfig const& loaded) {
    Machine const machine = machine_of(loaded.config);
    std::vector<Alternative> rows;
    std::vector<Machine> machines;
    for (Key const& key : all_keys())
        for (std::string const& other : key.is_alternative ? key.choices : std::vector<std::string>{}) {
            RunConfig changed = loaded.config;
            key.write(changed, KeyValue{other});
            Machine changed_machine = machine_of(changed);
            if (are_alike(machine, changed_machine))
                continue;
            machines.push_back(std::move(changed_machine));
            rows.push_back({key.name(), std::get<std::string>(key.read(loaded.config)), other, {true}});
        }
    retime_many(run, machines,
                [&](std::size_t i, std::optional<RunStatistics> const& retimed) { note(retimed, rows[i].step); });
    return rows;
}

}  // namespace dataflow::replay
