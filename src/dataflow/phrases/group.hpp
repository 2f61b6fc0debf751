#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "dataflow/core/time/lead.hpp"
#include "dataflow/core/time/process_timing.hpp"

namespace dataflow::timing {

class CoreTiming;

/// The processes of a Lead and the FIFOs between them, in one core. It knows no ports besides the first eight of each
/// process, of which masks tell: what accesses others is done outside the group.
class Group {
  public:
    struct Member {
        ProcessTiming* process = nullptr;
        unsigned anchor_port = 0;       ///< of this process; unused for the driver
        Ports::Number driver_port = 0;  ///< mask: the driver's end of the anchor
        bool writes_anchor = false;
        Ports::Number inner_ports = 0;  ///< mask: ports whose FIFO has both ends in the group
        Ports::Number fed_ports = 0;    ///< mask: what it takes from memory; see fed_iterations()

        /// ProcessTiming::fed_iterations(), if those take from memory and write the anchor, and that is all: what a
        /// phrase can say of them is how many.
        std::uint64_t fed_iterations() const;
    };
    struct Inner {
        FifoTiming* fifo = nullptr;
        unsigned writer = 0;  ///< number of a member
        unsigned reader = 0;
    };

    Group(CoreTiming& core, Lead const& lead);

    /// The driver is number 0. There are no others if there are more than lanes, or a port of an anchor is in no mask.
    std::vector<Member> const& members() const { return members_; }
    std::vector<Inner> const& fifos() const { return fifos_; }
    /// A small number for each of up to four followers, side by side in one word.
    using Lanes = std::uint64_t;
    static constexpr unsigned lane_bits = 16;
    static constexpr Lanes lane_mask = 0xFFFF;
    static constexpr std::size_t most_followers = sizeof(Lanes) * 8 / lane_bits;
    /// 1 for each follower whose anchor the driver accesses at a mask of ports.
    Lanes followers_at(Ports::Number driver_ports) const { return followers_at_[driver_ports]; }
    bool has(ProcessTiming const& process) const {
        return std::any_of(members_.begin(), members_.end(),
                           [&process](Member const& member) { return member.process == &process; });
    }
    ProcessTiming& driver() const { return *members_.front().process; }
    /// The first follower that writes its anchor, and so is ahead of the driver.
    bool has_supplier() const { return supplier_ != 0; }
    unsigned supplier() const { return supplier_; }
    /// As a mask: no bit if there is none.
    std::uint32_t suppliers() const { return has_supplier() ? 1U << supplier_ : 0; }
    /// All other followers, a bit each.
    std::uint32_t readers() const { return readers_; }
    /// The suppliers that take from memory, a bit each.
    std::uint32_t fed() const { return fed_; }
    /// The inner FIFO at a port, and who is at its other end.
    unsigned fifo_at(unsigned member, unsigned port) const { return fifo_at_[member][port]; }
    unsigned other_end(unsigned member, unsigned port) const;

  private:
    std::vector<Member> members_;
    unsigned supplier_ = 0;
    std::uint32_t readers_ = 0;
    std::uint32_t fed_ = 0;
    std::vector<Lanes> followers_at_ = std::vector<Lanes>(Ports::numbers);  ///< beyond masks: none
    std::vector<Inner> fifos_;
    std::vector<std::vector<unsigned>> fifo_at_;  // by member and port; ~0: not inner
};

}  // namespace dataflow::timing
