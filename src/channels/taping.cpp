#include "channels/taping.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "dataflow/core/machine/build_core.hpp"

namespace dataflow {

std::vector<Counters> all_results(DataflowCore const& core) {
    std::vector<Counters> results;
    for (std::size_t i = 0; i < core.results(); ++i)
        results.push_back(core.result(i));
    return results;
}

Taping::Taping(DataflowAccelerator& accelerator, replay::RecordedRun& run)
    : accelerator_(accelerator),
      run_(run),
      tapes_(accelerator.cores().size()),
      writer_(run, accelerator.machine().lead, accelerator.machine().process_places()) {
    run.lead = accelerator.machine().lead;
    if (accelerator.memory() != nullptr)
        tape_memory();
    for (std::size_t core = 0; core < tapes_.size(); ++core) {
        accelerator.cores()[core]->on_start([this, core] { start(core); });
        accelerator.cores()[core]->on_process_begins(
            [this, core](std::size_t process) { begin_sample(core, process); });
    }
}

void Taping::tape_memory() {
    Machine const& machine = accelerator_.machine();
    replay::RecordedMemory& memory = run_.memory.emplace();
    memory.loaded = accelerator_.loaded();
    for (auto const& core : accelerator_.cores()) {
        std::size_t const first = core->share().first;
        memory.entries.resize(std::max(memory.entries.size(), first + core->share().count),
                              std::vector<replay::RecordedMemory::Entries>(streams_of(machine).size()));
        core->on_entry([&memory, first](std::size_t master, timing::MemoryEntry const& entry) {
            memory.entries[first + entry.sample][master].push_back(entry);
        });
    }
}

void Taping::start(std::size_t core) {
    timing::CoreTiming& timing = accelerator_.cores()[core]->timing();
    tapes_[core].logs.resize(timing.processes().size());
    tapes_[core].begun.resize(timing.processes().size());
    for (std::size_t i = 0; i < timing.processes().size(); ++i)
        timing.process(i).add_tape(tapes_[core].logs[i]);
    if (core == 0) {
        run_.blueprint = std::make_unique<timing::CoreTiming>();
        build_core(*run_.blueprint, accelerator_.machine());
    }
    taking_part_ = modules_of(accelerator_.machine()).size();
}

void Taping::begin_sample(std::size_t core, std::size_t process) {
    if (tapes_[core].begun[process] > 0)
        end_sample(core, process);
    ++tapes_[core].begun[process];
}

/// What the process has said of the sample that it is at goes to the open samples; returns its place there.
std::size_t Taping::take_log(std::size_t core, std::size_t process) {
    CoreTape& tape = tapes_[core];
    std::size_t const at = tape.begun[process] - 1 - tape.done;
    while (tape.open.size() <= at) {
        tape.open.emplace_back(tape.logs.size());
        tape.left.push_back(0);
    }
    timing::OperationLog& log = tape.logs[process];
    tape.open[at][process].assign(log.begin(), log.begin() + log.pending());
    log.clear();
    return at;
}

void Taping::end_sample(std::size_t core, std::size_t process) {
    std::size_t const at = take_log(core, process);
    CoreTape& tape = tapes_[core];
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
            for (unsigned i = 0; i < process.loops().size(); ++i) {
                timing::LoopNotes& notes = noted.notes(i);
                notes.first = notes.first | process.notes(i).first;
                notes.ends = notes.ends | process.notes(i).ends;
                if (noted.loop_site(i).line == 0 && process.loop_site(i).line > 0)
                    noted.note_loop_site(i, process.loop_site(i));
            }
            for (unsigned i = 0; i < process.port_count(); ++i)
                if (noted.port_site(i).line == 0 && process.port_site(i).line > 0 &&
                    writer_.step_ports(process.index()).has(i))
                    noted.note_site(i, process.port_site(i));
        }
}

/// What was done of the samples that did not end, and nothing of those that did not begin.
void Taping::keep_unfinished() {
    for (std::size_t core = 0; core < tapes_.size(); ++core) {
        CoreTape& tape = tapes_[core];
        CoreShare const share = accelerator_.cores()[core]->share();
        tape.open.resize(share.count - tape.done, replay::SampleOperations(tape.logs.size()));
        for (std::size_t i = tape.done; i < share.count; ++i)
            run_.unfinished[share.first + i] = std::move(tape.open[i - tape.done]);
    }
}

void Taping::finish() {
    bool const is_stuck = !is_done();
    for (std::size_t core = 0; core < tapes_.size(); ++core) {
        for (std::size_t process = 0; process < tapes_[core].logs.size(); ++process)
            if (tapes_[core].begun[process] > 0)
                is_stuck ? void(take_log(core, process)) : end_sample(core, process);
        std::vector<Counters> results = all_results(*accelerator_.cores()[core]);
        results.resize(accelerator_.cores()[core]->share().count);
        run_.counters.insert(run_.counters.end(), results.begin(), results.end());
    }
    if (is_stuck)
        keep_unfinished();
    writer_.finish();
    note_sites();
}

/// All processes have done all samples.
bool Taping::is_done() const {
    return std::all_of(accelerator_.cores().begin(), accelerator_.cores().end(), [](auto const& core) {
        std::vector<FifoChannel*> const& channels = core->channels();
        return core->results() == core->share().count &&
               std::none_of(channels.begin(), channels.end(),
                            [](FifoChannel const* fifo) { return fifo != nullptr && fifo->is_awaited(); });
    });
}

}  // namespace dataflow
