#include "simulation/taping.hpp"

#include <utility>

#include "config/parts.hpp"

namespace faster {

Taping::Taping(Accelerator& accelerator, retiming::RecordedRun& run)
    : accelerator_(accelerator),
      run_(run),
      tapes_(accelerator.cores().size()),
      writer_(run, accelerator.cores().front()->parts(), accelerator.cores().front()->timing().processes().size()) {
    for (std::size_t core = 0; core < tapes_.size(); ++core) {
        accelerator.cores()[core]->on_start([this, core] { start(core); });
        accelerator.cores()[core]->on_process_begins(
            [this, core](ModuleId process) { begin_sample(core, index_of(process)); });
    }
}

void Taping::start(std::size_t core) {
    timing::CoreTiming& timing = accelerator_.cores()[core]->timing();
    tapes_[core].logs.resize(timing.processes().size());
    tapes_[core].begun.resize(timing.processes().size());
    for (std::size_t i = 0; i < timing.processes().size(); ++i)
        timing.process(i).add_tape(tapes_[core].logs[i]);
    if (core == 0)
        run_.blueprint = timing.blank_copy();
    taking_part_ = modules_of(accelerator_.cores()[core]->parts()).size();
}

void Taping::begin_sample(std::size_t core, std::size_t process) {
    if (tapes_[core].begun[process] > 0)
        end_sample(core, process);
    ++tapes_[core].begun[process];
}

void Taping::end_sample(std::size_t core, std::size_t process) {
    CoreTape& tape = tapes_[core];
    std::size_t const at = tape.begun[process] - 1 - tape.done;
    while (tape.open.size() <= at) {
        tape.open.emplace_back(tape.logs.size());
        tape.left.push_back(0);
    }
    timing::OperationLog& log = tape.logs[process];
    tape.open[at][process].assign(log.begin(), log.begin() + log.pending());
    log.clear();
    ++tape.left[at];
    for (; !tape.left.empty() && tape.left.front() == taking_part_; ++tape.done) {
        writer_.put(accelerator_.cores()[core]->share().first + tape.done, std::move(tape.open.front()));
        tape.open.pop_front();
        tape.left.pop_front();
    }
}

/// The blueprint's, from the first core that got there. A port that is accessed in loops only has none of its own worth
/// keeping.
void Taping::note_sites() {
    for (auto const& core : accelerator_.cores())
        for (timing::ProcessTiming const& process : core->timing().processes()) {
            timing::ProcessTiming& noted = run_.blueprint->process(process.index());
            for (unsigned i = 0; i < process.loops().size(); ++i)
                if (noted.loop_site(i).line == 0)
                    noted.note_loop_site(i, process.loop_site(i));
            for (unsigned i = 0; i < process.port_count(); ++i)
                if (noted.port_site(i).line == 0 && ((writer_.step_ports(process.index()) >> i) & 1U) != 0)
                    noted.note_site(static_cast<std::uint8_t>(1U << i), process.port_site(i));
        }
}

void Taping::finish() {
    for (std::size_t core = 0; core < tapes_.size(); ++core) {
        for (std::size_t process = 0; process < tapes_[core].logs.size(); ++process)
            if (tapes_[core].begun[process] > 0)
                end_sample(core, process);
        std::vector<SampleCounters> const& results = accelerator_.cores()[core]->result_collector.results();
        run_.counters.insert(run_.counters.end(), results.begin(), results.end());
    }
    writer_.finish();
    note_sites();
}

}  // namespace faster
