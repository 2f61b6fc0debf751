#pragma once
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <string_view>

namespace dataflow {

/// The FNV-1a hash of 64 bits of all bytes added so far (offset 14695981039346656037, prime 1099511628211). It tells
/// contents apart and finds damage; it protects against nobody.
class Fnv1a {
  public:
    void add(std::string_view bytes) {
        for (char const byte : bytes)
            hash_ = (hash_ ^ static_cast<unsigned char>(byte)) * prime;
    }
    std::uint64_t value() const { return hash_; }
    /// 16 hexadecimal ones.
    std::string digits() const { return fmt::format("{:016x}", hash_); }

  private:
    static constexpr std::uint64_t prime = 1099511628211U;

    std::uint64_t hash_ = 14695981039346656037U;
};

inline std::string fnv1a_digits(std::string_view text) {
    Fnv1a hash;
    hash.add(text);
    return hash.digits();
}

}  // namespace dataflow
