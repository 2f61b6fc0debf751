#include "retiming/sample_codec.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "retiming/operation_check.hpp"

namespace faster::retiming {

namespace {

using timing::Operation;
using Kind = Operation::Kind;

/// What operations of one sort have in common.
struct Shape {
    Kind kind = Kind::wait;
    std::uint8_t ports = 0;
    std::uint8_t tail_ports = 0;

    bool has_count() const { return kind != Kind::leave && kind != Kind::stamp; }
    bool has_gap() const { return kind == Kind::wait || kind == Kind::iterate; }
};
constexpr std::size_t most_shapes = 256;

void put_number(std::string& bytes, std::uint64_t value) {
    for (; value >= 0x80; value >>= 7)
        bytes.push_back(static_cast<char>(0x80U | (value & 0x7FU)));
    bytes.push_back(static_cast<char>(value));
}

/// One column of a process's table. Operations come by the million: bytes are put without looking whether there is
/// room.
class Column {
  public:
    void clear(std::size_t most_bytes) {
        if (bytes_.size() < most_bytes)
            bytes_.resize(most_bytes);
        end_ = bytes_.data();
    }
    void put(std::uint32_t value) {
        for (; value >= 0x80; value >>= 7)
            *end_++ = static_cast<char>(0x80U | (value & 0x7FU));
        *end_++ = static_cast<char>(value);
    }
    void put_four_bytes(std::uint32_t value) {
        for (unsigned at = 0; at < 32; at += 8)
            *end_++ = static_cast<char>(value >> at);
    }
    std::string_view bytes() const { return {bytes_.data(), static_cast<std::size_t>(end_ - bytes_.data())}; }

  private:
    std::vector<char> bytes_;
    char* end_ = nullptr;
};

/// Numbers shapes in the order in which they occur.
class ShapeTable {
  public:
    std::uint32_t number_of(Operation const& operation) {
        std::uint32_t const key = key_of(operation);
        std::uint32_t& known = last_numbers_[key % last_numbers_.size()];
        if (known < keys_.size() && keys_[known] == key)
            return known;
        known = static_cast<std::uint32_t>(std::find(keys_.begin(), keys_.end(), key) - keys_.begin());
        if (known == keys_.size()) {
            keys_.push_back(key);
            shapes_.push_back({operation.kind(), operation.ports(), operation.tail_ports()});
        }
        return known;
    }
    Shape const& operator[](std::uint32_t number) const { return shapes_[number]; }
    std::vector<Shape> const& shapes() const { return shapes_; }

  private:
    static std::uint32_t key_of(Operation const& operation) {
        auto const kind = static_cast<std::uint32_t>(operation.kind());
        return (((kind << 8) | operation.ports()) << 8) | operation.tail_ports();
    }

    std::vector<std::uint32_t> keys_;
    std::vector<Shape> shapes_;
    std::array<std::uint32_t, 61> last_numbers_{};
};

/// The operations of one process after the other as columns: which shape; then what operations of that shape have, in
/// their order.
class ProcessEncoder {
  public:
    void put(std::vector<Operation> const& operations, std::string& bytes) {
        clear(operations.size());
        ShapeTable table;
        for (Operation const& operation : operations) {
            std::uint32_t const number = table.number_of(operation);
            shapes_.put(number);
            put(operation, table[number]);
        }
        put_number(bytes, operations.size());
        put_number(bytes, table.shapes().size());
        for (Shape const& shape : table.shapes())
            for (unsigned const byte :
                 {static_cast<unsigned>(shape.kind), unsigned{shape.ports}, unsigned{shape.tail_ports}})
                bytes.push_back(static_cast<char>(byte));
        for (Column const* column : {&shapes_, &counts_, &gaps_, &tail_gaps_, &mixes_}) {
            put_number(bytes, column->bytes().size());
            bytes += column->bytes();
        }
    }

  private:
    static constexpr std::size_t most_bytes_of_number = 4;  // a count: 25 bits; all others have fewer

    void clear(std::size_t operations) {
        for (Column* column : {&shapes_, &counts_, &gaps_, &tail_gaps_, &mixes_})
            column->clear(most_bytes_of_number * operations);
    }

    void put(Operation const& operation, Shape const& shape) {
        if (shape.kind == Kind::mixed) {
            counts_.put(operation.length());
            mixes_.put_four_bytes(operation.gaps());
            return;
        }
        if (shape.has_count())
            counts_.put(operation.count());
        if (shape.has_gap())
            gaps_.put(operation.gap());
        if (shape.tail_ports != 0)
            tail_gaps_.put(operation.tail_gap());
    }

    Column shapes_;
    Column counts_;
    Column gaps_;
    Column tail_gaps_;
    Column mixes_;
};

/// Takes numbers from bytes; remembers if there were too few.
class Reader {
  public:
    explicit Reader(std::string_view bytes) : at_(bytes.data()), end_(bytes.data() + bytes.size()) {}

    std::uint64_t number() {
        if (at_ != end_ && (static_cast<unsigned char>(*at_) & 0x80U) == 0)
            return static_cast<unsigned char>(*at_++);  // mostly
        return long_number();
    }
    unsigned byte() {
        if (at_ == end_) {
            good_ = false;
            return 0;
        }
        return static_cast<unsigned char>(*at_++);
    }
    Reader column() { return Reader(bytes(number())); }
    std::string_view bytes(std::uint64_t count) {
        if (count > left()) {
            good_ = false;
            return {};
        }
        at_ += count;
        return {at_ - count, static_cast<std::size_t>(count)};
    }
    std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
    bool good() const { return good_; }
    bool done() const { return good_ && at_ == end_; }

  private:
    std::uint64_t long_number() {
        std::uint64_t value = 0;
        for (unsigned shift = 0; shift < 63; shift += 7) {
            unsigned const next = byte();
            value |= std::uint64_t{next & 0x7FU} << shift;
            if ((next & 0x80U) == 0)
                return value;
        }
        good_ = false;
        return 0;
    }

    char const* at_;
    char const* end_;
    bool good_ = true;
};

/// Reads one process's operations, and checks that it can do them.
class ProcessDecoder {
  public:
    ProcessDecoder(Reader& bytes, OperationCheck& check) : bytes_(bytes), check_(check) {}

    bool decode(std::vector<Operation>& operations) {
        std::uint64_t const count = bytes_.number();
        if (!read_shapes() || count > bytes_.left())
            return false;
        for (Reader* column : {&numbers_, &counts_, &gaps_, &tail_gaps_, &mixes_})
            *column = bytes_.column();
        operations.resize(count);
        for (Operation& operation : operations)
            if (!read(operation) || !check_.accepts(operation))
                return false;
        return bytes_.good() && numbers_.done() && counts_.done() && gaps_.done() && tail_gaps_.done() && mixes_.done();
    }

  private:
    bool read_shapes() {
        std::uint64_t const count = bytes_.number();
        if (count > most_shapes)
            return false;
        for (std::uint64_t i = 0; i < count; ++i) {
            unsigned const kind = bytes_.byte();
            Shape shape;
            shape.ports = static_cast<std::uint8_t>(bytes_.byte());
            shape.tail_ports = static_cast<std::uint8_t>(bytes_.byte());
            if (kind > static_cast<unsigned>(Kind::flanked))
                return false;
            shape.kind = static_cast<Kind>(kind);
            shapes_.push_back(shape);
        }
        return true;
    }

    bool read(Operation& operation) {
        std::uint64_t const number = numbers_.number();
        if (number >= shapes_.size())
            return false;
        Shape const& shape = shapes_[number];
        if (shape.kind == Kind::mixed)
            return read_mix(shape, operation);
        std::uint64_t const count = shape.has_count() ? counts_.number() : 0;
        std::uint64_t const gap = shape.has_gap() ? gaps_.number() : 0;
        std::uint64_t const tail_gap = shape.tail_ports != 0 ? tail_gaps_.number() : 0;
        if (count > Operation::longest_count || gap > Operation::longest_gap || tail_gap > Operation::longest_gap)
            return false;
        operation =
            Operation(shape.kind, shape.ports, static_cast<std::uint32_t>(gap), static_cast<std::uint32_t>(count));
        operation.add_tail(shape.tail_ports, static_cast<std::uint32_t>(tail_gap));
        return true;
    }

    bool read_mix(Shape const& shape, Operation& operation) {
        std::uint64_t const length = counts_.number();
        std::uint32_t gaps = 0;
        for (unsigned at = 0; at < 32; at += 8)
            gaps |= std::uint32_t{mixes_.byte()} << at;
        operation = Operation::mix(shape.ports, static_cast<unsigned>(length & 0xFFU), gaps);
        return shape.tail_ports == 0 && length <= Operation::longest_mix;
    }

    Reader& bytes_;
    OperationCheck& check_;
    std::vector<Shape> shapes_;
    Reader numbers_{{}};
    Reader counts_{{}};
    Reader gaps_{{}};
    Reader tail_gaps_{{}};
    Reader mixes_{{}};
};

using timing::PhraseBook;
using Code = timing::Phrase::Code;

template <std::size_t width> void put_at(char* bytes, std::uint64_t number) {
    for (std::size_t i = 0; i < width; ++i)
        bytes[i] = static_cast<char>(number >> (8 * i));
}

/// Numbers of `width` bytes each, little-endian.
template <std::size_t width, class Numbers>
void put_all(Numbers const* numbers, std::size_t count, std::string& bytes) {
    std::size_t at = bytes.size();
    bytes.resize(at + count * width);
    for (std::size_t i = 0; i < count; ++i, at += width)
        put_at<width>(&bytes[at], numbers[i]);
}

template <std::size_t width> std::uint64_t number_at(char const* bytes) {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < width; ++i)
        number |= std::uint64_t{static_cast<unsigned char>(bytes[i])} << (8 * i);
    return number;
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
    for (std::uint8_t const ports : sample.script.next_ports)
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

/// Of the phrases that occur in a sample: their numbers in the book of all.
bool read_book(Reader& bytes, KnownPhrases& known, std::vector<PhraseBook::Number>& numbers) {
    std::uint64_t const count = bytes.number();
    if (count > bytes.left())
        return false;
    std::vector<std::uint64_t> sizes(count);
    for (std::uint64_t& size : sizes)
        size = bytes.number();
    std::array<Code, timing::Phrase::most_codes + timing::Phrase::most_members> codes{};
    for (std::uint64_t const size : sizes) {
        if (size > codes.size())
            return false;
        std::string_view const coded = bytes.bytes(size * sizeof(Code));
        for (std::size_t i = 0; i < coded.size() / sizeof(Code); ++i)
            codes[i] = number_at<sizeof(Code)>(coded.data() + i * sizeof(Code));
        std::optional<PhraseBook::Number> const number = known.number_of(codes.data(), coded.size() / sizeof(Code));
        if (!number)
            return false;
        numbers.push_back(*number);
    }
    return true;
}

/// Each phrase must be one that begins where the ones before it left the processes.
template <std::size_t width>
bool read_numbers(std::string_view bytes, std::vector<PhraseBook::Number> const& numbers, KnownPhrases const& known,
                  PhraseCheck& check, ScriptedSample& sample) {
    char const* at = bytes.data();
    for (PhraseBook::Number& phrase : sample.phrases) {
        std::uint64_t const number = number_at<width>(at);
        at += width;
        if (number >= numbers.size() || !check.accepts(known[numbers[number]]))
            return false;
        phrase = numbers[number];
        sample.script.due += known[phrase].due;
    }
    return true;
}

bool read_phrases(Reader& bytes, KnownPhrases& known, PhraseCheck& check, ScriptedSample& sample) {
    for (std::uint8_t& ports : sample.script.next_ports)
        ports = static_cast<std::uint8_t>(bytes.number());
    std::vector<PhraseBook::Number> numbers;
    if (!read_book(bytes, known, numbers))
        return false;
    std::uint64_t const count = bytes.number();
    if (count > bytes.left())
        return false;
    sample.phrases.resize(count);
    return with_width_for(numbers.size(), [&](auto width) {
        std::string_view const coded = bytes.bytes(count * width);
        return bytes.good() && read_numbers<decltype(width)::value>(coded, numbers, known, check, sample);
    });
}

bool read_operations(Reader& bytes, std::vector<OperationCheck>& checks, SampleOperations& operations) {
    operations.resize(checks.size());
    for (std::size_t i = 0; i < operations.size(); ++i)
        if (!ProcessDecoder(bytes, checks[i]).decode(operations[i]))
            return false;
    return true;
}

}  // namespace

std::string encode(ScriptedSample const& sample, PhraseBook const& book) {
    std::string bytes;
    ProcessEncoder encoder;
    for (std::vector<Operation> const& process : sample.before)
        encoder.put(process, bytes);
    put_phrases(sample, book, bytes);
    for (std::vector<Operation> const& process : sample.after)
        encoder.put(process, bytes);
    return bytes;
}

bool decode(std::string_view bytes, LeadCore const& lead, KnownPhrases& known, ScriptedSample& sample) {
    sample = ScriptedSample();
    Reader reader(bytes);
    std::vector<OperationCheck> checks;
    for (timing::ProcessTiming const& process : lead.core->processes())
        checks.emplace_back(process);
    if (!read_operations(reader, checks, sample.before))
        return false;
    PhraseCheck phrases(lead.group, checks);
    if (!read_phrases(reader, known, phrases, sample))
        return false;
    phrases.move_on(checks);
    if (!read_operations(reader, checks, sample.after))
        return false;
    return reader.done() &&
           std::all_of(checks.begin(), checks.end(), [](OperationCheck const& check) { return check.is_done(); });
}

}  // namespace faster::retiming
