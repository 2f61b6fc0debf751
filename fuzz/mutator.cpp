#include "fuzz/mutator.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace faster::fuzz {

namespace {

constexpr std::size_t most_bytes = 65536, longest_part = 64;

/// Numbers and marks on which readers have stumbled.
constexpr std::array<char const*, 24> words{"0",     "-1", "1",   "2147483648", "4294967296", "9223372036854775808",
                                            "1e999", "-0", "nan", "inf",        "1e-320",     "null",
                                            "true",  "[]", "{}",  "[[[[[[",     "{a: ",       "&a [*a, *a]",
                                            "\"",    "\n", ",",   ": ",         "\x1b[2J",    "\xff\xfe"};

bool is_of_number(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '.'; }

/// The number around a place, begin and end; empty if there is none.
std::pair<std::size_t, std::size_t> number_at(std::string const& bytes, std::size_t place) {
    std::size_t begin = place, end = place;
    while (begin > 0 && is_of_number(bytes[begin - 1]))
        --begin;
    while (end < bytes.size() && is_of_number(bytes[end]))
        ++end;
    return {begin, end};
}

}  // namespace

Mutator::Mutator(std::vector<std::string> inputs, std::uint64_t seed) : inputs_(std::move(inputs)), random_(seed) {}

std::string Mutator::next() {
    std::string bytes = any_input();
    for (std::size_t changes = 1 + below(8); changes > 0; --changes)
        change(bytes);
    bytes.resize(std::min(bytes.size(), most_bytes));
    return bytes;
}

std::size_t Mutator::below(std::size_t bound) { return bound == 0 ? 0 : random_() % bound; }

std::string const& Mutator::any_input() { return inputs_[below(inputs_.size())]; }

std::string Mutator::any_part() {
    std::string const& input = any_input();
    return input.substr(below(input.size()), 1 + below(longest_part));
}

void Mutator::change(std::string& bytes) {
    std::size_t const place = below(bytes.size());
    switch (below(7)) {
        case 0:
            bytes.insert(place, any_part());
            break;
        case 1:
            bytes.erase(place, 1 + below(longest_part));
            break;
        case 2:
            bytes.insert(place, words[below(words.size())]);
            break;
        case 3:
            bytes.replace(place, 1 + below(longest_part), any_part());
            break;
        case 4: {
            auto const [begin, end] = number_at(bytes, place);
            bytes.replace(begin, end - begin, words[below(words.size())]);
            break;
        }
        case 5:
            bytes.resize(place);
            break;  // a cut
        default:
            if (!bytes.empty())
                bytes[place] = static_cast<char>(static_cast<unsigned char>(bytes[place]) ^ (1U << below(8)));
    }
}

}  // namespace faster::fuzz
