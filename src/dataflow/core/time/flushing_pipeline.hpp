#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "dataflow/base/cycles.hpp"

namespace dataflow::timing {

/// The tokens in a flushing pipeline that freezes as a whole (docs/timing-model.md#a-flushing-pipeline-that-freezes),
/// seen from the next step of its process: one step a cycle, each of which takes a token in or a bubble. A token leaves
/// some steps after the one that took it in; a step whose token finds no room in the FIFO behind the pipeline stands
/// still until there is. Nothing in the pipeline moves then.
///
/// When a token leaves depends on those before it only, so it is known as soon as there is known to be room, even if
/// nobody knows yet what earlier steps take in. Tokens that have left are kept as long as steps to come have to wait
/// for theirs.
template <class Time> class FlushingPipeline {
  public:
    struct Token {
        Time steps = 0;   ///< from the next step to the one in which it leaves
        Time frozen = 0;  ///< cycles for which that step stands still, if the token has left
        /// Cycles between what decided when it leaves and that: it was taken in, or another step ended standing still.
        Time flight = 0;
        bool was_frozen = false;  ///< the latter
    };
    /// Where a token can be taken in, or, if `is_open`, from which step on nothing is known.
    struct Step {
        Time cycle = 0;
        Time steps = 0;            ///< from the next one
        std::size_t passed = 0;    ///< tokens that leave before it, or in it
        bool ends_freeze = false;  ///< it is the one that was waited for longest
        bool is_open = false;      ///< a token leaves in this step, and nobody knows when
    };

    std::vector<Token> const& tokens() const { return tokens_; }
    bool is_empty() const { return tokens_.empty(); }
    /// Tokens for which there is not known to be room.
    bool is_waiting() const { return left_ < tokens_.size(); }
    std::size_t left() const { return left_; }
    void clear() {
        tokens_.clear();
        left_ = 0;
    }
    /// As another one has been; those that have left first.
    void restore(Token const& token, bool has_left) {
        tokens_.push_back(token);
        left_ += has_left ? 1 : 0;
    }

    /// The first step, from `time` on, the cycle of the next one, that is not before `earliest`.
    Step step_from(Time time, Time earliest) const {
        Step step;
        step.cycle = std::max(time, earliest);
        Time frozen = 0;
        for (; step.passed < tokens_.size(); ++step.passed) {
            Token const& token = tokens_[step.passed];
            Time const due = time + token.steps + frozen;
            if (step.cycle < due)
                break;
            if (step.passed >= left_) {
                step.cycle = due;
                step.is_open = true;
                break;
            }
            frozen += token.frozen;
            step.ends_freeze = token.frozen > 0 && due + token.frozen >= step.cycle;
            step.cycle = std::max(step.cycle, due + token.frozen);
        }
        step.steps = step.cycle - time - frozen;
        return step;
    }
    /// So many steps behind the next one.
    Step step_after(Time time, Time steps) const {
        Step step;
        step.steps = steps;
        for (; step.passed < tokens_.size() && tokens_[step.passed].steps < steps; ++step.passed) {
            if (step.passed >= left_) {
                step.steps = tokens_[step.passed].steps;
                step.is_open = true;
                break;
            }
            time += tokens_[step.passed].frozen;
        }
        step.cycle = time + step.steps;
        return step;
    }
    /// The next step is that one now.
    void go_to(Step const& step) {
        tokens_.erase(tokens_.begin(), tokens_.begin() + static_cast<std::ptrdiff_t>(step.passed));
        left_ -= step.passed;
        for (Token& token : tokens_)
            token.steps -= step.steps;
    }

    /// The step at hand takes a token in, which leaves `stages` steps later.
    void take_in(Time stages) {
        Token token{stages, 0, stages, false};
        if (left_ > 0) {
            token.flight -= tokens_[left_ - 1].steps;
            token.was_frozen = true;
        }
        tokens_.push_back(token);
    }

    /// Lets tokens out in order, as long as there is known to be room, from `time` on, the cycle of the next step.
    /// `has_room()`: whether there is for one more; `earliest()`: the cycle from which on; `leaves(token, due, cycle)`:
    /// it leaves in a cycle, and was due before.
    template <class HasRoom, class Earliest, class Leaves>
    void let_out(Time time, HasRoom has_room, Earliest earliest, Leaves leaves) {
        for (std::size_t i = 0; i < left_; ++i)
            time += tokens_[i].frozen;
        while (is_waiting() && has_room()) {
            Token& token = tokens_[left_];
            Time const due = time + token.steps;
            Time const cycle = std::max(due, earliest());
            token.frozen = cycle - due;
            if (token.frozen > 0)
                for (std::size_t i = left_; i < tokens_.size(); ++i)
                    freeze(tokens_[i], token.steps);
            leaves(Token(token), due, cycle);
            time += token.frozen;
            if (token.frozen > 0)
                ++left_;
            else
                tokens_.erase(tokens_.begin() + static_cast<std::ptrdiff_t>(left_));
        }
    }

    /// The first cycle behind all that is known of it, not before `time`, the cycle of the next step.
    Time end(Time time) const {
        Time frozen = 0;
        for (std::size_t i = 0; i < left_; ++i)
            frozen += tokens_[i].frozen;
        return left_ == 0 ? time : time + tokens_[left_ - 1].steps + frozen;
    }

  private:
    static void freeze(Token& token, Time steps) {
        token.flight = token.steps - steps;
        token.was_frozen = true;
    }

    std::vector<Token> tokens_;
    std::size_t left_ = 0;  ///< of them, at first, have left
};

}  // namespace dataflow::timing
