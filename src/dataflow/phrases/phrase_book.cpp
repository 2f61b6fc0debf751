#include "dataflow/phrases/phrase_book.hpp"

namespace dataflow::timing {

namespace {
constexpr std::uint64_t print_number = 1;  // any but 0, with which a first code of 0 would hide the second
}

PhraseBook::Number PhraseBook::number_of(Phrase const& phrase, Group const& group, Compare compare) {
    return number_of(phrase, phrase.due_of_supplier(group), compare);
}

PhraseBook::Number PhraseBook::number_of(PhraseBook const& other, Number number) {
    Entry const& entry = other[number];
    Phrase phrase;
    phrase.assign(other.codes(number), entry.size, entry.active);
    return number_of(phrase, entry.due, Compare::codes);
}

std::vector<PhraseBook::Number> PhraseBook::numbers_of(PhraseBook const& other) {
    std::vector<Number> numbers;
    for (Number number = 0; number < other.size(); ++number)
        numbers.push_back(number_of(other, number));
    return numbers;
}

PhraseBook::Number PhraseBook::number_of(Phrase const& phrase, std::uint32_t due, Compare compare) {
    Print const print = phrase.print(print_number);
    if (Numbered const* const known = find(phrase, print, compare))
        return known->number;
    auto const number = static_cast<Number>(entries_.size());
    entries_.push_back({static_cast<std::uint32_t>(codes_.size()), phrase.size(), phrase.active(), due, 0, 0});
    codes_.insert(codes_.end(), phrase.codes(), phrase.codes() + phrase.size());
    numbers_.add({print, number});
    return number;
}

std::optional<PhraseBook::Number> PhraseBook::find(Phrase const& phrase) const {
    Numbered const* const known = find(phrase, phrase.print(print_number), Compare::codes);
    return known == nullptr ? std::nullopt : std::optional<Number>(known->number);
}

PhraseBook::Numbered const* PhraseBook::find(Phrase const& phrase, Print const& print, Compare compare) const {
    return numbers_.find(print.first, [&](Numbered const& known) {
        return known.print == print && (compare == Compare::prints || is(known.number, phrase));
    });
}

bool PhraseBook::is(Number number, Phrase const& phrase) const {
    Phrase::Code const* const known = codes(number);
    bool equal = entries_[number].size == phrase.size();
    for (unsigned i = 0; equal && i < phrase.size(); ++i)
        equal = known[i] == phrase.codes()[i];
    return equal;
}

void PhraseBook::clear() {
    codes_.clear();
    entries_.clear();
    pieces_.clear();
    numbers_.clear();
}

void PhraseBook::set_pieces(Number number, std::vector<Number> const& pieces) {
    entries_[number].first_piece = static_cast<std::uint32_t>(pieces_.size());
    entries_[number].pieces = static_cast<std::uint32_t>(pieces.size());
    pieces_.insert(pieces_.end(), pieces.begin(), pieces.end());
}

void write_next(Group const& group, Script& script) {
    PhraseBook::Number const number = *script.next++;
    PhraseBook::Entry const& entry = (*script.book)[number];
    script.due -= entry.due;
    Phrase::write(
        script.book->codes(number), entry.size, group,
        [&script](unsigned member, Ports::Number next_ports, bool) { script.next_ports[member] = next_ports; });
}

}  // namespace dataflow::timing
