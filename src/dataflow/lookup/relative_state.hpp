#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/core/time/lookup_view.hpp"
#include "dataflow/lookup/figure_block.hpp"
#include "dataflow/lookup/state_words.hpp"
#include "dataflow/lookup/transition.hpp"
#include "dataflow/phrases/group.hpp"

namespace dataflow::timing {

/// Moves what decides the future of a group between its processes and FIFOs and a list of words. Times in the words are
/// relative to the driver's local time, so that equal lists have equal futures.
class RelativeState {
  public:
    /// What the timing of a process cannot tell, as its log may be empty.
    struct Outlook {
        Ports::Number next_ports = 0;  ///< of the step it goes on with; 0: unknown
        bool frozen = false;           ///< goes on with something outside the group: does not take part any more
    };
    static constexpr unsigned no_port = ~0U;

    explicit RelativeState(Group const& group) : group_(&group) {}

    std::vector<Outlook>& outlooks() { return outlooks_; }

    /// With what the logs of the followers of a mask hold. False if the driver is in the middle of an iteration, or
    /// goes on with an access outside the group, or times are too far apart.
    bool save(StatePage& page, std::uint32_t with_logs) const;
    void clear_logs(std::uint32_t members);
    /// Puts what the processes have yet to do in front of their logs.
    void restore(StateView state, Cycles driver_time);
    /// The figures of a group that only grow, in blocks: of each loop of each member its entries and iterations, and
    /// the cycles in which those waited for writes; in a second one, if there can be any, the cycles lost beyond its
    /// ends; of a member that sets up ahead, or whose calls are in turn, the cycles in which it awaited setups and
    /// calls; of each FIFO between members its tokens gone through, its full stalls, its empty stalls, and its largest
    /// occupancy.
    static std::uint32_t blocks_of(LoopShape const& loop) { return loop.depth < loop.interval.achieved ? 2 : 1; }
    static std::uint32_t blocks_of(ProcessTiming const& process);
    std::uint32_t blocks() const;
    /// Adds sums and raises occupancies. What a process has waited is the sum of what it waited for its FIFOs.
    void enter(FigureTotals const& figures);

    bool is_in_loop(unsigned member) const { return process(member).in_loop(); }
    std::uint64_t entries(unsigned member) const { return view(member).figures().loops_entered; }
    std::uint64_t iterations(unsigned member) const { return process(member).iterations(); }
    void set_iterations(unsigned member, std::uint64_t iterations) { process(member).set_iterations(iterations); }
    /// What a follower waited for before that, in the step it is at.
    struct EarlierWait {
        unsigned port;
        Cycles until;
    };
    /// Moves a follower back to when it arrived at its step, where it waits for a port since a cycle. Of the waits
    /// before that, the latest is first.
    void unpark(unsigned member, unsigned port, Cycles arrival, Cycles since, std::vector<EarlierWait> const& waits);
    /// Cycles from which on there is room in a FIFO, and how to set them: a frozen writer needs to know them later.
    std::vector<Cycles> room_times(unsigned fifo) const;
    void set_room_time(unsigned fifo, std::uint64_t i, Cycles cycle);

  private:
    ProcessTiming& process(unsigned member) const { return *group_->members()[member].process; }
    ProcessTiming::View view(unsigned member) const { return ProcessTiming::View(process(member)); }
    Ports::Number next_ports(unsigned member) const;
    void make_legal(unsigned member, unsigned port, Cycles from);
    void charge(unsigned member, unsigned port, Cycles cycles);
    static FigureTotals::const_iterator enter(ProcessTiming& process, FigureTotals::const_iterator figures);
    bool driver_leaves_group() const;
    std::size_t most_words() const;

    Group const* group_;
    std::vector<Outlook> outlooks_{std::vector<Outlook>(group_->members().size())};
};

}  // namespace dataflow::timing
