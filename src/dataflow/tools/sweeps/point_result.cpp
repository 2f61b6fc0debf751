#include "dataflow/tools/sweeps/point_result.hpp"

#include <algorithm>

#include "dataflow/base/enumerators.hpp"
#include "dataflow/base/json.hpp"
#include "dataflow/tools/resources/machine_resources.hpp"

namespace dataflow::sweeps {

namespace {

using Status = PointResult::Status;

/// "reader -> filter -> reader": each waits for the next.
std::string circle_of(RunStatistics const& run) {
    std::vector<StuckProcess> const circle = run.wait_cycle();
    if (circle.empty())
        return run.stuck.front().process + " waits for " + run.stuck.front().waits_for;
    std::string text;
    for (StuckProcess const& process : circle)
        text += process.process + " (" + process.fifo + ") -> ";
    return text + circle.front().process;
}

Status status_from_name(std::string const& name) {
    for (std::size_t i = 0; i < enum_size<Status>(); ++i)
        if (name == enumerator_names<Status>[i])
            return static_cast<Status>(i);
    throw Json::other_error::create(501, "unknown status", static_cast<Json const*>(nullptr));
}

/// Of all cores.
void set_resources(Machine const& machine, PointResult& result) {
    Resources const cores = resources_of(machine).cores.amount;
    result.ramb36 = cores.ramb36;
    result.lut = cores.lut;
    result.ff = cores.ff;
    result.dsp = cores.dsp;
}

/// What modules and FIFOs waited.
void add_up_waits(RunStatistics const& run, PointResult& result) {
    for (std::size_t i = 0; i < run.machine.processes.size(); ++i) {
        ProcessStatistics const process = process_sum(run, i);
        result.stall_cycles += process[CycleClass::empty_stall] + process[CycleClass::full_stall];
        result.port_conflict_cycles += process[CycleClass::port_conflict];
    }
    for (CoreStatistics const& core : run.cores)
        for (FifoStatistics const& fifo : core.fifos) {
            result.fifo_full_stall_cycles += fifo.full_stall_cycles;
            result.fifo_empty_stall_cycles += fifo.empty_stall_cycles;
        }
}

std::string one_line(std::string text) {
    while (!text.empty() && text.back() == '\n')
        text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

}  // namespace

bool PointResult::operator==(PointResult const& other) const { return to_json(*this) == to_json(other); }

PointResult result_of(RunStatistics const& run) {
    PointResult result;
    set_resources(run.machine, result);
    if (run.deadlocked()) {
        result.status = Status::deadlock;
        result.message = circle_of(run);
        return result;
    }
    if (std::string const left = leftover_tokens(run); !left.empty())
        return failed("tokens are left at the end of the run: " + left);
    result.status = Status::done;
    result.total_cycles = run.total_cycles;
    result.milliseconds = run.machine.milliseconds(run.total_cycles);
    add_up_waits(run, result);
    return result;
}

PointResult failed(std::string const& message) {
    PointResult result;
    result.message = one_line(message);
    return result;
}

Json to_json(PointResult const& result) {
    Json json{{"status", enumerator_name(result.status)}, {"message", result.message}};
    for (ResultFigure const& figure : result_figures)
        std::visit([&](auto const member) { json[figure.name] = result.*member; }, figure.member);
    return json;
}

void from_json(Json const& json, PointResult& result) {
    result.status = status_from_name(json.at("status").get<std::string>());
    json.at("message").get_to(result.message);
    for (ResultFigure const& figure : result_figures)
        std::visit([&](auto const member) { json.at(figure.name).get_to(result.*member); }, figure.member);
}

}  // namespace dataflow::sweeps
