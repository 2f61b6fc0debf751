#include "dataflow/tools/explore/exploration.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/plain_text.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/config/run_config.hpp"
#include "dataflow/run/events/retimed_config.hpp"
#include "dataflow/run/figures/table_rows.hpp"
#include "dataflow/run/replay/outcomes.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/run/replay/sensitivities.hpp"
#include "dataflow/tools/explore/replayed_timeline.hpp"
#include "dataflow/tools/report/critical_path_report.hpp"
#include "dataflow/tools/report/diagnosis_text.hpp"
#include "dataflow/tools/report/html/deadlock_html.hpp"
#include "dataflow/tools/report/html/graph_data.hpp"
#include "dataflow/tools/report/html/run_data.hpp"
#include "dataflow/tools/report/html/timeline_data.hpp"
#include "dataflow/tools/report/json_rows.hpp"
#include "dataflow/tools/report/sensitivity_report.hpp"
#include "dataflow/tools/report/summary.hpp"
#include "dataflow/tools/sizing/cheapest_choice.hpp"
#include "dataflow/tools/sizing/sizing_files.hpp"

namespace dataflow::explore {

namespace {

/// "read (-1, 0)": rows down, columns to the right of the pixel that the iteration works on.
std::string text_of(BankPartition::Access const& access) {
    return fmt::format("{} ({}, {})", access.writes ? "write" : "read", access.at.row, access.at.col);
}

/// Of all cores that share the memory: one port after the other, then the next cycle.
Json slots(MachineMemory const& memory, std::vector<BankPartition::Access> const& accesses) {
    Json cycles = Json::array();
    std::size_t dealt = 0;
    for (std::uint64_t sharer = 0; sharer < memory.sharers; ++sharer)
        for (BankPartition::Access const& access : accesses) {
            if (dealt++ % memory.ports == 0)
                cycles.push_back(Json::array());
            cycles.back().push_back(text_of(access));
        }
    return cycles;
}

Json memory_schedule(MachineMemory const& memory, AccessPattern const& pattern) {
    return {{"bram", memory.name},
            {"banks", memory.partition.banks()},
            {"ports", memory.ports},
            {"sharers", memory.sharers},
            {"accesses", pattern.accesses()},
            {"cycles", slots(memory, memory.partition.fullest_bank(pattern))}};
}

/// Of those that a loop may take: the one with which the fullest bank has most to do; null if none accesses the memory.
AccessPattern const* largest_branch(MachineMemory const& memory, LoopDescription const& loop) {
    AccessPattern const* largest = nullptr;
    for (MemoryAccess const& access : loop.accesses)
        if (access.memory == memory.name && access.pattern.accesses() > 0 &&
            (largest == nullptr ||
             memory.partition.accesses_per_bank(access.pattern) > memory.partition.accesses_per_bank(*largest)))
            largest = &access.pattern;
    return largest;
}

Json loop_schedule(Machine const& machine, std::size_t loop, LoopDescription const& description) {
    timing::InitiationInterval const& interval = machine.loops[loop].interval;
    Json memories = Json::array();
    for (MachineMemory const& memory : machine.memories)
        if (AccessPattern const* const branch = largest_branch(memory, description); memory.is_present && branch)
            memories.push_back(memory_schedule(memory, *branch));
    return {{"loop", machine.loop_name(loop)},   {"does", description.task},
            {"ii", interval.achieved},           {"target", interval.target},
            {"recurrence", interval.recurrence}, {"ports", interval.ports},
            {"limited_by", interval.limited_by}, {"memories", memories}};
}

/// Why the loops of a configuration have their initiation intervals: of each loop what the pragma, a dependence and the
/// ports demand, and of each memory it accesses the accesses of one iteration in the fullest bank, dealt out to its
/// ports, cycle by cycle.
Json loop_schedules(RunConfig const& config) {
    CoreDescription const core = design().core(config);
    Machine const machine = machine_of(config);
    Json rows = Json::array();
    std::size_t number = 0;
    for (ModuleDescription const& module : core.modules)
        for (LoopDescription const& loop : module.loops) {
            if (machine.loops[number].is_present)
                rows.push_back(loop_schedule(machine, number, loop));
            ++number;
        }
    return rows;
}

/// Without those of which a recording does not know enough.
std::vector<std::string> retimable_choices(Key const& key, RunConfig const& recorded) {
    if (key.kind == KeyKind::boolean)
        return {plain_text(true), plain_text(false)};
    std::vector<std::string> choices = key.choices;
    auto const is_unknown = [&](std::string const& choice) {
        RunConfig changed = recorded;
        key.write(changed, choice);
        return decides_waits(key, changed);
    };
    choices.erase(std::remove_if(choices.begin(), choices.end(), is_unknown), choices.end());
    return choices;
}

/// No bound is null: JSON has no infinity.
Json range_json(Key const& key, RunConfig const& recorded) {
    if (key.kind == KeyKind::integer)
        return {{"min", key.integers.min}, {"max", key.integers.max}};
    if (key.kind == KeyKind::number)
        return {{"min", std::isfinite(key.numbers.min) ? Json(key.numbers.min) : Json()},
                {"max", std::isfinite(key.numbers.max) ? Json(key.numbers.max) : Json()}};
    return {{"choices", retimable_choices(key, recorded)}};
}

char const* kind_of(Key const& key) {
    return key.kind == KeyKind::integer ? "integer" : key.kind == KeyKind::number ? "number" : "choice";
}

/// The keys with which a recorded run may be retimed: what they mean, what they accept, and their values.
Json keys_json(RunConfig const& recorded) {
    RunConfig const defaults;
    Json rows = Json::array();
    for (Key const& key : retimable_keys(recorded)) {
        rows.push_back({{"key", key.name()},
                        {"kind", kind_of(key)},
                        {"value", plain_text(key.read(recorded))},
                        {"default", plain_text(key.read(defaults))},
                        {"unit", key.text.unit},
                        {"meaning", key.text.meaning},
                        {"source", key.text.source},
                        {"accepts", expectation(key)}});
        rows.back().update(range_json(key, recorded));
    }
    return rows;
}

Json primitives_json(Primitives const& primitives) {
    return {{"luts", primitives.luts},
            {"ramb36", static_cast<double>(primitives.ramb18) / 2},
            {"cost_luts", cost_of(primitives, {})}};
}

Json fifos_json(RunStatistics const& run) {
    sizing::Choice const choice = sizing::choice_of(run.machine);
    Json rows = Json::array();
    for (FifoRow const& row : over_cores(fifo_columns, fifo_rows(run))) {
        std::size_t const i = run.machine.fifo(row.fifo);
        rows.push_back(report::json_row(fifo_columns, row));
        rows.back().update(
            primitives_json(sizing::primitives_of(choice[i], sizing::freedom_of(run.machine.fifos[i]), {})));
    }
    return rows;
}

/// What FIFOs and memories of all cores cost, in LUTs, if a core's FIFOs cost so much.
double cost_of_cores(Machine const& machine, double cost_of_fifos) {
    double const of_memories = ramb36_of_core(machine) * CostWeights{}.luts_per_ramb36;
    return static_cast<double>(machine.cores) * (cost_of_fifos + of_memories);
}

/// What one core takes.
Json area_json(Machine const& machine) {
    Json area = primitives_json(sizing::sum_of(sizing::choice_of(machine), sizing::freedoms_of(machine), {}));
    area["memories_ramb36"] = ramb36_of_core(machine);
    area["cost_of_cores"] = cost_of_cores(machine, area["cost_luts"]);
    return area;
}

/// What the page shows of a retimed run, FIFOs and loops of all cores together. The page has the recorded machine's
/// classes of cycles.
Json figures_json(RunStatistics const& run, Machine const& recorded) {
    Json figures;
    figures["outcome"] = run.deadlocked() ? "deadlock" : "finished";
    figures["cores"] = run.machine.cores;
    figures["clock_mhz"] = run.machine.clock_mhz;
    figures["area"] = area_json(run.machine);
    figures["fifos"] = fifos_json(run);
    figures["brams"] = report::memory_data(run.machine);
    figures["loops"] = report::json_table(loop_columns, over_cores(loop_columns, loop_rows(run)));
    if (run.deadlocked()) {
        figures["deadlock"] = report::deadlock_data(run);
        return figures;
    }
    figures["total_cycles"] = run.total_cycles;
    figures["milliseconds"] = run.machine.milliseconds(run.total_cycles);
    figures["modules"] = report::module_data(run, recorded);
    figures["stalls"] = report::stall_data(run);
    figures["bound_by"] = report::diagnosis_sentences(run);
    return figures;
}

}  // namespace

Exploration::Exploration(std::string title, LoadedConfig recorded, replay::RecordedRun run, Require require,
                         RunAgain run_again)
    : title_(std::move(title)),
      recorded_(std::move(recorded)),
      run_(std::move(run)),
      require_(std::move(require)),
      run_again_(makes_attempts(machine_of(recorded_.config)) ? std::move(run_again) : RunAgain()),
      scripted_(run_) {}

RunConfig Exploration::changed(Overrides const& overrides) const {
    RunConfig config = events::retimed_config(recorded_, overrides).config;
    if (require_)
        require_(run_, machine_of(config));
    return config;
}

Json Exploration::design() const {
    Machine const machine = machine_of(recorded_.config);
    return {{"format", "faster-exploration"},
            {"samples", run_.tape.samples()},
            {"cores_are", machine.cores_are},
            {"remark", machine.remark},
            {"cycle_classes", report::cycle_class_data(machine)},
            {"path_causes", report::path_cause_data(machine)},
            {"graph", report::graph_data(machine)},
            {"keys", keys_json(recorded_.config)}};
}

std::shared_ptr<RunStatistics const> Exploration::retimed_run(Overrides const& overrides) {
    if (auto run = last_run_.find(overrides))
        return run;
    return last_run_.keep(std::make_shared<RunStatistics const>(
                              replay::retime(scripted_, machine_of(changed(overrides)), jobs_or_host_cores(0))),
                          overrides);
}

/// The one that answers for overrides that the recorded run cannot be retimed with, as a non-blocking access would find
/// something else. Null: this one answers.
std::shared_ptr<Exploration> Exploration::other_run(Overrides const& overrides) {
    if (!run_again_)
        return nullptr;
    if (auto other = last_other_.find(overrides))
        return other;
    try {
        retimed_run(overrides);
        return nullptr;
    } catch (replay::OutcomeDiffers const&) {
        events::EventFile file = run_again_(exported_yaml(changed(overrides)));
        return last_other_.keep(
            std::make_shared<Exploration>(title_, std::move(file.loaded), std::move(file.run), require_), overrides);
    }
}

Json Exploration::retimed(Overrides const& overrides) {
    if (auto const other = other_run(overrides)) {
        Json figures = other->retimed({});
        figures["run_again"] = true;
        return figures;
    }
    RunConfig const config = changed(overrides);
    Json figures = figures_json(*retimed_run(overrides), machine_of(recorded_.config));
    figures["schedules"] = loop_schedules(config);
    figures["yaml"] = exported_yaml(config);
    return figures;
}

Json Exploration::critical_path(Overrides const& overrides) {
    if (auto const other = other_run(overrides))
        return other->critical_path({});
    RunStatistics const run = replay::retime_with_path(scripted_, machine_of(changed(overrides)));
    return run.critical_path ? report::critical_path_json(run) : Json();
}

std::shared_ptr<Exploration::TimelineOf const> Exploration::timeline_of(Overrides const& overrides,
                                                                        std::size_t sample) {
    if (auto timeline = last_timeline_.find(overrides, sample))
        return timeline;
    Machine const machine = machine_of(changed(overrides));
    std::shared_ptr<RunStatistics const> const run = retimed_run(overrides);
    if (run->deadlocked())
        throw InputError("the run deadlocks, expected one that ends");
    return last_timeline_.keep(std::make_shared<TimelineOf const>(
                                   TimelineOf{machine, replayed_timeline(scripted_, machine, run->samples[sample])}),
                               overrides, sample);
}

Json Exploration::timeline(Overrides const& overrides, std::size_t sample, Cycles from, Cycles to) {
    if (sample >= run_.tape.samples())
        throw InputError(fmt::format("sample = {}, expected one below {}", sample, run_.tape.samples()));
    if (auto const other = other_run(overrides))
        return other->timeline({}, sample, from, to);
    std::shared_ptr<TimelineOf const> const all = timeline_of(overrides, sample);
    Cycles const end = to == 0 ? all->timeline.end : to;
    Json json = report::timeline_data(all->machine, cut(all->timeline, from, end));
    json["sample_begin"] = all->timeline.begin;
    json["sample_end"] = all->timeline.end;
    return json;
}

Job::Work Exploration::sensitivities(Overrides const& overrides) {
    if (auto const other = other_run(overrides))
        return [other, work = other->sensitivities({})](Job::Progress const& progress) { return work(progress); };
    changed(overrides);  // or there is no room for it
    LoadedConfig const loaded = events::retimed_config(recorded_, overrides);
    return [this, loaded](Job::Progress const& progress) {
        RunStatistics run = replay::retime(scripted_, machine_of(loaded.config));
        if (run.deadlocked())
            throw InputError("with these settings the run deadlocks, expected settings with which it ends");
        run.sensitivities = replay::sensitivities(run_, loaded, progress.tell);
        return Json{{"total_cycles", run.total_cycles}, {"sensitivities", report::sensitivities_json(run)}};
    };
}

Job::Work Exploration::sizing(Overrides const& overrides, double within_percent) {
    if (auto const other = other_run(overrides))
        return
            [other, work = other->sizing({}, within_percent)](Job::Progress const& progress) { return work(progress); };
    RunConfig const config = changed(overrides);
    sizing::require_sizable(machine_of(config));
    return [this, config, within_percent](Job::Progress const& progress) {
        sizing::SizingOptions options;
        options.within_percent = within_percent;
        options.jobs = static_cast<unsigned>(jobs_or_host_cores(0));
        options.before_retiming = progress.check;
        Json sizing = Json::parse(sizing::sizing_json(sizing::size_fifos(run_, config, options, progress.tell)));
        Machine const machine = machine_of(config);
        sizing["answer"]["cost_of_cores"] = cost_of_cores(machine, sizing["answer"]["cost_luts"]);
        for (Json& point : sizing["front"])
            point["cost_of_cores"] = cost_of_cores(machine, point["cost_luts"]);
        return sizing;
    };
}

}  // namespace dataflow::explore
