#include "dataflow/phrases/phrase_cutter.hpp"

#include "dataflow/core/time/core_timing.hpp"

namespace dataflow::timing {

PhraseCutter::PhraseCutter(CoreTiming const& core, Lead const& lead)
    : core_(core.blank_copy()), group_(*core_, lead), log_ends_(group_.members().size()) {}

PhraseCutter::~PhraseCutter() = default;

void PhraseCutter::cut(PhraseBook& book, PhraseBook::Number number) {
    if (!write(book, number))
        return;
    std::vector<PhraseBook::Number> pieces;
    phrase_.set_log_ends(log_ends_.data());
    while (phrase_.read_piece(group_) == Phrase::Reading::complete) {
        phrase_.consume();
        pieces.push_back(book.number_of(phrase_, group_));
    }
    if (pieces.size() > 1 && pieces.size() <= most_pieces && is_all_read())
        book.set_pieces(number, pieces);
}

void PhraseCutter::cut_from(PhraseBook& book, std::size_t first) {
    std::size_t const whole = book.size();
    for (std::size_t number = first; number < whole; ++number)
        cut(book, static_cast<PhraseBook::Number>(number));
}

/// With what followers go on with behind it, where that answers the driver, so that what is read up to there looks as
/// in the middle of a phrase. False if a member is out of the game after it.
bool PhraseCutter::write(PhraseBook const& book, PhraseBook::Number number) {
    PhraseBook::Entry const& entry = book[number];
    for (unsigned m = 0; m < group_.members().size(); ++m) {
        log(m).clear();
        log_ends_[m] = 0;
    }
    bool freezes = false;
    Phrase::write(book.codes(number), entry.size, group_,
                  [this, &freezes](unsigned member, Ports::Number next_ports, bool frozen) {
                      log_ends_[member] = next_ports;
                      freezes = freezes || frozen;
                  });
    for (unsigned m = 1; m < group_.members().size(); ++m)
        if (goes_on_answering(m))
            log(m).append(Operation(Operation::Kind::iterate, log_ends_[m], 0, 1));
    return !freezes;
}

bool PhraseCutter::goes_on_answering(unsigned member) const {
    return member != 0 && (log_ends_[member] & (1U << group_.members()[member].anchor_port)) != 0;
}

bool PhraseCutter::is_all_read() const {
    for (unsigned m = 0; m < group_.members().size(); ++m)
        if (log(m).pending() != (goes_on_answering(m) ? 1U : 0U))
            return false;
    return true;
}

}  // namespace dataflow::timing
