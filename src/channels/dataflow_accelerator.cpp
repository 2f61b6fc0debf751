#include "channels/dataflow_accelerator.hpp"

#include <exception>
#include <optional>
#include <string>
#include <utility>

#include "channels/own_stack.hpp"
#include "dataflow/base/as_mistake.hpp"
#include "dataflow/base/input_error.hpp"

namespace dataflow {

DataflowAccelerator::DataflowAccelerator(sc_core::sc_module_name const& name, std::shared_ptr<Machine const> machine,
                                         std::size_t samples, Engine engine, MakeCore const& make_core)
    : sc_module(name), machine_(std::move(machine)), engine_(makes_attempts(*machine_) ? Engine::lockstep : engine) {
    TimeBase const time_base{engine_, machine_->clock_mhz};
    end_ = machine_->cores;
    for (std::size_t core = 0; core < machine_->cores; ++core) {
        std::string const core_name = "core_" + std::to_string(core);
        CoreShare const share = share_of(core, machine_->cores, samples);
        cores_.push_back(make_core(core_name.c_str(), machine_, share, time_base));
        if (engine_ == Engine::lockstep)
            cores_.back()->timing().keep_logs();
    }
    if (machine_->external_memory)
        join_by_memory(*machine_->external_memory);
    else if (engine_ == Engine::decoupled)
        let_cores_take_turns();
}

void DataflowAccelerator::join_by_memory(timing::ExternalMemory const& shape) {
    memory_ = std::make_unique<timing::MemorySystem>(shape, masters_of(*machine_));
    for (std::size_t core = 0; core < cores_.size(); ++core) {
        memory_->add_core(cores_[core]->timing(), cores_[core]->share().count > 0);
        cores_[core]->use_memory(memory_.get(), core, &memory_asked_);
    }
    if (engine_ == Engine::decoupled) {
        let_cores_share_answers();
        return;
    }
    SC_THREAD(serve_memory);
}

/// What is asked for in a cycle is known before that cycle is over, and nothing depends on its answer before the next.
void DataflowAccelerator::serve_memory() {
    std::uint64_t const ticks = TimeBase{engine_, machine_->clock_mhz}.ticks_per_cycle();
    for (;;) {
        for (timing::MemorySystem::Target const& target : memory_->follow())
            wake(target);
        std::optional<Cycles> const ask = memory_->next_ask();
        if (!ask) {
            wait(memory_asked_);
            continue;
        }
        sc_dt::uint64 const due = *ask * ticks + ticks / 2;
        sc_dt::uint64 const now = sc_core::sc_time_stamp().value();
        if (due > now)
            wait(sc_core::sc_time::from_value(due - now), memory_asked_);
        else
            wake(memory_->serve_next());
    }
}

void DataflowAccelerator::wake(timing::MemorySystem::Target const& target) {
    cores_[target.core]->memory_event(target.process).notify(sc_core::SC_ZERO_TIME);
}

/// They are all alike, so what is known of one core's timing serves all of them.
void DataflowAccelerator::let_cores_share_answers() {
    std::shared_ptr<timing::Answers> const answers = timing::make_answers();
    for (std::unique_ptr<DataflowCore> const& core : cores_)
        core->timing().let_follow(machine_->lead, answers);
}

void DataflowAccelerator::let_cores_take_turns() {
    let_cores_share_answers();
    for (std::size_t core = 1; core < cores_.size(); ++core)
        cores_[core]->run_after(cores_[core - 1].get());
}

/// A core whose turn comes after its own never begins.
void DataflowAccelerator::limit_to(std::size_t first, std::size_t end) {
    first_ = first;
    end_ = end;
    for (std::size_t core : {std::size_t{0}, end})
        if (core < cores_.size())
            cores_[core]->run_after(cores_[core].get());
    cores_[first]->run_after(nullptr);
}

/// What the SystemC kernel complains of is a mistake of the design: a port that is not bound.
void DataflowAccelerator::start() {
    try {
        sc_core::sc_start();
        if (sc_core::sc_get_status() == sc_core::SC_STOPPED)
            throw InputError("a module has called sc_stop(), expected a run to end when all have done their samples");
    } catch (sc_core::sc_report const& report) {
        throw InputError(std::string("SystemC: ") + report.get_msg_type() + ": " + report.get_msg() +
                         ", expected a design that it can run");
    } catch (...) {
        std::rethrow_exception(thrown_by("a module, outside of work(),", "it to return"));
    }
}

/// A core that is stuck before it has done its share does not keep the next ones from theirs. Somebody may pause it
/// all.
void DataflowAccelerator::run() {
    start();
    for (std::size_t next = first_ + 1; engine_ == Engine::decoupled && !is_left_ && next < end_; ++next) {
        if (cores_[next]->share().count == 0 || cores_[next - 1]->is_turn_over())
            continue;
        cores_[next - 1]->end_turn();
        start();
    }
    back_on_own_stack();
}

}  // namespace dataflow
