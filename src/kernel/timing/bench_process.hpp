#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "kernel/base/each_bit.hpp"
#include "kernel/timing/bench_fifo.hpp"
#include "kernel/timing/group.hpp"
#include "kernel/timing/relative_state.hpp"
#include "kernel/timing/state_words.hpp"
#include "kernel/timing/trail.hpp"

namespace faster::timing {

/// A process on the bench: takes the steps that ProcessTiming takes, at times relative to the driver's at the begin.
/// Knows its FIFOs in the group, and only what a phrase can say.
class BenchProcess {
  public:
    static constexpr unsigned no_port = RelativeState::no_port;

    /// An end of a FIFO. A write consumes a cycle of its room and appends one from which on its token can be read; a
    /// read the other way round.
    struct Port {
        BenchLine* consumes = nullptr;
        BenchLine* appends = nullptr;
        std::int64_t later = 0;  ///< than the access: what is appended
        unsigned other = 0;      ///< member at the other end
        std::uint32_t fifo = 0;  ///< of the group: its bit
        std::uint32_t* stalls = nullptr;
    };

    /// `figures` are those of its loops, see RelativeState::enter(), which grow.
    BenchProcess(ProcessTiming const& process, FigureBlock* figures, Trail* trail);
    void connect(unsigned port, Port const& end) { ports_[port] = end; }

    /// Returns the words behind its own.
    StateWord const* load(StateWord const* words);
    /// A transition begins.
    void start() {
        iterations_before_ = iterations_;
        entered_ = false;
        counted_ = waited_ = 0;
        if (finished())
            log_front_ = log_end_ = 0;
        else if (log_front_ > long_gone)
            move_log_back();
    }
    /// Puts down its words, with times since `base`. Returns what is behind.
    StateWord* save(StateWord* words, std::int64_t base) const;
    /// That it puts down, but for those of the operations that are left.
    std::size_t most_words() const;
    std::size_t left() const { return log_end_ - log_front_; }

    void append(Operation const& operation) {
        if (log_end_ == log_.size())
            log_.resize(2 * log_end_ + 64);
        log_[log_end_++] = operation;
    }
    bool finished() const { return log_front_ == log_end_; }
    /// Takes steps as long as it can. The FIFOs that it accessed, a bit each.
    std::uint32_t advance();
    /// After advance(), if it is not finished: a FIFO that it cannot access, as a bit.
    std::uint32_t blocked_at() const { return blocked_at_; }

    std::int64_t time() const { return time_; }
    /// No further access is before this cycle, see RelativeState.
    std::int64_t not_before() const { return time_ + early_; }
    std::uint8_t next_ports() const { return finished() ? outlook_ports_ : log_[log_front_].ports(); }
    Port& port(unsigned number) { return ports_[number]; }
    Port const& port(unsigned number) const { return ports_[number]; }
    bool is_known(unsigned number) const { return ports_[number].consumes->known() > 0; }
    /// Waits at a port until a cycle, if that is later.
    void wait(unsigned number, std::int64_t cycle) {
        if (cycle <= time_)
            return;
        *ports_[number].stalls += static_cast<std::uint32_t>(cycle - time_);
        waited_ |= ports_[number].fifo;
        time_ = cycle;
    }
    void leave_trail(unsigned number);

    bool is_frozen() const { return frozen_; }
    void set_outlook(std::uint8_t next_ports, bool frozen) {
        outlook_ports_ = next_ports;
        frozen_ = frozen;
    }
    unsigned parked_at() const { return parked_at_; }
    void set_parked_at(unsigned port) { parked_at_ = port; }

    /// Visits the figures of its loops that may have grown since start().
    template <class Visit> void each_figures(Visit visit) const {
        for_each_bit(counted_, [&](unsigned loop) {
            for (std::uint32_t i = 0; i < loops_[loop].blocks; ++i)
                visit(loops_[loop].figures[i]);
        });
    }
    /// FIFOs that it may have waited for since start(), besides those that it accessed, a bit each.
    std::uint32_t waited() const { return waited_; }
    bool has_entered() const { return entered_; }
    /// Iterations since start(), or since it entered the loop it is in, or left.
    std::uint64_t iterations() const { return iterations_ - (entered_ ? 0 : iterations_before_); }

  private:
    using Kind = Operation::Kind;
    struct Loop {
        ProcessTiming::LoopPlan const* plan;
        LoopShape const* shape;
        FigureBlock* figures;
        std::uint32_t blocks;  ///< of them
    };
    /// The ports of a mask, which an iteration of an aligned loop accesses.
    struct PortSet {
        unsigned size = 0;
        std::uint32_t fifos = 0;
        std::array<Port, ProcessTiming::most_accesses> ports{};  // copies: one place less to look at

        /// The first of which no more than so many are known: its FIFO.
        std::uint32_t blocks_after(std::uint64_t known) const {
            unsigned i = 0;
            while (ports[i].consumes->known() > known)
                ++i;
            return ports[i].fifo;
        }
    };
    struct Pipeline {  ///< of a loop whose tokens leave in different stages
        std::uint64_t iteration = 0;
        bool open = false;
        std::size_t phase = 0;
        Cycles offset = 0;
        std::uint32_t gap_left = 0;
        std::uint64_t drain_left = 0;
    };

    static constexpr std::size_t long_gone = 256;  // operations

    void move_log_back();
    bool perform(std::uint8_t ports);
    bool take(Operation& operation);
    void enter(unsigned loop);
    void be_in_loop(unsigned number);
    bool leave();
    void count_end(Loop const& loop);
    bool iterate(Operation& operation);
    bool iterate_mix(Operation& operation);
    bool iterate_in_pipeline(Operation& operation);
    bool pass_phases(std::uint8_t ports);
    void clear_delay_line();
    /// Ports of the iteration so many before the one at hand, which began in this loop.
    std::uint8_t delayed(std::uint64_t lag) const {
        return delay_line_[(pipeline_.iteration - lag) & (delay_line_.size() - 1)];
    }
    void split_flanked();
    /// Of the front operation, which may become its tail; or the next is the front one.
    void take_off(Operation& operation, std::uint32_t count) {
        operation.subtract(count);
        if (operation.count() > 0)
            return;
        if (operation.own_tail_ports() != 0)
            operation.become_tail();
        else
            ++log_front_;
    }
    void count(std::uint64_t iterations) {
        iterations_ += iterations;
        loops_[loop_].figures->sums[1] += static_cast<std::uint32_t>(iterations);
        counted_ |= 1U << loop_;
    }
    template <class Stride> std::uint32_t run(std::uint8_t ports, std::uint32_t wanted, Stride const& stride);
    template <unsigned N, class Stride>
    std::uint32_t run(PortSet const& set, std::uint32_t wanted, Stride const& stride);
    template <unsigned N> void run_once(PortSet const& set);
    PortSet const& port_set(std::uint8_t mask) {
        return port_set_of_[mask] != 0 ? port_sets_[port_set_of_[mask] - 1U] : make_port_set(mask);
    }
    PortSet const& make_port_set(std::uint8_t mask);
    template <class Stride> std::uint32_t run_by_steps(std::uint8_t ports, std::uint32_t wanted, Stride const& stride);
    void mark(Region region) {
        if (trail_ != nullptr)
            trail_->marked(process_->index(), region, static_cast<Cycles>(time_));
    }
    ProcessTiming::LoopPlan const& plan() const { return *loops_[loop_].plan; }
    std::int64_t interval() const { return static_cast<std::int64_t>(plan().ii); }

    ProcessTiming const* process_;  ///< what it is
    std::vector<Loop> loops_;
    Trail* trail_;
    std::array<Port, 8> ports_{};
    std::vector<PortSet> port_sets_;               ///< made when first needed
    std::array<std::uint8_t, 256> port_set_of_{};  ///< by mask: from 1 on; 0: not made yet

    std::int64_t time_ = 0;
    std::int64_t early_ = 0;  ///< what it may go back when it leaves the loop it is in, not above 0
    bool in_loop_ = false;
    unsigned loop_ = 0;
    std::uint64_t counting_ = 0;    ///< iterations of it that states tell; 0: in none
    std::uint64_t iterations_ = 0;  ///< of the loop entry at hand, up to as many before load() as count
    std::uint64_t iterations_before_ = 0;
    bool entered_ = false;
    std::uint32_t counted_ = 0;   ///< loops with figures, a bit each
    std::uint32_t accessed_ = 0;  ///< FIFOs in advance(), a bit each
    std::uint32_t blocked_at_ = 0;
    std::uint32_t waited_ = 0;
    std::uint8_t outlook_ports_ = 0;
    bool frozen_ = false;
    unsigned parked_at_ = no_port;
    Pipeline pipeline_;
    std::vector<std::uint8_t> delay_line_;
    std::vector<Operation> log_;
    std::size_t log_front_ = 0, log_end_ = 0;
};

}  // namespace faster::timing
