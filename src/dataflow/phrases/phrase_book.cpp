#include "dataflow/phrases/phrase_book.hpp"

#include <algorithm>

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
    std::size_t const place = place_of(phrase, print, compare);
    if (buckets_[place].number != none)
        return buckets_[place].number;
    auto const number = static_cast<Number>(entries_.size());
    entries_.push_back({static_cast<std::uint32_t>(codes_.size()), phrase.size(), phrase.active(), due, 0, 0});
    codes_.insert(codes_.end(), phrase.codes(), phrase.codes() + phrase.size());
    buckets_[place] = {print, number};
    if (2 * entries_.size() > buckets_.size())
        grow();
    return number;
}

std::optional<PhraseBook::Number> PhraseBook::find(Phrase const& phrase) const {
    Number const number = buckets_[place_of(phrase, phrase.print(print_number), Compare::codes)].number;
    return number == none ? std::nullopt : std::optional<Number>(number);
}

/// Where it is, or has to be put.
std::size_t PhraseBook::place_of(Phrase const& phrase, Print const& print, Compare compare) const {
    auto const is_it = [&](Bucket const& place) {
        return place.print.first == print.first && place.print.second == print.second &&
               (compare == Compare::prints || is(place.number, phrase));
    };
    std::size_t const mask = buckets_.size() - 1;
    std::size_t place = print.first & mask;
    while (buckets_[place].number != none && !is_it(buckets_[place]))
        place = (place + 1) & mask;
    return place;
}

bool PhraseBook::is(Number number, Phrase const& phrase) const {
    Phrase::Code const* const known = codes(number);
    bool equal = entries_[number].size == phrase.size();
    for (unsigned i = 0; equal && i < phrase.size(); ++i)
        equal = known[i] == phrase.codes()[i];
    return equal;
}

void PhraseBook::grow() {
    std::vector<Bucket> old(2 * buckets_.size());
    old.swap(buckets_);
    for (Bucket const& known : old) {
        std::size_t place = known.print.first & (buckets_.size() - 1);
        while (known.number != none && buckets_[place].number != none)
            place = (place + 1) & (buckets_.size() - 1);
        if (known.number != none)
            buckets_[place] = known;
    }
}

void PhraseBook::clear() {
    codes_.clear();
    entries_.clear();
    pieces_.clear();
    std::fill(buckets_.begin(), buckets_.end(), Bucket());
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
