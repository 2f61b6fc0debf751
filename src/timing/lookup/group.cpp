#include "timing/lookup/group.hpp"

#include <stdexcept>

#include "timing/core_timing.hpp"

namespace faster::timing {

namespace {
constexpr unsigned none = ~0U;
}

Group::Group(CoreTiming& core, Lead const& lead) {
    if (lead.followers.size() > sizeof(Lanes) * 8 / lane_bits)
        throw std::logic_error("a lead has at most 4 followers");
    members_.push_back({&core.process(lead.driver), 0, 0, false, 0});
    for (Lead::Follower const& follower : lead.followers)
        members_.push_back({&core.process(follower.process), 0, 0, false, 0});
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
            if (found != none)
                members_[m].inner_ports |= static_cast<std::uint8_t>(1U << port);
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
                members_[m].driver_port = static_cast<std::uint8_t>(1U << port);
    }
    for (unsigned m = 1; m < members_.size(); ++m) {
        if (!members_[m].writes_anchor)
            readers_ |= 1U << m;
        else if (supplier_ == 0)
            supplier_ = m;
    }
    for (unsigned ports = 0; ports < followers_at_.size(); ++ports)
        for (unsigned m = 1; m < members_.size(); ++m)
            if ((ports & members_[m].driver_port) != 0)
                followers_at_[ports] |= Lanes{1} << (lane_bits * (m - 1));
}

unsigned Group::other_end(unsigned member, unsigned port) const {
    Inner const& inner = fifos_[fifo_at_[member][port]];
    return inner.writer == member ? inner.reader : inner.writer;
}

}  // namespace faster::timing
