#include "channels/dataflow_accelerator.hpp"

#include <string>
#include <utility>

namespace faster {

DataflowAccelerator::DataflowAccelerator(sc_core::sc_module_name const& name, std::shared_ptr<Machine const> machine,
                                         std::size_t samples, Engine engine, MakeCore const& make_core)
    : sc_module(name), machine_(std::move(machine)), engine_(engine) {
    TimeBase const time_base{engine, machine_->clock_mhz};
    for (std::size_t core = 0; core < machine_->cores; ++core) {
        std::string const core_name = "core_" + std::to_string(core);
        CoreShare const share = share_of(core, machine_->cores, samples);
        cores_.push_back(make_core(core_name.c_str(), machine_, share, time_base));
    }
    if (engine == Engine::decoupled)
        let_cores_take_turns();
}

/// They are all alike, so what one automaton has learnt of a core's timing serves all of them.
void DataflowAccelerator::let_cores_take_turns() {
    auto const automaton = std::make_shared<timing::Automaton>();
    for (std::size_t core = 0; core < cores_.size(); ++core) {
        if (!machine_->lead.followers.empty())
            cores_[core]->timing().let_follow(machine_->lead, automaton);
        if (core > 0)
            cores_[core]->run_after(*cores_[core - 1]);
    }
}

/// A core that is stuck before it has done its share does not keep the next ones from theirs.
void DataflowAccelerator::run() {
    sc_core::sc_start();
    for (std::size_t next = 1; engine_ == Engine::decoupled && next < cores_.size(); ++next) {
        if (cores_[next]->share().count == 0 || cores_[next - 1]->is_turn_over())
            continue;
        cores_[next - 1]->end_turn();
        sc_core::sc_start();
    }
}

}  // namespace faster
