#pragma once
#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "dataflow/core/time/process_rules.hpp"

namespace dataflow::timing {

/// Speed: does many iterations of a loop at a time, where ProcessRules would do one after the other, and comes to the
/// same cycles, stalls and counts. Nothing here decides a cycle: without this class, with do_iterations() of
/// ProcessRules, everything is as it is, and several times as slow. bulk_runs_test.cpp holds it to the rules.
///
/// `Process` derives from this instead of ProcessRules, and has what that asks for, and
///
///     bool goes_by_steps() const   true: iterations one by one, so that each can be looked at
///     bool may_go_on()             false: stops in front of the next iterations, whatever they are
template <class Process, class Port> class BulkRuns : public ProcessRules<Process, Port> {
    using Base = ProcessRules<Process, Port>;

  public:
    using typename Base::Line;
    using typename Base::Time;

    static constexpr unsigned most_in_run = 4;  ///< ports of iterations that are done many at a time
    /// Equal iterations from which on it pays to look for a steady state.
    static constexpr std::uint32_t long_count = 64;

    /// Of a loop that takes tokens from memory: the iterations at hand, if those in its pipeline access the same ports,
    /// otherwise 0. As long as their tokens have arrived, they take what iterations of a loop without memory do.
    std::uint32_t alike_iterations() const {
        if (log_.exhausted() || !is_in_stream_loop())
            return 0;
        Operation const& operation = log_.front();
        bool const is_plain = operation.kind() == Kind::iterate && operation.own_tail_ports() == 0;
        return is_plain && is_uniform(operation) ? operation.count() : 0;
    }

  protected:
    using Base::Base;
    using Base::is_in_stream_loop;
    using Base::iterate_by_step;
    using Base::iterate_in_pipeline;
    using Base::log_;
    using Base::plan_;
    using Base::port_set;
    using Base::run_;
    using Base::self;
    using Base::shape_;
    using Base::state_;
    using Base::take_off;
    using Base::trail_;
    using typename Base::Kind;
    using typename Base::PortSet;

    /// In place of ProcessRules::do_iterations().
    bool do_iterations(Operation const& whole) {
        if (plan_->aligned)
            return iterate(whole);
        Operation& operation = log_.front();
        return is_uniform(operation) ? run_in_pipeline(operation) : iterate_in_pipeline(operation);
    }

    /// In the pipeline, which is full of iterations that access the same ports.
    void go_on_alike(Ports::Number ports, std::uint64_t iterations) {
        state_.pipeline.iteration += iterations;
        state_.pipeline.alike += iterations;
        for (std::uint64_t lag = std::min(iterations, plan_->longest_lag); lag > 0; --lag)
            state_.delayed(lag) = ports;
    }

  private:
    // Loops that are not aligned.

    /// Of a loop that takes from memory, which is in no group of the lookups: all iterations in the pipeline access
    /// what the next ones do, in one step of each. So every step does the same.
    bool is_uniform(Operation const& operation) const {
        PipelinePosition const& pipeline = state_.pipeline;
        if (!shape_->loops[state_.loop].uses_stream || plan_->phases.size() != 1 || plan_->phases.front().offset > 0 ||
            self().goes_by_steps() || pipeline.open || pipeline.gap_left > 0 || operation.gap() > 0 ||
            operation.ports() == 0 || operation.count() < 2 || pipeline.alike < plan_->longest_lag)
            return false;
        bool const goes_on = plan_->longest_lag == 0 || state_.delayed(1) == operation.ports();
        return goes_on && are_in_one_step(operation.ports());
    }

    /// Of a loop with one step.
    bool are_in_one_step(Ports::Number ports) const {
        std::size_t const all = port_set(ports).size();
        auto const& known = plan_->phases.front().ports;
        return all <= most_in_run &&
               all == static_cast<std::size_t>(std::count_if(known.begin(), known.end(), [ports](auto const& port) {
                   return Ports(ports).has(port.first);
               }));
    }

    bool run_in_pipeline(Operation& operation) {
        std::uint32_t const wanted = operation.count();
        Time const stride = static_cast<Time>(plan_->ii);
        std::uint32_t const done =
            run(port_set(operation.ports()), wanted, [stride](std::uint32_t /*i*/) { return stride; });
        if (done == 0)
            return false;
        go_on_alike(operation.ports(), done);
        Base::count(done);
        take_off(operation, done);
        return done == wanted;
    }

    // Aligned loops.

    bool iterate(Operation const& whole) {
        if (self().goes_by_steps() || port_set(whole.ports()).size() > most_in_run)
            return iterate_by_step(log_.front());
        if (whole.kind() == Kind::mixed)
            return run_mix(whole);
        if (is_line(whole) && !is_in_stream_loop())  // where the last port is the first in its set
            return run_line(whole);
        Operation& operation = log_.front();
        return operation.ports() == 0 ? Base::pass_silence(operation) : run_iterations(operation);
    }

    bool run_iterations(Operation& operation) {
        Time const stride = static_cast<Time>(plan_->ii * (1U + operation.gap()));
        std::uint32_t const wanted = operation.count();
        std::uint32_t const done =
            run(port_set(operation.ports()), wanted, [stride](std::uint32_t /*i*/) { return stride; });
        if (done == 0)
            return false;
        Base::count(std::uint64_t{done} * (1U + operation.gap()));
        take_off(operation, done);
        return done == wanted;
    }

    bool run_mix(Operation const& mix) {
        auto const interval = static_cast<Time>(plan_->ii);
        std::uint32_t const gaps = mix.gaps();
        std::uint32_t const done = run(port_set(mix.ports()), mix.length(), [interval, gaps](std::uint32_t i) {
            return ((gaps >> i) & 1U) != 0 ? 2 * interval : interval;
        });
        if (done == 0)
            return false;
        std::uint32_t const silent = gaps & Operation::gap_bits(1, done);
        Base::count(done + (silent != 0 ? static_cast<std::uint64_t>(__builtin_popcount(silent)) : 0));
        bool const is_over = done == mix.length();
        log_.consume(is_over ? 1 : 0, is_over ? 0 : done);
        return is_over;
    }

    /// Iterations of which all earliest cycles are known, one after the other. Each accesses all ports of a set, or is
    /// a tail that accesses only the last.
    template <unsigned N> class Burst {
      public:
        Burst(BulkRuns& process, PortSet const& set, std::uint64_t whole, std::uint64_t all)
            : process_(process), set_(set), time_(process.state_.time) {
            for (unsigned i = 0; i < N; ++i) {
                FifoEnd<Line> const& end = set[i].end;
                earliest_[i] = end.consumes->reader();
                appended_[i] = end.appends->writer(i + 1 < N ? whole : all);
                later_[i] = end.later;
            }
        }

        /// Whether any of the accesses to come may have to wait: those of a FIFO never become legal earlier than the
        /// one before.
        bool may_wait(std::uint64_t whole, std::uint64_t all) const {
            bool waits = whole == 0;
            for (unsigned i = 0; i < N && !waits; ++i)
                waits = earliest_[i][(i + 1 < N ? whole : all) - 1] > time_;
            return waits;
        }

        /// The next iteration is `stride` cycles after this one.
        template <bool MayWait> [[gnu::always_inline]] void iterate(bool is_tail, Time stride) {
            unsigned waited_for = N;
            Time const arrival = time_;
            for (unsigned i = is_tail ? N - 1 : 0; MayWait && i < N; ++i) {
                Time const later = std::max<Time>(earliest_[i][accesses_of(i)], time_);
                stalls_[i] += later - time_;
                waited_for = later > time_ ? i : waited_for;
                time_ = later;
            }
            if (process_.trail_ != nullptr && waited_for < N)
                process_.self().note_wait(set_[waited_for],
                                          Region::of_loop(process_.state_.loop, Region::Part::iterations), 0, arrival,
                                          time_);
            for (unsigned i = is_tail ? N - 1 : 0; i < N; ++i)
                appended_[i][accesses_of(i)] = static_cast<typename Line::Cycle>(time_ + later_[i]);
            whole_ += is_tail ? 0 : 1;
            ++all_;
            time_ += stride;
        }

        void end() {
            for (unsigned i = 0; i < N; ++i) {
                Port const& port = set_[i];
                std::uint64_t const accesses = accesses_of(i);
                if (accesses > 0) {
                    port.end.consumes->consume(accesses);
                    port.end.appends->done(accesses);
                    process_.self().note(port, accesses);
                }
                if (stalls_[i] > 0)
                    process_.self().charge(port, stalls_[i]);
            }
            process_.state_.time = time_;  // after charge(), which would take it for the end of a wait
        }

      private:
        std::uint64_t accesses_of(unsigned port) const { return port + 1 < N ? whole_ : all_; }

        BulkRuns& process_;
        PortSet const& set_;
        typename Line::Reader earliest_[N];
        typename Line::Writer appended_[N];
        Time later_[N];
        Time stalls_[N] = {};
        Time time_;
        std::uint64_t whole_ = 0;  ///< iterations that were no tails
        std::uint64_t all_ = 0;
    };

    static std::uint64_t known(PortSet const& set, std::size_t ports) {
        std::uint64_t known = ~std::uint64_t{0};
        for (std::size_t i = 0; i < ports; ++i)
            known = std::min(known, set[i].end.known());
        return known;
    }
    /// For the first port of which no more are known.
    void wait_behind(PortSet const& set, std::uint64_t known) {
        for (Port const& port : set)
            if (port.end.known() <= known) {
                self().wait_for(port);
                return;
            }
    }

    /// Up to `wanted` iterations that access all ports of a set, as long as their earliest cycles are known: how many.
    template <class Stride> std::uint32_t run(PortSet const& set, std::uint32_t wanted, Stride const& stride) {
        std::uint64_t const known_of_all = known(set, set.size());
        if (known_of_all < wanted) {
            wait_behind(set, known_of_all);
            wanted = static_cast<std::uint32_t>(known_of_all);
        }
        if (wanted == 0 || !self().may_go_on())
            return 0;
        switch (set.size()) {
            case 1:
                run<1>(set, wanted, stride);
                break;
            case 2:
                run<2>(set, wanted, stride);
                break;
            case 3:
                run<3>(set, wanted, stride);
                break;
            default:
                run<most_in_run>(set, wanted, stride);
                break;
        }
        return wanted;
    }
    template <unsigned N, class Stride> void run(PortSet const& set, std::uint32_t wanted, Stride const& stride) {
        Burst<N> burst(*this, set, wanted, wanted);
        auto const run = [&](auto may_wait) {
            for (std::uint32_t k = 0; k < wanted; ++k)
                burst.template iterate<decltype(may_wait)::value>(false, stride(k));
        };
        burst.may_wait(wanted, wanted) ? run(std::true_type()) : run(std::false_type());
        burst.end();
    }

    // Lines: iterations with tails that access the last of their ports, in one piece.

    /// The longest are done as iterations, so that a steady state is seen.
    static bool is_line(Operation const& operation) {
        bool const is_long = operation.kind() == Kind::iterate && operation.count() >= long_count;
        return operation.has_last_port_as_tail() && !is_long;
    }
    /// Iterations that access something.
    static std::uint32_t length_of_line(Operation const& line) {
        return line.count() + (line.kind() == Kind::flanked ? 2U : 1U);
    }
    /// How many of them can be done if the ports of whole ones let `known` be done, and the tails' port so many of all.
    static std::uint32_t reachable(Operation const& line, std::uint64_t known, std::uint64_t known_of_tails) {
        bool const is_flanked = line.kind() == Kind::flanked;
        std::uint64_t const length = length_of_line(line);
        std::uint64_t const whole = length - (is_flanked ? 2 : 1);
        std::uint64_t const reachable = known >= whole ? length : known + (is_flanked && known > 0 ? 1 : 0);
        return static_cast<std::uint32_t>(std::min(reachable, known_of_tails));
    }
    static std::uint32_t tails_of(Operation const& line, std::uint32_t done) {
        return (done == length_of_line(line) ? 1U : 0U) + (line.kind() == Kind::flanked && done > 1 ? 1U : 0U);
    }

    bool run_line(Operation const& line) {
        PortSet const& set = port_set(line.ports());
        std::size_t const ports = set.size();
        std::uint64_t const known_of_whole = known(set, ports - 1);
        std::uint32_t const done = reachable(line, known_of_whole, set.back().end.known());
        bool const is_over = done == length_of_line(line);
        if (!is_over)
            wait_behind(set, std::min<std::uint64_t>(known_of_whole, done));
        if (done == 0 || !self().may_go_on())
            return false;
        switch (ports) {
            case 2:
                run_line<2>(set, line, done);
                break;
            case 3:
                run_line<3>(set, line, done);
                break;
            default:
                run_line<most_in_run>(set, line, done);
                break;
        }
        end_line(line, done);
        return is_over;
    }

    template <unsigned N> void run_line(PortSet const& set, Operation const& line, std::uint32_t count) {
        std::uint32_t const last = length_of_line(line) - 1;
        std::uint32_t const other_tail = line.kind() == Kind::flanked ? 1 : last;
        auto const interval = static_cast<Time>(plan_->ii);
        std::uint32_t const whole = count - tails_of(line, count);
        Burst<N> burst(*this, set, whole, count);
        auto const run = [&](auto may_wait) {
            for (std::uint32_t k = 0; k < count; ++k) {
                bool const is_tail = k == last || k == other_tail;
                std::uint32_t const silent = k == last ? line.tail_gap() : is_tail ? 0U : line.gap();
                burst.template iterate<decltype(may_wait)::value>(is_tail, interval * static_cast<Time>(1U + silent));
            }
        };
        burst.may_wait(whole, count) ? run(std::true_type()) : run(std::false_type());
        burst.end();
    }

    /// Counts the iterations done, and leaves the others in the log.
    void end_line(Operation const& line, std::uint32_t done) {
        bool const is_flanked = line.kind() == Kind::flanked;
        bool const is_over = done == length_of_line(line);
        Base::count(done + std::uint64_t{done - tails_of(line, done)} * line.gap() + (is_over ? line.tail_gap() : 0U));
        ++run_;
        if (is_over) {
            log_.consume();
            return;
        }
        std::uint32_t const of_rest = is_flanked ? done - std::min(done, 2U) : done;
        log_.whole_front() = is_flanked ? line.rest() : line;
        if (of_rest > 0)
            log_.consume(0, of_rest);
        if (is_flanked && done == 1)
            log_.put_back(Operation(Kind::iterate, line.tail_ports(), 0, 1));
    }
};

}  // namespace dataflow::timing
