#include "timing/phrase_cutter.hpp"

#include "timing/core_timing.hpp"

namespace faster::timing {

PhraseCutter::PhraseCutter(CoreTiming const& core, Lead const& lead)
    : core_(core.blank_copy()),
      group_(*core_, lead),
      ends_(group_.members().size()),
      log_ends_(Transition::most_members) {}

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
    if (pieces.size() > 1 && is_all_read())
        book.set_pieces(number, pieces);
}

/// False if it is one after which a member is out of the game.
bool PhraseCutter::write(PhraseBook const& book, PhraseBook::Number number) {
    PhraseBook::Entry const& entry = book[number];
    for (unsigned m = 0; m < group_.members().size(); ++m) {
        log(m).clear();
        log_ends_[m] = 0;
    }
    bool freezes = false;
    Phrase::write(book.codes(number), entry.size, group_,
                  [this, &freezes](unsigned member, std::uint8_t next_ports, bool frozen) {
                      log_ends_[member] = next_ports;
                      freezes = freezes || frozen;
                  });
    for (unsigned m = 1; m < group_.members().size(); ++m)
        write_end(m, log_ends_[m]);
    return !freezes;
}

/// What a follower goes on with, if that answers the driver: what is read up to there then looks as it would in the
/// middle of a phrase.
void PhraseCutter::write_end(unsigned member, std::uint8_t next_ports) {
    bool const answers = (next_ports & (1U << group_.members()[member].anchor_port)) != 0;
    ends_[member] = answers ? 1 : 0;
    if (answers)
        log(member).append(Operation(Operation::Kind::iterate, next_ports, 0, 1));
}

bool PhraseCutter::is_all_read() const {
    for (unsigned m = 0; m < group_.members().size(); ++m)
        if (log(m).pending() != ends_[m])
            return false;
    return true;
}

}  // namespace faster::timing
