#include "dataflow/tools/recording/vcd_file.hpp"

#include <charconv>
#include <cstring>
#include <fmt/format.h>

#include "dataflow/base/held_signals.hpp"

namespace dataflow::recording {

namespace {
constexpr std::size_t buffer_size = 1U << 20;
constexpr std::size_t longest_line = 128;

/// Eight binary digits, the highest first.
void put_byte(char* at, std::uint64_t byte) {
    std::uint64_t const copies = byte * 0x0101010101010101U;
    std::uint64_t const own = copies & 0x0102040810204080U;  // the k-th byte keeps the bit 7 - k
    std::uint64_t const digits = (((own + 0x7F7F7F7F7F7F7F7FU) | own) >> 7 & 0x0101010101010101U) | 0x3030303030303030U;
    std::memcpy(at, &digits, sizeof digits);
}

/// A number's binary digits without leading zeros. Returns the end.
char* put_binary(char* at, std::uint64_t value) {
    unsigned const bits = signal_bits(value);
    value <<= 64U - bits;
    for (unsigned done = 0; done < bits; done += 8, value <<= 8)
        put_byte(at + done, value >> 56);
    return at + bits;
}

}  // namespace

VcdFile::VcdFile(std::filesystem::path const& file, double clock_mhz)
    : target_(file), file_(std::fopen(target_.path().c_str(), "wb")), buffer_(buffer_size) {
    if (file_ == nullptr)
        target_.fail();
    put_text(fmt::format("$version faster-sim {} $end\n$comment {:g} MHz $end\n$timescale 1 {} $end\n", FASTER_VERSION,
                         clock_mhz, counts_in_ns(clock_mhz) ? "ns" : "ps"));
}

std::array<char, 8> VcdFile::id_of(std::size_t number) {
    std::array<char, 8> id{};
    std::size_t length = 0;
    do {
        id[length++] = static_cast<char>('!' + number % 94);
        number /= 94;
    } while (number > 0);
    return id;
}

void VcdFile::open_scope(std::string const& name) { put_text(fmt::format("$scope module {} $end\n", name)); }
void VcdFile::close_scope() { put_text("$upscope $end\n"); }
void VcdFile::end_declarations() { put_text("$enddefinitions $end\n"); }

void VcdFile::declare(SignalShape const& shape) {
    Signal const signal{id_of(signals_.size()), shape.bits > 1};
    std::string const range = shape.bits > 1 ? fmt::format(" [{}:0]", shape.bits - 1) : "";
    put_text(fmt::format("$var wire {} {} {}{} $end\n", shape.bits, signal.id.data(), shape.name, range));
    signals_.push_back(signal);
}

void VcdFile::go_to(std::uint64_t ticks) {
    make_room();
    char* at = buffer_.data() + fill_;
    *at++ = '#';
    at = std::to_chars(at, buffer_.data() + buffer_.size(), ticks).ptr;
    *at++ = '\n';
    fill_ = static_cast<std::size_t>(at - buffer_.data());
}

void VcdFile::change(std::size_t number, std::optional<std::uint64_t> value) {
    make_room();
    Signal const& signal = signals_[number];
    char* at = buffer_.data() + fill_;
    if (signal.is_vector)
        *at++ = 'b';
    if (value)
        at = put_binary(at, *value);
    else
        *at++ = 'x';
    if (signal.is_vector)
        *at++ = ' ';
    for (char const* letter = signal.id.data(); *letter != 0; ++letter)
        *at++ = *letter;
    *at++ = '\n';
    fill_ = static_cast<std::size_t>(at - buffer_.data());
}

void VcdFile::put_text(std::string const& text) {
    for (char const letter : text) {
        if (fill_ == buffer_.size())
            write_out();
        buffer_[fill_++] = letter;
    }
}

void VcdFile::make_room() {
    if (fill_ + longest_line > buffer_.size())
        write_out();
}

void VcdFile::write_out() {
    processes::give_up_if_interrupted();
    if (std::fwrite(buffer_.data(), 1, fill_, file_.get()) != fill_)
        target_.fail();
    bytes_ += fill_;
    fill_ = 0;
}

void VcdFile::finish() {
    write_out();
    if (std::fclose(file_.release()) != 0)
        target_.fail();
    target_.finish();
}

}  // namespace dataflow::recording
