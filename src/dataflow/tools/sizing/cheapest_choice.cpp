#include "dataflow/tools/sizing/cheapest_choice.hpp"

namespace dataflow::sizing {

namespace {

/// What the branch at hand asks of a FIFO.
struct Demand {
    std::uint64_t more_than = 0;  ///< tokens of capacity
    bool fast = false;            ///< a read latency of one cycle
};

class BranchAndBound {
  public:
    BranchAndBound(Levels const& levels, std::vector<Cut> const& cuts)
        : levels_(levels), cuts_(cuts), demands_(levels.size()), chosen_(levels.size()), choice_(levels.size()) {}

    std::optional<Choice> run() {
        for (std::size_t i = 0; i < levels_.size(); ++i)
            if (!choose(i))
                return std::nullopt;
        branch();
        return best_;
    }

  private:
    /// The cheapest level of a FIFO that does what is demanded; false if none does.
    bool choose(std::size_t fifo) {
        Demand const& demand = demands_[fifo];
        for (Level const& level : levels_[fifo])
            if (level.choice.capacity() > demand.more_than && (!demand.fast || level.choice.read_latency() < 2)) {
                cost_ += level.cost - (chosen_[fifo] == nullptr ? 0 : chosen_[fifo]->cost);
                chosen_[fifo] = &level;
                choice_[fifo] = level.choice;
                return true;
            }
        return false;
    }

    /// The smallest, which leaves the fewest branches.
    Cut const* open_cut() const {
        Cut const* open = nullptr;
        for (Cut const& cut : cuts_)
            if (!cut.is_escaped(choice_) && (open == nullptr || cut.members.size() < open->members.size()))
                open = &cut;
        return open;
    }

    void branch() {
        if (best_ && cost_ >= best_cost_ - cost_rounding)
            return;
        Cut const* cut = open_cut();
        if (cut == nullptr) {
            best_ = choice_;
            best_cost_ = cost_;
            return;
        }
        for (Cut::Member const& member : cut->members) {
            Demand deeper = demands_[member.fifo];
            deeper.more_than = std::max(deeper.more_than, member.capacity);
            if (member.capacity > 0)
                branch_with(member.fifo, deeper);
            Demand faster = demands_[member.fifo];
            faster.fast = true;
            if (member.is_slow)
                branch_with(member.fifo, faster);
        }
    }

    void branch_with(std::size_t fifo, Demand const& demand) {
        Demand const demand_before = demands_[fifo];
        Level const* const level_before = chosen_[fifo];
        double const cost_before = cost_;
        demands_[fifo] = demand;
        if (choose(fifo))
            branch();
        demands_[fifo] = demand_before;
        chosen_[fifo] = level_before;
        choice_[fifo] = level_before->choice;
        cost_ = cost_before;
    }

    Levels const& levels_;
    std::vector<Cut> const& cuts_;
    std::vector<Demand> demands_;       ///< by FIFO
    std::vector<Level const*> chosen_;  ///< by FIFO
    Choice choice_;
    double cost_ = 0;
    std::optional<Choice> best_;
    double best_cost_ = 0;
};

}  // namespace

Primitives sum_of(Choice const& choice, Freedoms const& fifos, CostWeights const& weights) {
    Primitives sum;
    for (std::size_t i = 0; i < choice.size(); ++i) {
        Primitives const fifo = primitives_of(choice[i], fifos[i], weights);
        sum.luts += fifo.luts;
        sum.ramb18 += fifo.ramb18;
    }
    return sum;
}

std::optional<Choice> cheapest_choice(Levels const& levels, std::vector<Cut> const& cuts) {
    return BranchAndBound(levels, cuts).run();
}

}  // namespace dataflow::sizing
