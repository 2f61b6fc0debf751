#include "dataflow/phrases/group.hpp"

#include <algorithm>

#include "dataflow/core/time/core_timing.hpp"

namespace dataflow::timing {

namespace {
constexpr unsigned none = ~0U;

/// Whether all ports of a process at a FIFO are in masks.
bool is_in_masks(ProcessTiming const& process, FifoTiming const& fifo) {
    for (unsigned port = Ports::in_masks; port < process.port_count(); ++port)
        if (&process.fifo(port) == &fifo)
            return false;
    return true;
}

void find_fed_ports(Group::Member& member) {
    bool const is_fed = member.writes_anchor && member.process->takes_from_memory();
    if (is_fed && member.process->stream_port() < Ports::in_masks)
        member.fed_ports = Ports::of(member.process->stream_port()).number();
}

bool can_follow(CoreTiming const& core, Lead const& lead) {
    return lead.followers.size() <= Group::most_followers &&
           std::all_of(lead.followers.begin(), lead.followers.end(), [&](Lead::Follower const& follower) {
               FifoTiming const& anchor = core.fifos()[follower.anchor];
               return is_in_masks(core.processes()[follower.process], anchor) &&
                      is_in_masks(core.processes()[lead.driver], anchor);
           });
}
}  // namespace

Group::Group(CoreTiming& core, Lead const& lead) {
    members_.push_back({&core.process(lead.driver)});
    if (can_follow(core, lead))
        for (Lead::Follower const& follower : lead.followers)
            members_.push_back({&core.process(follower.process)});
    fifo_at_.resize(members_.size());
    for (std::size_t number = 0; number < core.fifos().size(); ++number) {
        FifoTiming& fifo = core.fifo(number);
        unsigned ends[2] = {none, none};  // reader, writer
        for (unsigned m = 0; m < members_.size(); ++m)
            for (unsigned port = 0; port < members_[m].process->port_count(); ++port)
                if (&members_[m].process->fifo(port) == &fifo)
                    ends[members_[m].process->writes(port) ? 1 : 0] = m;
        if (ends[0] != none && ends[1] != none)
            fifos_.push_back({&fifo, ends[1], ends[0]});
    }
    for (unsigned m = 0; m < members_.size(); ++m)
        for (unsigned port = 0; port < members_[m].process->port_count(); ++port) {
            unsigned found = none;
            for (unsigned f = 0; f < fifos_.size(); ++f)
                if (fifos_[f].fifo == &members_[m].process->fifo(port))
                    found = f;
            fifo_at_[m].push_back(found);
            if (found != none && port < Ports::in_masks)
                members_[m].inner_ports |= static_cast<Ports::Number>(1U << port);
        }
    for (unsigned m = 1; m < members_.size(); ++m) {
        FifoTiming const& anchor = core.fifos()[lead.followers[m - 1].anchor];
        for (unsigned port = 0; port < members_[m].process->port_count(); ++port)
            if (&members_[m].process->fifo(port) == &anchor) {
                members_[m].anchor_port = port;
                members_[m].writes_anchor = members_[m].process->writes(port);
            }
        for (unsigned port = 0; port < driver().port_count(); ++port)
            if (&driver().fifo(port) == &anchor)
                members_[m].driver_port = Ports::of(port).number();
    }
    for (unsigned m = 1; m < members_.size(); ++m) {
        find_fed_ports(members_[m]);
        fed_ |= members_[m].fed_ports != 0 ? 1U << m : 0U;
        if (!members_[m].writes_anchor)
            readers_ |= 1U << m;
        else if (supplier_ == 0)
            supplier_ = m;
    }
    for (unsigned ports = 0; ports < Ports::masks; ++ports)
        for (unsigned m = 1; m < members_.size(); ++m)
            if ((ports & members_[m].driver_port) != 0)
                followers_at_[ports] |= Lanes{1} << (lane_bits * (m - 1));
}

std::uint64_t Group::Member::fed_iterations() const {
    OperationLog const& log = process->log();
    auto const alone = static_cast<Ports::Number>(fed_ports | (1U << anchor_port));
    return fed_ports != 0 && !log.exhausted() && log.front().ports() == alone ? process->fed_iterations() : 0;
}

unsigned Group::other_end(unsigned member, unsigned port) const {
    Inner const& inner = fifos_[fifo_at_[member][port]];
    return inner.writer == member ? inner.reader : inner.writer;
}

}  // namespace dataflow::timing
