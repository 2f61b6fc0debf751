#include <algorithm>
#include <stdexcept>

#include "kernel/base/each_bit.hpp"
#include "kernel/timing/process_timing.hpp"

// Runs of iterations of an aligned loop that access the same ports: the hot path.

namespace faster::timing {

/// Iterations one after the other, all accesses of which have known earliest cycles. Each accesses all ports of a set,
/// or is a tail that accesses only the last.
template <unsigned N, bool Writes> class ProcessTiming::Burst {
  public:
    Burst(ProcessTiming& process, PortSet const& set) : process_(process), set_(set), time_(process.time_) {
        for (unsigned i = 0; i < N; ++i)
            fifos_[i] = FifoTiming::Run<Writes>(*set.fifos[i]);
    }

    static std::uint64_t known(PortSet const& set, unsigned port) {
        return Writes ? set.fifos[port]->known_writes() : set.fifos[port]->known_reads();
    }

    /// The next iteration is `stride` cycles after this one.
    void iterate(bool is_tail, Cycles stride) {
        unsigned waited_for = N;
        for (unsigned i = is_tail ? N - 1 : 0; i < N; ++i) {
            Cycles const later = std::max(fifos_[i].earliest(accesses_of(i)), time_);
            stalls_[i] += later - time_;
            waited_for = later > time_ ? i : waited_for;
            time_ = later;
        }
        if (process_.trail_ != nullptr && waited_for < N)
            process_.trail_->stalled(process_.index_, set_.ports[waited_for],
                                     Region::of_loop(process_.current_loop_, Region::Part::iterations), 0, time_);
        for (unsigned i = is_tail ? N - 1 : 0; i < N; ++i)
            fifos_[i].enter(accesses_of(i), time_);
        whole_ += is_tail ? 0 : 1;
        ++iterations_;
        time_ += stride;
    }

    void end() {
        process_.time_ = time_;
        for (unsigned i = 0; i < N; ++i) {
            if (accesses_of(i) > 0)
                set_.fifos[i]->done(fifos_[i], accesses_of(i));
            Writes ? set_.fifos[i]->add_full_stall(stalls_[i]) : set_.fifos[i]->add_empty_stall(stalls_[i]);
            (Writes ? process_.full_stall_cycles_ : process_.empty_stall_cycles_) += stalls_[i];
        }
    }

  private:
    std::uint64_t accesses_of(unsigned port) const { return port + 1 < N ? whole_ : iterations_; }

    ProcessTiming& process_;
    PortSet const& set_;
    FifoTiming::Run<Writes> fifos_[N];
    Cycles stalls_[N] = {};
    Cycles time_;
    std::uint64_t iterations_ = 0;
    std::uint64_t whole_ = 0;  ///< of them, not tails
};

/// Whether none of the accesses to come, `whole` of each port and `all` of the last, waits: no later access of a FIFO
/// is legal earlier than the one before it.
template <unsigned N, bool Writes>
bool ProcessTiming::has_nothing_to_wait_for(PortSet const& set, std::uint64_t whole, std::uint64_t all) const {
    for (unsigned i = 0; i < N; ++i) {
        std::uint64_t const count = i + 1 < N ? whole : all;
        FifoTiming const& fifo = *set.fifos[i];
        if (count > 0 && (Writes ? fifo.earliest_write(count - 1) : fifo.earliest_read(count - 1)) > time_)
            return false;
    }
    return true;
}

/// Up to `count` iterations that access all ports, as long as their earliest cycles are known.
template <unsigned N, bool Writes, class Stride>
std::uint32_t ProcessTiming::run_accesses(PortSet const& set, std::uint64_t count, Stride const& stride) {
    std::uint64_t known = count;
    for (unsigned i = 0; i < N; ++i)
        known = std::min(known, Burst<N, Writes>::known(set, i));
    if (known == 0)
        return 0;
    if (has_nothing_to_wait_for<N, Writes>(set, known, known)) {
        free_accesses<N, Writes>(set, known, stride);
    } else {
        Burst<N, Writes> burst(*this, set);
        for (std::uint64_t k = 0; k < known; ++k)
            burst.iterate(false, stride(k));
        burst.end();
    }
    return static_cast<std::uint32_t>(known);
}

template <unsigned N, bool Writes, class Stride>
void ProcessTiming::free_accesses(PortSet const& set, std::uint64_t count, Stride const& stride) {
    Cycles time = time_;
    for (unsigned i = 0; i < N; ++i) {
        time = time_;
        FifoTiming::Run<Writes> run(*set.fifos[i]);
        for (std::uint64_t k = 0; k < count; ++k) {
            run.enter(k, time);
            time += stride(k);
        }
        set.fifos[i]->done(run, count);
    }
    time_ = time;
}

template <unsigned N, bool Writes>
std::uint32_t ProcessTiming::accesses(PortSet const& set, std::uint32_t count, Cycles stride) {
    return run_accesses<N, Writes>(set, count, [stride](std::uint64_t) { return stride; });
}

template <unsigned N, bool Writes>
std::uint32_t ProcessTiming::mixed_accesses(PortSet const& set, unsigned length, std::uint32_t gaps) {
    Cycles const interval = plan().ii;
    return run_accesses<N, Writes>(
        set, length, [interval, gaps](std::uint64_t i) { return ((gaps >> i) & 1U) != 0 ? 2 * interval : interval; });
}

/// Of an operation with tails that access the last port of the set, which all other iterations access as a whole.
template <unsigned N, bool Writes>
std::uint32_t ProcessTiming::accesses_with_tails(PortSet const& set, Operation const& operation) {
    std::uint64_t known = ~std::uint64_t{0};
    for (unsigned i = 0; i + 1 < N; ++i)
        known = std::min(known, Burst<N, Writes>::known(set, i));
    std::uint32_t const end = reachable_with_tails(operation, known, Burst<N, Writes>::known(set, N - 1));
    if (end == 0)
        return 0;
    bool const is_flanked = operation.kind() == Operation::Kind::flanked;
    std::uint32_t const tails = (end == length_with_tails(operation) ? 1U : 0U) + (is_flanked && end > 1 ? 1U : 0U);
    bool const is_even = !is_flanked || operation.gap() == 0;
    if (is_even && has_nothing_to_wait_for<N, Writes>(set, end - tails, end))
        free_accesses_with_tails<N, Writes>(set, operation, end, end - tails);
    else
        waiting_accesses_with_tails<N, Writes>(set, operation, end);
    return end;
}

/// Of evenly spaced iterations, up to the `end`-th, of which `whole` are not tails.
template <unsigned N, bool Writes>
void ProcessTiming::free_accesses_with_tails(PortSet const& set, Operation const& operation, std::uint32_t end,
                                             std::uint32_t whole) {
    bool const is_flanked = operation.kind() == Operation::Kind::flanked;
    Cycles const interval = plan().ii;
    Cycles const stride = interval * (1U + operation.gap());
    for (unsigned i = 0; i < N; ++i) {
        bool const has_tails = i + 1 == N;
        std::uint32_t const count = has_tails ? end : whole;
        std::uint32_t const before_tail = is_flanked && !has_tails ? std::min(count, 1U) : count;
        FifoTiming::Run<Writes> run(*set.fifos[i]);
        run.enter_every(stride, 0, before_tail, time_);
        run.enter_every(stride, before_tail, count - before_tail, time_ + 2 * stride);
        if (count > 0)
            set.fifos[i]->done(run, count);
    }
    bool const is_over = end == length_with_tails(operation);
    time_ += is_over ? (end - 1) * stride + interval * (1U + operation.tail_gap()) : end * stride;
}

template <unsigned N, bool Writes>
void ProcessTiming::waiting_accesses_with_tails(PortSet const& set, Operation const& operation, std::uint32_t end) {
    std::uint32_t const last = length_with_tails(operation) - 1;
    std::uint32_t const other_tail = operation.kind() == Operation::Kind::flanked ? 1 : last;
    Cycles const interval = plan().ii;
    Burst<N, Writes> burst(*this, set);
    for (std::uint32_t k = 0; k < end; ++k) {
        bool const is_tail = k == last || k == other_tail;
        burst.iterate(is_tail, interval * (1U + (k == last ? operation.tail_gap() : is_tail ? 0U : operation.gap())));
    }
    burst.end();
}

/// How many iterations can be done if the ports of whole ones let `known` be done, and the tails' port so many of all.
std::uint32_t ProcessTiming::reachable_with_tails(Operation const& operation, std::uint64_t known,
                                                  std::uint64_t known_of_tails) {
    bool const is_flanked = operation.kind() == Operation::Kind::flanked;
    std::uint64_t const length = length_with_tails(operation);
    std::uint64_t const whole = length - (is_flanked ? 2 : 1);
    std::uint64_t const reachable = known >= whole ? length : known + (is_flanked && known > 0 ? 1 : 0);
    return static_cast<std::uint32_t>(std::min(reachable, known_of_tails));
}

ProcessTiming::PortSet ProcessTiming::make_port_set(std::uint8_t ports) const {
    using Accesses = decltype(PortSet::accesses);
    using MixedAccesses = decltype(PortSet::mixed_accesses);
    using AccessesWithTails = decltype(PortSet::accesses_with_tails);
    static constexpr Accesses accesses[2][4] = {
        {&ProcessTiming::accesses<1, false>, &ProcessTiming::accesses<2, false>, &ProcessTiming::accesses<3, false>,
         &ProcessTiming::accesses<4, false>},
        {&ProcessTiming::accesses<1, true>, &ProcessTiming::accesses<2, true>, &ProcessTiming::accesses<3, true>,
         &ProcessTiming::accesses<4, true>}};
    static constexpr MixedAccesses mixed_accesses[2][4] = {
        {&ProcessTiming::mixed_accesses<1, false>, &ProcessTiming::mixed_accesses<2, false>,
         &ProcessTiming::mixed_accesses<3, false>, &ProcessTiming::mixed_accesses<4, false>},
        {&ProcessTiming::mixed_accesses<1, true>, &ProcessTiming::mixed_accesses<2, true>,
         &ProcessTiming::mixed_accesses<3, true>, &ProcessTiming::mixed_accesses<4, true>}};
    static constexpr AccessesWithTails accesses_with_tails[2][4] = {
        {nullptr, &ProcessTiming::accesses_with_tails<2, false>, &ProcessTiming::accesses_with_tails<3, false>,
         &ProcessTiming::accesses_with_tails<4, false>},
        {nullptr, &ProcessTiming::accesses_with_tails<2, true>, &ProcessTiming::accesses_with_tails<3, true>,
         &ProcessTiming::accesses_with_tails<4, true>}};
    PortSet set;
    set.mask = ports;
    for_each_bit(ports, [&](unsigned number) {
        if (set.size == most_accesses)
            throw std::logic_error(name_ + ": a loop iteration accesses at most 4 FIFOs");
        Port const& port = ports_[number];
        set.ports[set.size] = number;
        set.fifos[set.size++] = port.fifo;
        set.writes = port.writes;
        set.neighbours |= port.neighbour;
    });
    set.accesses = accesses[set.writes ? 1 : 0][set.size - 1];
    set.mixed_accesses = mixed_accesses[set.writes ? 1 : 0][set.size - 1];
    set.accesses_with_tails = accesses_with_tails[set.writes ? 1 : 0][set.size - 1];
    return set;
}

/// Of a few that a process has.
ProcessTiming::PortSet const& ProcessTiming::port_set(std::uint8_t ports) {
    for (PortSet const& set : port_sets_)
        if (set.mask == ports)
            return set;
    return port_sets_.emplace_back(make_port_set(ports));
}

void ProcessTiming::start_run(Operation const& operation) {
    ++run_.number;
    run_.active = true;
    run_.ports = &port_set(operation.ports());
    run_.stride = plan().ii * (1U + operation.gap());
}

/// Iterations and tails that are done in one piece.
bool ProcessTiming::is_line(Operation const& operation) {
    bool const is_long = operation.kind() == Operation::Kind::iterate && operation.count() >= long_count;
    return operation.has_last_port_as_tail() && !is_long;
}

/// As far as earliest cycles are known; true: to its end.
bool ProcessTiming::continue_run() {
    Operation const& operation = log_.whole_front();
    if (operation.kind() == Operation::Kind::mixed)
        return continue_mix();
    return is_line(operation) ? continue_with_tails() : continue_plain_run();
}

bool ProcessTiming::continue_plain_run() {
    Operation& operation = log_.front();
    std::uint32_t const wanted = operation.count();
    std::uint32_t const done = (this->*run_.ports->accesses)(*run_.ports, wanted, run_.stride);
    if (done == 0)
        return false;
    charged_until_ = never;
    end_iterations(operation, done);
    if (done < wanted)
        return false;
    run_.active = false;
    front_ports_ = 0;
    return true;
}

/// With all mixes behind it that access the same ports.
bool ProcessTiming::continue_mix() {
    Operation mix = log_.whole_front();
    do {
        std::uint32_t const done = (this->*run_.ports->mixed_accesses)(*run_.ports, mix.length(), mix.gaps());
        if (done == 0)
            return false;
        charged_until_ = never;
        std::uint32_t const gaps = mix.gaps() & Operation::gap_bits(1, done);
        count_iterations(done + static_cast<std::uint64_t>(__builtin_popcount(gaps)));
        if (done < mix.length()) {
            log_.consume(0, done);
            return false;
        }
    } while (goes_on_with_mix(mix));
    run_.active = false;
    front_ports_ = 0;
    return true;
}

/// Takes the mix out. Whether another one of the same ports comes next, and it.
bool ProcessTiming::goes_on_with_mix(Operation& mix) {
    log_.consume();
    if (log_.exhausted())
        return false;
    Operation const next = log_.whole_front();
    bool const goes_on = next.kind() == Operation::Kind::mixed && next.ports() == mix.ports();
    mix = next;
    return goes_on;
}

/// With all lines behind it that access the same ports.
bool ProcessTiming::continue_with_tails() {
    for (Operation operation = log_.whole_front();;) {
        std::uint32_t const length = length_with_tails(operation);
        std::uint32_t const done = (this->*run_.ports->accesses_with_tails)(*run_.ports, operation);
        if (done == 0)
            return false;
        charged_until_ = never;
        end_iterations_with_tails(operation, done);
        bool const is_over = done == length;
        Operation const before = operation;
        if (is_over && !log_.exhausted()) {
            operation = log_.whole_front();
            if (operation.ports() == before.ports() && is_line(operation))
                continue;
        }
        run_.active = false;  // what is left accesses other ports
        front_ports_ = 0;
        return is_over;
    }
}

/// Iterations that access something.
std::uint32_t ProcessTiming::length_with_tails(Operation const& operation) {
    return operation.count() + (operation.kind() == Operation::Kind::flanked ? 2U : 1U);
}

void ProcessTiming::end_iterations_with_tails(Operation const& operation, std::uint32_t done) {
    bool const is_flanked = operation.kind() == Operation::Kind::flanked;
    bool const is_over = done == length_with_tails(operation);
    std::uint32_t const tails = (is_over ? 1U : 0U) + (is_flanked && done > 1 ? 1U : 0U);
    count_iterations(done + std::uint64_t{done - tails} * operation.gap() + (is_over ? operation.tail_gap() : 0U));
    if (is_over) {
        log_.consume();
        return;
    }
    std::uint32_t const of_rest = is_flanked ? done - std::min(done, 2U) : done;
    log_.whole_front() = is_flanked ? operation.rest() : operation;
    if (of_rest > 0)
        log_.consume(0, of_rest);
    if (is_flanked && done == 1)
        log_.put_back(Operation(Operation::Kind::iterate, operation.tail_ports(), 0, 1));
}

}  // namespace faster::timing
