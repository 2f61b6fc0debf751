#include "retiming/operation_codec.hpp"

#include <algorithm>
#include <array>

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
    friend bool operator==(Shape const& a, Shape const& b) {
        return a.kind == b.kind && a.ports == b.ports && a.tail_ports == b.tail_ports;
    }
};
constexpr std::size_t most_shapes = 256;

Shape shape_of(Operation const& operation) { return {operation.kind(), operation.ports(), operation.tail_ports()}; }

void put_number(std::string& bytes, std::uint64_t value) {
    for (; value >= 0x80; value >>= 7)
        bytes.push_back(static_cast<char>(0x80U | (value & 0x7FU)));
    bytes.push_back(static_cast<char>(value));
}

/// One process's operations, column by column: which shape; then what operations of that shape have, in their order.
struct Columns {
    std::string shapes;
    std::string counts;
    std::string gaps;
    std::string tail_gaps;
    std::string mixes;
    std::array<std::string*, 5> all() { return {&shapes, &counts, &gaps, &tail_gaps, &mixes}; }
};

void put_operation(Operation const& operation, Shape const& shape, Columns& columns) {
    if (shape.kind == Kind::mixed) {
        put_number(columns.counts, operation.length());
        for (unsigned at = 0; at < 32; at += 8)
            columns.mixes.push_back(static_cast<char>(operation.gaps() >> at));
        return;
    }
    if (shape.has_count())
        put_number(columns.counts, operation.count());
    if (shape.has_gap())
        put_number(columns.gaps, operation.gap());
    if (shape.tail_ports != 0)
        put_number(columns.tail_gaps, operation.tail_gap());
}

/// Numbers shapes in the order in which they occur.
class ShapeTable {
  public:
    std::size_t number_of(Shape const& shape) {
        if (last_ < shapes_.size() && shapes_[last_] == shape)
            return last_;
        last_ = static_cast<std::size_t>(std::find(shapes_.begin(), shapes_.end(), shape) - shapes_.begin());
        if (last_ == shapes_.size())
            shapes_.push_back(shape);
        return last_;
    }
    std::vector<Shape> const& shapes() const { return shapes_; }

  private:
    std::vector<Shape> shapes_;
    std::size_t last_ = 0;
};

void put_process(std::vector<Operation> const& operations, std::string& bytes) {
    ShapeTable table;
    Columns columns;
    columns.shapes.reserve(operations.size());
    for (Operation const& operation : operations) {
        Shape const shape = shape_of(operation);
        put_number(columns.shapes, table.number_of(shape));
        put_operation(operation, shape, columns);
    }
    put_number(bytes, operations.size());
    put_number(bytes, table.shapes().size());
    for (Shape const& shape : table.shapes())
        for (unsigned const byte :
             {static_cast<unsigned>(shape.kind), unsigned{shape.ports}, unsigned{shape.tail_ports}})
            bytes.push_back(static_cast<char>(byte));
    for (std::string const* column : columns.all()) {
        put_number(bytes, column->size());
        bytes += *column;
    }
}

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
        return bytes_.good() && !in_loop_ && numbers_.done() && counts_.done() && gaps_.done() && tail_gaps_.done() &&
               mixes_.done();
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
                return !in_loop_ && operation.ports() == 0;
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
                return operation.ports() == 0;
            case Kind::mixed:
                break;
        }
        return false;
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
};

}  // namespace

std::string encode(SampleOperations const& operations) {
    std::string bytes;
    for (std::vector<Operation> const& process : operations)
        put_process(process, bytes);
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
