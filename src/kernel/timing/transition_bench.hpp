#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "kernel/timing/bench_process.hpp"
#include "kernel/timing/phrase.hpp"
#include "kernel/timing/transition.hpp"

namespace faster::timing {

class CoreTiming;

/// Works out transitions, operation by operation, on processes and FIFOs of its own, which can do nothing else. Where
/// one transition goes on from the end of the last, so does the bench.
class TransitionBench {
  public:
    static constexpr std::size_t most_fifos = 32;

    /// Where a follower stands that waits for the driver. Times are relative to the driver's at the begin.
    struct Waiting {
        bool waits = false;
        unsigned port = BenchProcess::no_port;  ///< what for
        std::int64_t arrival = 0;               ///< local time at which it reached its step
        std::int64_t since = 0;                 ///< local time at which only the port was left to wait for
    };

    /// For cores of that shape, which leave trails or do not.
    TransitionBench(CoreTiming const& core, Lead const& lead, bool leaves_trails);
    ~TransitionBench();

    /// Goes to a state, which stays where it is until it is left.
    void go_to(StateView state);
    /// After work_out(): where it got to is the same as this.
    void is_at(StateView state) { at_ = state.words; }

    /// Charges the followers that wait for the driver (park_follower), where it is. By follower. `figures` are
    /// those of Transition.
    std::vector<Waiting> park(FigureBlocks& figures);
    std::vector<TrailEvent> take_trail(std::int64_t since = 0);
    /// From now on, figures tell of occupancies only above those told of since forget_told().
    void leave_out_told();
    void forget_told();

    /// A phrase, and what the supplier does besides, if there is one: iterations that write its anchor, of which it has
    /// more.
    struct Task {
        Phrase::Code const* codes = nullptr;
        unsigned size = 0;
        std::uint32_t active = 0;  ///< members that do something, a bit each, the supplier included
        std::uint32_t supplies = 0;
    };
    /// Performs it, from where the bench is on. False if the driver cannot finish it, or it takes too long.
    bool work_out(Task const& task, Transition& transition);

    /// The state that the last call led to, and the largest distance in time in it.
    StateView state() const { return {page_.data(), size_}; }
    std::int64_t reach() const { return std::max(-std::int64_t{lowest_}, std::int64_t{highest_}); }

  private:
    void connect(Group const& group);
    void start();
    void settle();
    bool describe(Transition& transition);
    void tell(Task const& task, Transition& transition);
    unsigned blocked_port(unsigned member) const;
    bool waits_for_driver(unsigned member, unsigned port, unsigned depth = 0) const;
    Waiting park_follower(unsigned member);
    bool goes_on_waiting(unsigned member);
    void save();
    void describe_stands(std::uint32_t actives, Transition& transition);
    void describe_rooms(Transition& transition);
    void take_figures(FigureBlocks& figures);
    void look_at(StateWord earliest, StateWord latest) {
        lowest_ = std::min(lowest_, earliest);
        highest_ = std::max(highest_, latest);
    }

    struct Fifo {
        BenchFifo fifo;
        unsigned writer = 0;
        unsigned reader = 0;
        std::uint64_t told = 0;      ///< the largest occupancy that figures told of since forget_told()
        std::uint64_t left_out = 0;  ///< an occupancy, up to which they do not

        unsigned other_end(unsigned member) const { return member == writer ? reader : writer; }
    };
    struct Member {
        BenchProcess process;
        // Where it stood before a transition.
        std::int64_t time_before = 0;
        unsigned port_before = BenchProcess::no_port;
    };

    using Floors = std::array<std::int64_t, Transition::most_members>;  ///< by member

    StateWord* save_fifo(Fifo const& fifo, std::int64_t reads_until, std::int64_t writes_until, StateWord* words);
    StateWord* save_line(BenchLine const& line, std::uint64_t over, StateWord* words);

    std::unique_ptr<CoreTiming> shape_;
    std::unique_ptr<Trail> trail_;
    std::vector<Fifo> fifos_;
    std::vector<Member> members_;
    unsigned supplier_ = 0, supplier_port_ = 0;
    std::size_t most_words_ = 0;        ///< of a state, but for operations
    std::uint32_t of_loops_ = 0;        ///< blocks of figures; behind them, those of FIFOs
    std::vector<FigureBlock> figures_;  ///< by number: zero between transitions
    StateWord const* at_ = nullptr;     ///< the state where it is, if that is known
    std::int64_t base_ = 0;             ///< the driver's time there
    std::uint32_t accessed_ = 0;        ///< FIFOs in the last transition, a bit each
    std::uint32_t told_ = 0;            ///< FIFOs of whose occupancies figures told since forget_told(), a bit each
    StateWords page_;
    std::size_t size_ = 0;                ///< words on it
    StateWord lowest_ = 0, highest_ = 0;  ///< times on it
};

}  // namespace faster::timing
