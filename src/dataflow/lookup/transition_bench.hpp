#pragma once
#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "dataflow/lookup/bench_process.hpp"
#include "dataflow/lookup/transition.hpp"
#include "dataflow/phrases/phrase.hpp"

namespace dataflow::timing {

class CoreTiming;

/// Works out transitions, operation by operation, on processes and FIFOs of its own, which can do nothing else. Where
/// one transition goes on from the end of the last, so does the bench.
class TransitionBench {
  public:
    static constexpr std::size_t most_fifos = 32;
    static constexpr std::size_t most_loops = 32;  ///< of a process

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

    void go_to(StateView state);

    /// Charges the followers that wait for the driver (park_follower), where it is. By follower. `figures` are
    /// those of Transition.
    /// `waits` are those that are over, see Transition::Stand.
    std::vector<Waiting> park(FigureBlocks& figures, std::vector<Transition::Stand>& waits);
    std::vector<TrailEvent> take_trail(std::int64_t since = 0);

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
    StateView state() const { return page_.words(); }
    std::int64_t reach() const { return page_.reach(); }

  private:
    void connect(Group const& group);
    void start();
    void settle();
    bool froze_too_early(Transition const& transition) const;
    bool describe(Transition& transition);
    void tell(Task const& task, Transition& transition);
    unsigned blocked_port(unsigned member) const;
    bool waits_for_driver(unsigned member, unsigned port, unsigned depth = 0) const;
    unsigned port_that_freezes(unsigned member);
    Waiting park_follower(unsigned member, std::vector<Transition::Stand>& waits);
    bool goes_on_waiting(unsigned member);
    void save();
    void describe_stands(std::uint32_t told, Transition& transition);
    void describe_rooms(Transition& transition);
    void describe_fed(Transition& transition);
    void take_figures(FigureBlocks& figures);

    struct Fifo {
        BenchFifo fifo;
        unsigned writer = 0;
        unsigned reader = 0;

        unsigned other_end(unsigned member) const { return member == writer ? reader : writer; }
    };
    struct Member {
        BenchProcess process;
        // Where it stood before a transition.
        std::int64_t time_before = 0;
        unsigned port_before = BenchProcess::no_port;
        bool has_accessed = false;  ///< in the transition

        /// It is at the step that it was at before.
        bool still_stands() const { return !has_accessed && process.time() == time_before; }
    };

    std::unique_ptr<CoreTiming> shape_;
    std::unique_ptr<Trail> trail_;
    std::vector<Fifo> fifos_;
    std::vector<Member> members_;
    unsigned supplier_ = 0, supplier_port_ = 0;
    bool is_fed_ = false;               ///< the supplier takes from memory
    std::size_t words_of_fifos_ = 0;    ///< of a state, at most
    std::uint32_t of_loops_ = 0;        ///< blocks of figures; behind them, those of FIFOs
    std::vector<FigureBlock> figures_;  ///< by number: zero between transitions
    std::int64_t base_ = 0;             ///< the driver's time there
    std::uint32_t accessed_ = 0;        ///< FIFOs in the last transition, a bit each
    StatePage page_;
};

}  // namespace dataflow::timing
