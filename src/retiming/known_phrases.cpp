#include "retiming/known_phrases.hpp"

#include <algorithm>

namespace faster::retiming {

namespace {

using timing::Operation;
using timing::Phrase;

/// Follows one phrase, from the loop or the place outside loops that each member's first operation needs.
class PhraseReader {
  public:
    explicit PhraseReader(timing::Group const& group) : group_(group) {
        for (timing::Group::Member const& member : group.members()) {
            checks_.emplace_back(*member.process);
            checks_.back().stamped = true;  // in no phrase
        }
        checks_.front().setups = most_setups;
    }

    void take(unsigned member, Operation const& operation) {
        OperationCheck& check = checks_[member];
        std::uint32_t const bit = 1U << member;
        if ((effect_.members & bit) == 0) {
            check.in_loop = OperationCheck::is_in_loop_at(operation);
            effect_.begin_in_loop |= check.in_loop ? bit : 0;
        }
        effect_.members |= bit;
        bool const iterates = operation.kind() == Operation::Kind::iterate && operation.ports() != 0;
        bool const is_countable = member > 0 || !iterates || operation.count() <= Phrase::most_iterations;
        good_ = good_ && is_countable && check.accepts(operation) && (member == 0 || check.setups == 0);
        effect_.least_setups = std::min(effect_.least_setups, checks_.front().setups - most_setups);
    }

    /// The supplier's operations are in no phrase, and the driver takes part in each.
    bool good() const {
        std::uint32_t const supplier = group_.has_supplier() ? 1U << group_.supplier() : 0;
        return good_ && (effect_.members & 1U) != 0 && (effect_.members & supplier) == 0;
    }
    KnownPhrases::Effect effect() const {
        KnownPhrases::Effect effect = effect_;
        for (std::size_t m = 0; m < checks_.size(); ++m)
            effect.end_in_loop |= (effect.members & (1U << m)) != 0 && checks_[m].in_loop ? 1U << m : 0;
        effect.setups = checks_.front().setups - most_setups;
        return effect;
    }

  private:
    static constexpr std::int64_t most_setups = std::int64_t{1} << 40;  // so that none is missed

    timing::Group const& group_;
    std::vector<OperationCheck> checks_;
    KnownPhrases::Effect effect_;
    bool good_ = true;
};

}  // namespace

std::optional<KnownPhrases::Number> KnownPhrases::number_of(Phrase::Code const* codes, std::size_t size) {
    if (size == 0 || size > Phrase::most_codes + Phrase::most_members)
        return std::nullopt;
    phrase_.assign(codes, static_cast<unsigned>(size), 0);
    if (std::optional<Number> const known = book_.find(phrase_))
        return known;
    if (!Phrase::is_well_formed(codes, size, static_cast<unsigned>(group_->members().size())))
        return std::nullopt;
    std::optional<Effect> effect = this->effect();
    if (!effect)
        return std::nullopt;
    phrase_.recall(codes, static_cast<unsigned>(size), *group_);
    Number const number = book_.number_of(phrase_, *group_);
    effect->due = book_[number].due;
    effects_.push_back(*effect);
    return number;
}

std::optional<KnownPhrases::Effect> KnownPhrases::effect() const {
    PhraseReader reader(*group_);
    Phrase::each(
        phrase_.codes(), phrase_.size(),
        [&reader](unsigned member, Operation const& operation) { reader.take(member, operation); },
        [](unsigned /*member*/, std::uint8_t /*next_ports*/, bool /*frozen*/) {});
    return reader.good() ? std::optional<Effect>(reader.effect()) : std::nullopt;
}

PhraseCheck::PhraseCheck(timing::Group const& group, std::vector<OperationCheck> const& checks)
    : group_(group), setups_(checks[index_of(0)].setups) {
    for (std::size_t m = 0; m < group.members().size(); ++m)
        in_loop_ |= checks[index_of(m)].in_loop ? 1U << m : 0;
}

void PhraseCheck::move_on(std::vector<OperationCheck>& checks) const {
    for (std::size_t m = 0; m < group_.members().size(); ++m)
        checks[index_of(m)].in_loop = ((in_loop_ >> m) & 1U) != 0;
    checks[index_of(0)].setups = setups_;
}

}  // namespace faster::retiming
