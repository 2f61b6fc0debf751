#include "dataflow/core/time/path_sums.hpp"

namespace dataflow::timing {

void PathSums::add(PathSums const& other, PathSums const& base, std::uint64_t times) {
    for (std::size_t i = 0; i < own_.size(); ++i)
        own_[i] += times * (other.own_[i] - base.own_[i]);
    for (std::size_t i = 0; i < turns_.size(); ++i)
        turns_[i] += times * (other.turns_[i] - base.turns_[i]);
}

void PathSums::add(PathSums const& other) {
    for (std::size_t i = 0; i < own_.size(); ++i)
        own_[i] += other.own_[i];
    for (std::size_t i = 0; i < turns_.size(); ++i)
        turns_[i] += other.turns_[i];
}

}  // namespace dataflow::timing
