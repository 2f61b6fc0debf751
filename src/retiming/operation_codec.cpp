#include "retiming/operation_codec.hpp"

#include <algorithm>
#include <array>
#include <utility>

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
    unsigned byte() {
        if (at_ == end_) {
            good_ = false;
            return 0;
        }
        return static_cast<unsigned char>(*at_++);
    }
    Reader column() {
        std::uint64_t const size = number();
        if (size > left()) {
            good_ = false;
            return Reader({});
        }
        Reader const column({at_, size});
        at_ += size;
        return column;
    }
    std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
    bool good() const { return good_; }
    bool done() const { return good_ && at_ == end_; }

  private:
    char const* at_;
    char const* end_;
    bool good_ = true;
};

/// Reads one process's operations, and checks that it can do them.
class ProcessDecoder {
  public:
    ProcessDecoder(Reader& bytes, timing::ProcessTiming const& process) : bytes_(bytes), process_(process) {}

    bool decode(std::vector<Operation>& operations) {
        std::uint64_t const count = bytes_.number();
        if (!read_shapes() || count > bytes_.left())
            return false;
        for (Reader* column : {&numbers_, &counts_, &gaps_, &tail_gaps_, &mixes_})
            *column = bytes_.column();
        operations.resize(count);
        for (Operation& operation : operations)
            if (!read(operation))
                return false;
        return bytes_.good() && !in_loop_ && setups_ == 0 && numbers_.done() && counts_.done() && gaps_.done() &&
               tail_gaps_.done() && mixes_.done();
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
            if (kind > static_cast<unsigned>(Kind::flanked) || !has_ports(shape.ports | shape.tail_ports))
                return false;
            shape.kind = static_cast<Kind>(kind);
            shapes_.push_back(shape);
        }
        return true;
    }

    bool has_ports(unsigned ports) const { return (ports >> process_.port_count()) == 0; }

    bool read(Operation& operation) {
        std::uint64_t const number = numbers_.number();
        if (number >= shapes_.size())
            return false;
        Shape const& shape = shapes_[number];
        if (shape.kind == Kind::mixed)
            return in_loop_ && read_mix(shape, operation);
        std::uint64_t const count = shape.has_count() ? counts_.number() : 0;
        std::uint64_t const gap = shape.has_gap() ? gaps_.number() : 0;
        std::uint64_t const tail_gap = shape.tail_ports != 0 ? tail_gaps_.number() : 0;
        if (count > Operation::longest_count || gap > Operation::longest_gap || tail_gap > Operation::longest_gap)
            return false;
        operation =
            Operation(shape.kind, shape.ports, static_cast<std::uint32_t>(gap), static_cast<std::uint32_t>(count));
        operation.add_tail(shape.tail_ports, static_cast<std::uint32_t>(tail_gap));
        return makes_sense(operation);
    }

    bool read_mix(Shape const& shape, Operation& operation) {
        std::uint64_t const length = counts_.number();
        std::uint32_t gaps = 0;
        for (unsigned at = 0; at < 32; at += 8)
            gaps |= std::uint32_t{mixes_.byte()} << at;
        operation = Operation::mix(shape.ports, static_cast<unsigned>(length & 0xFFU), gaps);
        return shape.ports != 0 && shape.tail_ports == 0 && length > 0 && length <= Operation::longest_mix &&
               (gaps & ~Operation::gap_bits(1, static_cast<std::uint32_t>(length))) == 0;
    }

    bool makes_sense(Operation const& operation) {
        bool const is_iteration = operation.kind() == Kind::iterate || operation.kind() == Kind::flanked;
        if (!is_iteration && operation.tail_ports() != 0)
            return false;
        switch (operation.kind()) {
            case Kind::wait:
                return operation.ports() == 0 && makes_sense_as_setup(operation);
            case Kind::step:
                return !in_loop_ && operation.ports() != 0;
            case Kind::enter:
                in_loop_ = !in_loop_;
                return in_loop_ && operation.ports() == 0 && operation.count() < process_.loops().size();
            case Kind::leave:
                in_loop_ = !in_loop_;
                return !in_loop_ && operation.ports() == 0;
            case Kind::iterate:
                return in_loop_ && operation.count() > 0;
            case Kind::flanked:
                return in_loop_ && operation.count() > 1 && operation.ports() != 0 && operation.tail_ports() != 0;
            case Kind::stamp:
                return operation.ports() == 0 && !std::exchange(is_stamped_, true);
            case Kind::mixed:
                break;
        }
        return false;
    }

    /// Outside loops a process waits, or does a whole setup; in a loop it awaits what it has begun.
    bool makes_sense_as_setup(Operation const& operation) {
        if (operation.gap() <= Operation::whole_setup)
            return !in_loop_;
        if (operation.gap() > Operation::setup_end)
            return false;
        setups_ += operation.gap() == Operation::setup_begin ? 1 : -1;
        return in_loop_ && setups_ >= 0;
    }

    Reader& bytes_;
    timing::ProcessTiming const& process_;
    std::vector<Shape> shapes_;
    Reader numbers_{{}};
    Reader counts_{{}};
    Reader gaps_{{}};
    Reader tail_gaps_{{}};
    Reader mixes_{{}};
    bool in_loop_ = false;
    std::int64_t setups_ = 0;  // begun and not awaited
    bool is_stamped_ = false;  // once per sample at most
};

}  // namespace

std::string encode(SampleOperations const& operations) {
    std::string bytes;
    ProcessEncoder encoder;
    for (std::vector<Operation> const& process : operations)
        encoder.put(process, bytes);
    return bytes;
}

bool decode(std::string_view bytes, timing::CoreTiming const& core, SampleOperations& operations) {
    Reader reader(bytes);
    operations.resize(core.processes().size());
    for (std::size_t i = 0; i < operations.size(); ++i)
        if (!ProcessDecoder(reader, core.processes()[i]).decode(operations[i]))
            return false;
    return reader.done();
}

}  // namespace faster::retiming
