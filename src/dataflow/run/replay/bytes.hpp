#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace dataflow::replay {

/// Appends a number, 7 bits a byte (LEB128).
inline void put_number(std::string& bytes, std::uint64_t value) {
    for (; value >= 0x80; value >>= 7)
        bytes.push_back(static_cast<char>(0x80U | (value & 0x7FU)));
    bytes.push_back(static_cast<char>(value));
}

/// Takes numbers from bytes; remembers if there were too few.
class ByteReader {
  public:
    explicit ByteReader(std::string_view bytes) : at_(bytes.data()), end_(bytes.data() + bytes.size()) {}

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
    ByteReader column() { return ByteReader(bytes(number())); }
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

}  // namespace dataflow::replay
