#pragma once
#include <algorithm>
#include <functional>
#include <utility>

#include "dataflow/tools/sizing/size_fifos.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::testing {

/// All combinations of levels that cost less than some cost, up to the depths of a sizing's unbounded FIFOs.
class CheaperChoices {
  public:
    CheaperChoices(sizing::Sizing const& sizing, double cost, std::function<Cycles(sizing::Choice const&)> cycles)
        : sizing_(sizing), cost_(cost), cycles_(std::move(cycles)), least_(sizing.unbounded.choice.size() + 1) {
        sizing::Freedoms const freedoms = sizing::freedoms_of(sizing.machine);
        for (std::size_t i = 0; i < freedoms.size(); ++i) {
            std::uint64_t const depth = std::max<std::uint64_t>(3, sizing.unbounded.choice[i].depth);
            levels_.push_back(levels_of(freedoms[i], depth, sizing.options.weights));
        }
        for (std::size_t i = levels_.size(); i-- > 0;)
            least_[i] = least_[i + 1] + levels_[i].front().cost;
    }

    /// How many there are; too many are not counted to the end.
    std::size_t count() {
        only_counts_ = true;
        tried_ = 0;
        try_all(0, 0);
        return tried_;
    }
    /// How many of them are within the bound: tries them all.
    std::size_t count_within() {
        only_counts_ = false;
        try_all(0, 0);
        return found_;
    }
    static constexpr std::size_t most = 400;

  private:
    void try_all(std::size_t fifo, double cost) {
        if (cost + least_[fifo] >= cost_ - 1e-6 || (only_counts_ && tried_ > most))
            return;
        if (fifo == levels_.size()) {
            ++tried_;
            found_ += !only_counts_ && cycles_(choice_) <= sizing_.bound ? 1U : 0U;
            return;
        }
        for (sizing::Level const& level : levels_[fifo]) {
            choice_[fifo] = level.choice;
            try_all(fifo + 1, cost + level.cost);
        }
    }

    sizing::Sizing const& sizing_;
    double cost_;
    std::function<Cycles(sizing::Choice const&)> cycles_;
    sizing::Levels levels_;
    std::vector<double> least_;
    sizing::Choice choice_ = sizing::Choice(sizing_.unbounded.choice.size());
    bool only_counts_ = false;
    std::size_t tried_ = 0;
    std::size_t found_ = 0;
};

}  // namespace faster::testing
