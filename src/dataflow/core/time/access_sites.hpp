#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>

#include "dataflow/base/source_site.hpp"

namespace dataflow::timing {

/// Where in the source a process accesses a port outside loops, or enters a loop: of each time, as far as that changes,
/// since a module may be far ahead of the time of what it has told.
class AccessSites {
  public:
    void note(SourceSite const& site) {
        if (told_ == 0 || !(site == last_))
            change_to(site);
        ++told_;
    }
    /// Of the first access that is remembered.
    SourceSite first() const { return changes_.empty() ? SourceSite() : changes_.front().site; }
    /// Of the access that so many have been told of and not done from, itself included.
    SourceSite of(std::uint64_t pending) const {
        std::uint64_t const access = told_ - std::min(pending, told_);
        for (std::size_t i = changes_.size(); i > 0; --i)
            if (changes_[i - 1].from <= access)
                return changes_[i - 1].site;
        return first();
    }

  private:
    static constexpr std::size_t most = std::size_t{1} << 16;
    struct Change {
        std::uint64_t from;  ///< accesses before it
        SourceSite site;
    };
    void change_to(SourceSite const& site) {
        last_ = site;
        changes_.push_back({told_, site});
        if (changes_.size() > most)
            changes_.pop_front();
    }

    std::deque<Change> changes_;
    SourceSite last_;
    std::uint64_t told_ = 0;
};

}  // namespace dataflow::timing
