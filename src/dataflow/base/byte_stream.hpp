#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace dataflow {

/// Appends values to a string of bytes, for a reader in a process of the same build. A value is a number or an enum, a
/// string, or a vector of numbers.
class ValueWriter {
  public:
    template <class... Values> void put(Values const&... values) { (put_one(values), ...); }
    std::string const& bytes() const { return bytes_; }

  private:
    template <class Number> void put_one(Number value) {
        static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
        bytes_.append(reinterpret_cast<char const*>(&value), sizeof value);
    }
    template <class Value> void put_one(std::optional<Value> const& value) {
        put_one(value.has_value());
        if (value)
            put_one(*value);
    }
    void put_one(std::string const& text) {
        put_one(text.size());
        bytes_ += text;
    }
    template <class Number> void put_one(std::vector<Number> const& numbers) {
        static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
        put_one(numbers.size());
        bytes_.append(reinterpret_cast<char const*>(numbers.data()), numbers.size() * sizeof(Number));
    }

    std::string bytes_;
};

/// Takes them out again, in the same order. Throws std::runtime_error at the end of the bytes.
class ValueReader {
  public:
    explicit ValueReader(std::string bytes) : bytes_(std::move(bytes)) {}

    template <class... Values> void get(Values&... values) { (get_one(values), ...); }
    std::size_t get_size() {
        std::size_t size = 0;
        get_one(size);
        return size;
    }

  private:
    void take(void* to, std::size_t count) {
        if (count > bytes_.size() - next_)
            throw std::runtime_error("too few bytes");
        if (count > 0)
            std::memcpy(to, bytes_.data() + next_, count);
        next_ += count;
    }
    template <class Value> void get_one(std::optional<Value>& value) {
        bool has_value = false;
        get_one(has_value);
        if (has_value)
            get_one(value.emplace());
    }
    template <class Number> void get_one(Number& value) {
        static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
        take(&value, sizeof value);
    }
    void get_one(std::string& text) {
        text.resize(get_size());
        take(text.data(), text.size());
    }
    template <class Number> void get_one(std::vector<Number>& numbers) {
        static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
        numbers.resize(get_size());
        take(numbers.data(), numbers.size() * sizeof(Number));
    }

    std::string bytes_;
    std::size_t next_ = 0;
};

}  // namespace dataflow
