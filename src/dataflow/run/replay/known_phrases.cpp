#include "dataflow/run/replay/known_phrases.hpp"

#include <algorithm>

namespace dataflow::replay {

namespace {

using timing::Operation;
using timing::Phrase;

/// Follows one phrase, from the loop or the place outside loops that each member's first operation needs.
class PhraseReader {
  public:
    explicit PhraseReader(timing::Group const& group) {
        for (timing::Group::Member const& member : group.members()) {
            checks_.emplace_back(*member.process);
            checks_.back().set_state({false, true, enough_setups});  // no phrase stamps
        }
    }

    void take(unsigned member, Operation const& operation) {
        OperationCheck& check = checks_[member];
        std::uint32_t const bit = 1U << member;
        if ((effect_.members & bit) == 0) {
            bool const in_loop = OperationCheck::is_in_loop_at(operation);
            check.set_state({in_loop, true, enough_setups});
            effect_.begin_in_loop |= in_loop ? bit : 0;
        }
        effect_.members |= bit;
        good_ = good_ && check.accepts(operation) && (member == 0 || setups(member) == 0);
        effect_.least_setups = std::min(effect_.least_setups, setups(0));
    }

    std::optional<KnownPhrases::Effect> effect() const {
        if (!good_)
            return std::nullopt;
        KnownPhrases::Effect effect = effect_;
        for (unsigned m = 0; m < checks_.size(); ++m)
            effect.end_in_loop |= (effect.members & (1U << m)) != 0 && checks_[m].state().in_loop ? 1U << m : 0;
        effect.setups = setups(0);
        return effect;
    }

  private:
    static constexpr std::int64_t enough_setups = std::int64_t{1} << 40;  // so that none is missed
    std::int64_t setups(unsigned member) const { return checks_[member].state().setups - enough_setups; }

    std::vector<OperationCheck> checks_;
    KnownPhrases::Effect effect_;
    bool good_ = true;
};

}  // namespace

std::optional<KnownPhrases::Number> KnownPhrases::number_of(Phrase::Code const* codes, std::size_t size) {
    if (size == 0 || size > Phrase::longest)
        return std::nullopt;
    phrase_.assign(codes, static_cast<unsigned>(size), 0);
    if (std::optional<Number> const known = book_.find(phrase_))
        return known;
    if (!Phrase::is_readable(codes, size, lead_.group))
        return std::nullopt;
    std::optional<Effect> const effect = this->effect();
    if (!effect)
        return std::nullopt;
    effects_.push_back(*effect);
    phrase_.recall(codes, static_cast<unsigned>(size), lead_.group);
    return book_.number_of(phrase_, lead_.group);
}

std::optional<KnownPhrases::Effect> KnownPhrases::effect() const {
    PhraseReader reader(lead_.group);
    Phrase::each(
        phrase_.codes(), phrase_.size(),
        [&reader](unsigned member, Operation const& operation) { reader.take(member, operation); },
        [](unsigned /*member*/, timing::Ports::Number /*next_ports*/, bool /*frozen*/) {});
    return reader.effect();
}

PhraseCheck::PhraseCheck(timing::Group const& group, std::vector<OperationCheck> const& checks)
    : group_(group), setups_(checks[index_of(0)].state().setups) {
    for (std::size_t m = 0; m < group.members().size(); ++m)
        in_loop_ |= checks[index_of(m)].state().in_loop ? 1U << m : 0;
}

void PhraseCheck::move_on(std::vector<OperationCheck>& checks) const {
    for (std::size_t m = 0; m < group_.members().size(); ++m) {
        OperationCheck::State state = checks[index_of(m)].state();
        state.in_loop = ((in_loop_ >> m) & 1U) != 0;
        state.setups = m == 0 ? setups_ : state.setups;
        state.loop = OperationCheck::unknown_loop;
        checks[index_of(m)].set_state(state);
    }
}

}  // namespace dataflow::replay
