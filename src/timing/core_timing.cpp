#include "timing/core_timing.hpp"

#include <algorithm>

namespace faster::timing {

FifoTiming& CoreTiming::add_fifo(FifoShape shape) { return fifos_.emplace_back(std::move(shape)); }

ProcessTiming& CoreTiming::add_process(std::string name) {
    return processes_.emplace_back(std::move(name), static_cast<unsigned>(processes_.size()));
}

std::size_t CoreTiming::number_of(FifoTiming const& fifo) const {
    auto const same = [&fifo](FifoTiming const& other) { return &other == &fifo; };
    return static_cast<std::size_t>(std::find_if(fifos_.begin(), fifos_.end(), same) - fifos_.begin());
}

void CoreTiming::connect() {
    ends_.assign(fifos_.size(), Ends{});
    for (ProcessTiming const& process : processes_)
        for (unsigned port = 0; port < process.port_count(); ++port) {
            Ends& both = ends_[number_of(process.fifo(port))];
            (process.writes(port) ? both.writer : both.reader) = static_cast<int>(process.index());
        }
    for (ProcessTiming& process : processes_)
        for (unsigned port = 0; port < process.port_count(); ++port) {
            Ends const& both = ends_[number_of(process.fifo(port))];
            int const other = process.writes(port) ? both.reader : both.writer;
            process.set_neighbour(port, other < 0 ? 0U : 1U << other);
        }
}

void CoreTiming::resolve() {
    if (ends_.empty())
        connect();
    std::uint32_t runnable = (1U << processes_.size()) - 1;
    while (runnable != 0) {
        // Downstream processes first: what they read is what makes room for those before them.
        auto const index = 31U - static_cast<unsigned>(__builtin_clz(runnable));
        runnable &= ~(1U << index);
        ProcessTiming& process = processes_[index];
        if (process.is_running(SteadyState::worthwhile_count))
            steady_state_.observe(process, processes_);
        runnable |= process.advance();
    }
    for (ProcessTiming& process : processes_)
        process.log().compact();
}

std::vector<Wait> CoreTiming::waits() {
    if (ends_.empty())
        connect();
    std::vector<Wait> waits;
    for (ProcessTiming& process : processes_) {
        ProcessTiming::Status const status = process.front();
        bool const starving = status == ProcessTiming::Status::exhausted && process.starving_port() >= 0;
        if (status != ProcessTiming::Status::blocked && !starving)
            continue;
        unsigned const port = starving ? static_cast<unsigned>(process.starving_port()) : process.blocking_port();
        FifoTiming const& fifo = process.fifo(port);
        Wait wait;
        wait.process = process.name();
        wait.position = process.position();
        wait.fifo = fifo.name();
        wait.to_write = process.writes(port);
        wait.occupancy = std::min(fifo.writes() - fifo.reads(), fifo.shape().capacity);
        wait.capacity = fifo.shape().capacity;
        wait.since = process.local_time();
        Ends const& both = ends_[number_of(fifo)];
        int const other = wait.to_write ? both.reader : both.writer;
        wait.other = other < 0 ? "nobody" : processes_[static_cast<std::size_t>(other)].name();
        waits.push_back(wait);
    }
    return waits;
}

}  // namespace faster::timing
