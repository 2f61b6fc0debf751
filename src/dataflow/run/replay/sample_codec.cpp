#include "dataflow/run/replay/sample_codec.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "dataflow/base/little_endian.hpp"
#include "dataflow/run/replay/bytes.hpp"
#include "dataflow/run/replay/operation_columns.hpp"

namespace dataflow::replay {

namespace {

using timing::PhraseBook;
using Code = timing::Phrase::Code;

/// Numbers of `width` bytes each, little-endian.
template <std::size_t width, class Numbers>
void put_all(Numbers const* numbers, std::size_t count, std::string& bytes) {
    std::size_t at = bytes.size();
    bytes.resize(at + count * width);
    for (std::size_t i = 0; i < count; ++i, at += width)
        put_little_endian<width>(numbers[i], &bytes[at]);
}

/// Calls `act` with the bytes of a number below `count`, as a constant.
template <class Act> auto with_width_for(std::size_t count, Act act) {
    if (count <= 0x100)
        return act(std::integral_constant<std::size_t, 1>());
    if (count <= 0x10000)
        return act(std::integral_constant<std::size_t, 2>());
    return act(std::integral_constant<std::size_t, 4>());
}

void put_phrases(ScriptedSample const& sample, PhraseBook const& book, std::string& bytes) {
    for (timing::Ports::Number const ports : sample.script.next_ports)
        put_number(bytes, ports);
    put_number(bytes, book.size());
    for (PhraseBook::Number i = 0; i < book.size(); ++i)
        put_number(bytes, book[i].size);
    for (PhraseBook::Number i = 0; i < book.size(); ++i)
        put_all<sizeof(Code)>(book.codes(i), book[i].size, bytes);
    put_number(bytes, sample.phrases.size());
    auto const put = [&](auto width) {
        put_all<decltype(width)::value>(sample.phrases.data(), sample.phrases.size(), bytes);
    };
    with_width_for(book.size(), put);
}

/// A phrase of a sample, with all that is asked about it each time it occurs.
struct OwnPhrase {
    PhraseBook::Number number;  ///< in the book of all
    std::uint32_t due;
    KnownPhrases::Effect effect;
};

bool read_book(ByteReader& bytes, KnownPhrases& known, std::vector<OwnPhrase>& phrases) {
    std::uint64_t const count = bytes.number();
    if (count > bytes.left())
        return false;
    std::vector<std::uint64_t> sizes(count);
    for (std::uint64_t& size : sizes)
        size = bytes.number();
    std::array<Code, timing::Phrase::longest> codes{};
    for (std::uint64_t const size : sizes) {
        if (size > codes.size())
            return false;
        std::string_view const coded = bytes.bytes(size * sizeof(Code));
        for (std::size_t i = 0; i < coded.size() / sizeof(Code); ++i)
            codes[i] = little_endian_at<sizeof(Code)>(coded.data() + i * sizeof(Code));
        std::optional<PhraseBook::Number> const number = known.number_of(codes.data(), coded.size() / sizeof(Code));
        if (!number)
            return false;
        phrases.push_back({*number, known.book()[*number].due, known[*number]});
    }
    return true;
}

/// Each phrase must be one that begins where the ones before it left the processes.
template <std::size_t width>
bool read_numbers(std::string_view bytes, std::vector<OwnPhrase> const& phrases, PhraseCheck& check,
                  ScriptedSample& sample) {
    char const* at = bytes.data();
    std::uint64_t due = 0;
    for (PhraseBook::Number& phrase : sample.phrases) {
        std::uint64_t const number = little_endian_at<width>(at);
        at += width;
        if (number >= phrases.size() || !check.accepts(phrases[number].effect))
            return false;
        phrase = phrases[number].number;
        due += phrases[number].due;
    }
    sample.script.due = due;
    return true;
}

/// Only of FIFOs inside the group.
bool read_next_ports(ByteReader& bytes, timing::Group const& group, timing::Script& script) {
    for (std::size_t m = 0; m < script.next_ports.size(); ++m) {
        std::uint64_t const ports = bytes.number();
        timing::Ports::Number const inner =
            m > 0 && m < group.members().size() ? group.members()[m].inner_ports : timing::Ports::Number{0};
        if ((ports & ~std::uint64_t{inner}) != 0)
            return false;
        script.next_ports[m] = static_cast<timing::Ports::Number>(ports);
    }
    return true;
}

bool read_phrases(ByteReader& bytes, KnownPhrases& known, PhraseCheck& check, ScriptedSample& sample) {
    std::vector<OwnPhrase> phrases;
    if (!read_next_ports(bytes, known.lead().group, sample.script) || !read_book(bytes, known, phrases))
        return false;
    std::uint64_t const count = bytes.number();
    if (count > bytes.left() || count > ScriptedSample::most_phrases || (count > 0 && !known.lead().has_followers()))
        return false;
    sample.phrases.resize(count);
    return with_width_for(phrases.size(), [&](auto width) {
        std::string_view const coded = bytes.bytes(count * width);
        return bytes.good() && read_numbers<decltype(width)::value>(coded, phrases, check, sample);
    });
}

bool read_operations(ByteReader& bytes, std::vector<OperationCheck>& checks, SampleOperations& operations) {
    operations.resize(checks.size());
    for (std::size_t i = 0; i < operations.size(); ++i)
        if (!decode_operations(bytes, checks[i], operations[i]))
            return false;
    return true;
}

}  // namespace

std::string encode(ScriptedSample const& sample, PhraseBook const& book) {
    std::string bytes;
    for (std::vector<timing::Operation> const& process : sample.before)
        encode_operations(process, bytes);
    put_phrases(sample, book, bytes);
    for (std::vector<timing::Operation> const& process : sample.after)
        encode_operations(process, bytes);
    return bytes;
}

bool decode(std::string_view bytes, KnownPhrases& known, ScriptedSample& sample) {
    sample = ScriptedSample();
    ByteReader reader(bytes);
    timing::Group const& group = known.lead().group;
    std::vector<OperationCheck> checks;
    for (timing::ProcessTiming const& process : known.lead().core->processes())
        checks.emplace_back(process);
    if (!read_operations(reader, checks, sample.before))
        return false;
    PhraseCheck phrases(group, checks);
    if (!read_phrases(reader, known, phrases, sample))
        return false;
    phrases.move_on(checks);
    if (!read_operations(reader, checks, sample.after))
        return false;
    // It goes on with its next sample before that of the others is there.
    bool const is_supplied =
        !group.has_supplier() || sample.after[group.members()[group.supplier()].process->index()].empty();
    return reader.done() && is_supplied &&
           std::all_of(checks.begin(), checks.end(), [](OperationCheck const& check) { return check.is_done(); });
}

}  // namespace dataflow::replay
