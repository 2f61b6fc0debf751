#include <algorithm>

#include "kernel/base/each_bit.hpp"
#include "kernel/timing/bench_process.hpp"

// Runs of iterations of aligned loops.

namespace faster::timing {

/// Of an aligned loop.
bool BenchProcess::iterate(Operation& operation) {
    if (operation.ports() == 0) {
        std::uint64_t const count = std::uint64_t{operation.count()} * (1U + operation.gap());
        time_ += static_cast<std::int64_t>(count) * interval();
        this->count(count);
        take_off(operation, operation.count());
        return true;
    }
    std::int64_t const stride = interval() * (1 + static_cast<std::int64_t>(operation.gap()));
    std::uint32_t const wanted = operation.count();
    std::uint32_t const done = run(operation.ports(), wanted, [stride](std::uint32_t) { return stride; });
    if (done == 0)
        return false;
    count(std::uint64_t{done} * (1U + operation.gap()));
    take_off(operation, done);
    return done == wanted;
}

/// Of an aligned loop: followers have no others.
bool BenchProcess::iterate_mix(Operation& operation) {
    std::int64_t const interval = this->interval();
    std::uint32_t const gaps = operation.gaps();
    std::uint32_t const done = run(operation.ports(), operation.length(),
                                   [interval, gaps](std::uint32_t i) { return interval << ((gaps >> i) & 1U); });
    if (done == 0)
        return false;
    std::uint32_t const silent = gaps & Operation::gap_bits(1, done);
    count(done + (silent != 0 ? static_cast<std::uint64_t>(__builtin_popcount(silent)) : 0));
    bool const is_over = done == operation.length();
    if (is_over)
        ++log_front_;
    else
        operation = Operation::mix(operation.ports(), operation.length() - done, gaps >> done);
    return is_over;
}

/// Up to `wanted` iterations that access all ports of a mask, as long as their earliest cycles are known: how many.
template <class Stride> std::uint32_t BenchProcess::run(std::uint8_t mask, std::uint32_t wanted, Stride const& stride) {
    if (trail_ != nullptr)
        return run_by_steps(mask, wanted, stride);
    PortSet const& set = port_set(mask);
    switch (set.size) {
        case 1:
            return run<1>(set, wanted, stride);
        case 2:
            return run<2>(set, wanted, stride);
        case 3:
            return run<3>(set, wanted, stride);
        default:
            return run<4>(set, wanted, stride);
    }
}

/// One of a few that a process has.
BenchProcess::PortSet const& BenchProcess::make_port_set(std::uint8_t mask) {
    PortSet set;
    for_each_bit(mask, [&](unsigned number) {
        set.fifos |= ports_[number].fifo;
        set.ports.at(set.size++) = ports_[number];
    });
    port_sets_.push_back(set);
    port_set_of_[mask] = static_cast<std::uint8_t>(port_sets_.size());
    return port_sets_.back();
}

template <unsigned N, class Stride>
std::uint32_t BenchProcess::run(PortSet const& set, std::uint32_t wanted, Stride const& stride) {
    std::uint64_t known = set.ports[0].consumes->known();
    for (unsigned i = 1; i < N; ++i)
        known = std::min(known, set.ports[i].consumes->known());
    if (known < wanted) {
        blocked_at_ = set.blocks_after(known);
        if (known == 0)
            return 0;
        wanted = static_cast<std::uint32_t>(known);
    }
    accessed_ |= set.fifos;
    if (wanted == 1) {
        run_once<N>(set);
        time_ += stride(0);
        return 1;
    }
    BenchLine::Cycle const* earliest[N];
    BenchLine::Cycle* appended[N];
    std::int64_t later[N];
    std::int64_t stalls[N] = {};
    for (unsigned i = 0; i < N; ++i) {
        Port const& port = set.ports[i];
        port.appends->reserve(wanted);
        earliest[i] = port.consumes->cycles();
        appended[i] = port.appends->end();
        later[i] = port.later;
    }
    std::int64_t time = time_;
    for (std::uint32_t k = 0; k < wanted; ++k) {
        for (unsigned i = 0; i < N; ++i) {
            std::int64_t const until = std::max<std::int64_t>(time, earliest[i][k]);
            stalls[i] += until - time;
            time = until;
        }
        for (unsigned i = 0; i < N; ++i)
            appended[i][k] = static_cast<BenchLine::Cycle>(time + later[i]);
        time += stride(k);
    }
    time_ = time;
    for (unsigned i = 0; i < N; ++i) {
        Port const& port = set.ports[i];
        port.consumes->consume(wanted);
        port.appends->append(wanted);
        *port.stalls += static_cast<std::uint32_t>(stalls[i]);
    }
    return wanted;
}

/// A run of one iteration, as most are: nothing to be set up.
template <unsigned N> void BenchProcess::run_once(PortSet const& set) {
    std::int64_t time = time_;
    for (unsigned i = 0; i < N; ++i) {
        std::int64_t const until = std::max<std::int64_t>(time, *set.ports[i].consumes->cycles());
        *set.ports[i].stalls += static_cast<std::uint32_t>(until - time);
        time = until;
    }
    for (unsigned i = 0; i < N; ++i) {
        Port const& port = set.ports[i];
        port.consumes->consume(1);
        port.appends->reserve(1);
        *port.appends->end() = static_cast<BenchLine::Cycle>(time + port.later);
        port.appends->append(1);
    }
    time_ = time;
}

/// With a trail.
template <class Stride>
std::uint32_t BenchProcess::run_by_steps(std::uint8_t mask, std::uint32_t wanted, Stride const& stride) {
    for (std::uint32_t k = 0; k < wanted; ++k) {
        if (!perform(mask))
            return k;
        time_ += stride(k);
    }
    return wanted;
}

}  // namespace faster::timing
