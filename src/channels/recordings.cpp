#include "channels/recordings.hpp"

#include <algorithm>

namespace faster {

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
        if (of_core.empty())
            continue;
        accelerator.cores()[core]->on_start([of_core] {
            for (recording::CoreRecorder* recorder : of_core)
                recorder->before_start();
        });
        accelerator.cores()[core]->on_sample_begins([of_core](std::size_t i) {
            for (recording::CoreRecorder* recorder : of_core)
                recorder->sample_begins(i);
        });
    }
}

recording::RecordedCore Recordings::recorded(Recorder& recorder, Cycles end) const {
    DataflowCore const& core = *accelerator_.cores()[recorder.core];
    recording::RecordedCore recorded;
    recorded.core = recorder.core;
    recorded.machine = &core.machine();
    recorded.from = recorder.recorder->from();
    recorded.to = std::min(recorder.recorder->to(), end == 0 ? 0 : end - 1);
    for (timing::FifoTiming const& fifo : core.timing().fifos())
        recorded.fifos.push_back(fifo.shape());
    for (std::size_t fifo = 0; fifo < recorded.fifos.size(); ++fifo)
        recorded.token_layouts.push_back(core.token_fields(fifo));
    recorded.memory_activity = [&core] { return core.memory_activity(); };
    recorded.spools = &recorder.recorder->spools();
    return recorded;
}

void Recordings::finish(Cycles end) {
    for (Recorder& recorder : recorders_)
        recorder.recorder->finish();
    for (std::size_t i = 0; i < requests_.size(); ++i) {
        std::vector<recording::RecordedCore> cores;
        for (Recorder& recorder : recorders_)
            if (recorder.request == i && recorder.recorder->from() < end)
                cores.push_back(recorded(recorder, end));
        requests_[i].done(cores);
    }
}

}  // namespace faster
