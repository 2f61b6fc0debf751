#pragma once
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "dataflow/phrases/phrase_book.hpp"
#include "dataflow/run/replay/lead_core.hpp"
#include "dataflow/run/replay/operation_check.hpp"

namespace dataflow::replay {

/// The phrases that a file was found to hold, each looked at once: what is read may say anything.
class KnownPhrases {
  public:
    using Number = timing::PhraseBook::Number;

    /// What a phrase asks of the members that take part, and how it leaves them; a bit each.
    struct Effect {
        std::uint32_t members = 0;
        std::uint32_t begin_in_loop = 0;
        std::uint32_t end_in_loop = 0;
        std::int64_t least_setups = 0;  ///< of the driver, begun and not awaited, beyond those at the begin
        std::int64_t setups = 0;        ///< at the end
    };

    /// Of lead groups like that.
    explicit KnownPhrases(LeadCore lead) : lead_(std::move(lead)) {}
    LeadCore const& lead() const { return lead_; }

    /// None if it is no phrase, or no group could do it, wherever its members are.
    std::optional<Number> number_of(timing::Phrase::Code const* codes, std::size_t size);
    Effect const& operator[](Number number) const { return effects_[number]; }
    timing::PhraseBook const& book() const { return book_; }
    timing::PhraseBook take_book() && { return std::move(book_); }

  private:
    std::optional<Effect> effect() const;

    LeadCore lead_;
    timing::PhraseBook book_;
    std::vector<Effect> effects_;  ///< by number
    timing::Phrase phrase_;
};

/// Whether a group can do known phrases one after the other.
class PhraseCheck {
  public:
    /// Begins where checks of the core's processes are.
    PhraseCheck(timing::Group const& group, std::vector<OperationCheck> const& checks);
    bool accepts(KnownPhrases::Effect const& effect) {
        if ((in_loop_ & effect.members) != effect.begin_in_loop || setups_ + effect.least_setups < 0)
            return false;
        in_loop_ = (in_loop_ & ~effect.members) | effect.end_in_loop;
        setups_ += effect.setups;
        return true;
    }
    /// Moves the checks to where the phrases left the processes.
    void move_on(std::vector<OperationCheck>& checks) const;

  private:
    std::size_t index_of(std::size_t member) const { return group_.members()[member].process->index(); }

    timing::Group const& group_;
    std::uint32_t in_loop_ = 0;  ///< members, a bit each
    std::int64_t setups_ = 0;
};

}  // namespace dataflow::replay
