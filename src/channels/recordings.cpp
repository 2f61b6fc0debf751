#include "channels/recordings.hpp"

#include <algorithm>

namespace dataflow {

namespace {
bool wants(recording::RecordingWindow const& window, std::size_t core) {
    return window.cores.empty() || std::find(window.cores.begin(), window.cores.end(), core) != window.cores.end();
}
}  // namespace

Recordings::Recordings(DataflowAccelerator& accelerator, std::vector<Recording> const& requests)
    : accelerator_(accelerator), requests_(requests) {
    for (std::size_t core = 0; core < accelerator.cores().size(); ++core) {
        std::vector<recording::CoreRecorder*> of_core;
        for (std::size_t i = 0; i < requests.size(); ++i) {
            if (!wants(requests[i].window, core))
                continue;
            auto recorder = std::make_unique<recording::CoreRecorder>(*accelerator.cores()[core], requests[i].window);
            if (!recorder->records())
                continue;
            of_core.push_back(recorder.get());
            recorders_.push_back({i, core, std::move(recorder)});
        }
        if (!of_core.empty())
            attach(core, of_core);
    }
    if (accelerator.memory() != nullptr && !recorders_.empty())
        listen_to_memory();
}

void Recordings::attach(std::size_t core, std::vector<recording::CoreRecorder*> const& recorders) {
    accelerator_.cores()[core]->on_start([recorders] {
        for (recording::CoreRecorder* recorder : recorders)
            recorder->before_start();
    });
    accelerator_.cores()[core]->on_sample_begins([this, recorders](std::size_t i) {
        for (recording::CoreRecorder* recorder : recorders)
            recorder->sample_begins(i);
        forget_bursts();
    });
}

void Recordings::listen_to_memory() {
    memory_.emplace(accelerator_.memory()->shape());
    accelerator_.memory()->on_served([this](timing::ServedBurst const& burst) { memory_->take(burst); });
}

/// Those before all windows.
void Recordings::forget_bursts() {
    if (!memory_)
        return;
    Cycles from = ~Cycles{0};
    for (Recorder const& recorder : recorders_)
        from = std::min(from, recorder.recorder->earliest_from());
    memory_->forget_before(from);
}

recording::RecordedCore Recordings::recorded(Recorder& recorder, Cycles end) {
    recording::RecordedCore recorded = recorder.recorder->recorded();
    recorded.core = recorder.core;
    recorded.to = std::min(recorded.to, end == 0 ? 0 : end - 1);
    return recorded;
}

void Recordings::finish(Cycles end) {
    for (Recorder& recorder : recorders_)
        recorder.recorder->finish();
    for (std::size_t i = 0; i < requests_.size(); ++i) {
        recording::RecordedWindow window;
        for (Recorder& recorder : recorders_)
            if (recorder.request == i && recorder.recorder->from() < end)
                window.cores.push_back(recorded(recorder, end));
        window.memory = memory_ ? &memory_->recorded() : nullptr;
        requests_[i].done(window);
    }
}

}  // namespace dataflow
