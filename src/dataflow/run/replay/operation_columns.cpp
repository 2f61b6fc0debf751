#include "dataflow/run/replay/operation_columns.hpp"

#include <algorithm>
#include <array>

#include "dataflow/base/little_endian.hpp"

namespace dataflow::replay {

namespace {

using timing::Operation;
using timing::Ports;
using Kind = Operation::Kind;

/// What operations of one sort have in common.
struct Shape {
    Kind kind = Kind::wait;
    Ports::Number ports = 0;
    Ports::Number tail_ports = 0;

    bool has_count() const { return kind != Kind::leave && kind != Kind::stamp; }
    bool has_gap() const { return kind == Kind::wait || kind == Kind::iterate; }
};
constexpr std::size_t most_shapes = 1U << 16;

/// A mask is itself; of other sets, so many numbers follow, of their ports.
void put_ports(Ports::Number number, std::string& bytes) {
    if (Ports::is_mask(number)) {
        put_number(bytes, number);
        return;
    }
    std::uint64_t count = 0;
    Ports(number).each([&count](unsigned /*port*/) { ++count; });
    put_number(bytes, Ports::masks + count);
    Ports(number).each([&bytes](unsigned port) { put_number(bytes, port); });
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
        put_little_endian<4>(value, end_);
        end_ += 4;
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
        return (((kind << Ports::number_bits) | operation.ports()) << Ports::number_bits) | operation.tail_ports();
    }

    std::vector<std::uint32_t> keys_;
    std::vector<Shape> shapes_;
    std::array<std::uint32_t, 61> last_numbers_{};
};

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
        for (Shape const& shape : table.shapes()) {
            bytes.push_back(static_cast<char>(shape.kind));
            put_ports(shape.ports, bytes);
            put_ports(shape.tail_ports, bytes);
        }
        for (Column const* column : {&shapes_, &counts_, &gaps_, &tail_gaps_, &mixes_}) {
            put_number(bytes, column->bytes().size());
            bytes += column->bytes();
        }
    }

  private:
    static constexpr std::size_t most_bytes_of_number = 4;  // a count: 19 bits; all others have fewer

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

/// Reads one process's operations, and checks that it can do them.
class ProcessDecoder {
  public:
    ProcessDecoder(ByteReader& bytes, OperationCheck& check) : bytes_(bytes), check_(check) {}

    bool decode(std::vector<Operation>& operations) {
        std::uint64_t const count = bytes_.number();
        if (!read_shapes() || count > bytes_.left())
            return false;
        for (ByteReader* column : {&numbers_, &counts_, &gaps_, &tail_gaps_, &mixes_})
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
            if (!read_ports(shape.ports) || !read_ports(shape.tail_ports) ||
                kind > static_cast<unsigned>(Kind::flanked))
                return false;
            shape.kind = static_cast<Kind>(kind);
            shapes_.push_back(shape);
        }
        return true;
    }

    /// Of the process; false if it has no such ports, or the program no room for another set of them.
    bool read_ports(Ports::Number& ports) {
        std::uint64_t const number = bytes_.number();
        ports = static_cast<Ports::Number>(number);
        if (number < Ports::masks)
            return true;
        std::vector<unsigned> list;
        for (std::uint64_t left = number - Ports::masks; left > 0 && bytes_.good(); --left) {
            std::uint64_t const port = bytes_.number();
            if (port >= check_.port_count() || (!list.empty() && port <= list.back()))
                return false;
            list.push_back(static_cast<unsigned>(port));
        }
        if (list.empty() || !Ports::has_room_for(list))
            return false;
        ports = Ports::of(list).number();
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
        std::string_view const coded = mixes_.bytes(4);
        if (!mixes_.good())
            return false;
        auto const gaps = static_cast<std::uint32_t>(little_endian_at<4>(coded.data()));
        operation = Operation::mix(shape.ports, static_cast<unsigned>(length & 0xFFU), gaps);
        return shape.tail_ports == 0 && length <= Operation::longest_mix;
    }

    ByteReader& bytes_;
    OperationCheck& check_;
    std::vector<Shape> shapes_;
    ByteReader numbers_{{}};
    ByteReader counts_{{}};
    ByteReader gaps_{{}};
    ByteReader tail_gaps_{{}};
    ByteReader mixes_{{}};
};

}  // namespace

void encode_operations(std::vector<Operation> const& operations, std::string& bytes) {
    ProcessEncoder().put(operations, bytes);
}

bool decode_operations(ByteReader& bytes, OperationCheck& check, std::vector<Operation>& operations) {
    return ProcessDecoder(bytes, check).decode(operations);
}

}  // namespace dataflow::replay
