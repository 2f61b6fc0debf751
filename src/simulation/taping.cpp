#include "simulation/taping.hpp"

namespace faster {

Taping::Taping(Accelerator& accelerator, retiming::RecordedRun& run)
    : accelerator_(accelerator), run_(run), logs_(accelerator.cores().size()) {
    run_.cores.resize(logs_.size());
    for (std::size_t core = 0; core < logs_.size(); ++core) {
        accelerator.cores()[core]->on_start([this, core] { start(core); });
        accelerator.cores()[core]->on_sample_begins([this, core](std::size_t) { take_round(core); });
    }
}

void Taping::start(std::size_t core) {
    timing::CoreTiming& timing = accelerator_.cores()[core]->timing();
    logs_[core].resize(timing.processes().size());
    for (std::size_t i = 0; i < logs_[core].size(); ++i)
        timing.process(i).add_tape(logs_[core][i]);
    if (core == 0)
        run_.blueprint = timing.blank_copy();
}

void Taping::take_round(std::size_t core) {
    for (std::size_t i = 0; i < logs_[core].size(); ++i) {
        run_.cores[core].put(i, logs_[core][i]);
        logs_[core][i].clear();
    }
    run_.cores[core].end_round();
}

void Taping::finish() {
    for (std::size_t core = 0; core < logs_.size(); ++core) {
        take_round(core);
        run_.cores[core].finish();
    }
}

}  // namespace faster
