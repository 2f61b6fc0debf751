#include <algorithm>
#include <stdexcept>

#include "common/each_bit.hpp"
#include "timing/process_timing.hpp"

// Runs of iterations of an aligned loop that access the same ports: the hot path.

namespace faster::timing {

/// The accesses of up to `count` iterations, a stride apart, as long as their earliest cycles are known.
template <unsigned N, bool Writes> std::uint32_t ProcessTiming::run_accesses(std::uint32_t count) {
    FifoTiming* fifos[N];
    Cycles stalls[N] = {};
    std::uint64_t known = count;
    for (unsigned i = 0; i < N; ++i) {
        fifos[i] = run_.fifos[i];
        known = std::min(known, Writes ? fifos[i]->known_writes() : fifos[i]->known_reads());
    }
    Cycles time = time_;
    Region const region = Region::of_loop(current_loop_, Region::Part::iterations);
    for (std::uint64_t k = 0; k < known; ++k) {
        unsigned waited_for = N;
        for (unsigned i = 0; i < N; ++i) {
            Cycles const earliest = Writes ? fifos[i]->earliest_write() : fifos[i]->earliest_read();
            Cycles const later = std::max(earliest, time);
            stalls[i] += later - time;
            waited_for = later > time ? i : waited_for;
            time = later;
        }
        if (trail_ != nullptr && waited_for < N)
            trail_->stalled(index_, run_.ports[waited_for], region, 0, time);
        for (unsigned i = 0; i < N; ++i)
            Writes ? fifos[i]->write(time) : fifos[i]->read(time);
        time += run_.stride;
    }
    time_ = time;
    for (unsigned i = 0; i < N; ++i) {
        Writes ? fifos[i]->add_full_stall(stalls[i]) : fifos[i]->add_empty_stall(stalls[i]);
        (Writes ? full_stall_cycles_ : empty_stall_cycles_) += stalls[i];
    }
    return static_cast<std::uint32_t>(known);
}

ProcessTiming::Run ProcessTiming::make_run(std::uint8_t ports) const {
    using Accesses = std::uint32_t (ProcessTiming::*)(std::uint32_t);
    static constexpr Accesses reading[] = {
        &ProcessTiming::run_accesses<1, false>, &ProcessTiming::run_accesses<2, false>,
        &ProcessTiming::run_accesses<3, false>, &ProcessTiming::run_accesses<4, false>};
    static constexpr Accesses writing[] = {&ProcessTiming::run_accesses<1, true>, &ProcessTiming::run_accesses<2, true>,
                                           &ProcessTiming::run_accesses<3, true>,
                                           &ProcessTiming::run_accesses<4, true>};
    Run run;
    for_each_bit(ports, [&](unsigned number) {
        if (run.size == 4)
            throw std::logic_error(name_ + ": a loop iteration accesses at most 4 FIFOs");
        Port const& port = ports_[number];
        run.ports[run.size] = number;
        run.fifos[run.size++] = port.fifo;
        run.writes = port.writes;
        run.neighbours |= port.neighbour;
    });
    run.accesses = (run.writes ? writing : reading)[run.size - 1];
    return run;
}

void ProcessTiming::start_run(Operation const& operation) {
    if (runs_.empty())
        runs_.resize(std::size_t{1} << max_ports);
    Run& known = runs_[operation.ports()];
    if (known.size == 0)
        known = make_run(operation.ports());
    std::uint64_t const number = run_.number + 1;
    run_ = known;
    run_.number = number;
    run_.active = true;
    run_.stride = plan().ii * (1U + operation.gap());
}

}  // namespace faster::timing
