#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace dataflow {

/// Appends values to a string of bytes, for a reader in a process of the same build. A value is a number or whatever
/// else can be copied as bytes, a string, or an optional, a pair, a vector or a set of values. Pointers in it lead to
/// the same for a reader of which this process is a fork, if they are to what the program began with.
class ValueWriter {
  public:
    template <class... Values> void put(Values const&... values) { (put_one(values), ...); }
    std::string const& bytes() const { return bytes_; }

  private:
    template <class Value> void put_one(Value const& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        bytes_.append(reinterpret_cast<char const*>(&value), sizeof value);
    }
    template <class Value> void put_one(std::optional<Value> const& value) {
        put_one(value.has_value());
        if (value)
            put_one(*value);
    }
    template <class First, class Second> void put_one(std::pair<First, Second> const& pair) {
        put_one(pair.first);
        put_one(pair.second);
    }
    void put_one(std::string const& text) {
        put_one(text.size());
        bytes_ += text;
    }
    template <class Value> void put_one(std::vector<Value> const& values) {
        put_one(values.size());
        if constexpr (std::is_trivially_copyable_v<Value>)
            bytes_.append(reinterpret_cast<char const*>(values.data()), values.size() * sizeof(Value));
        else
            for (Value const& value : values)
                put_one(value);
    }
    template <class Value, class Order> void put_one(std::set<Value, Order> const& values) {
        put_one(values.size());
        for (Value const& value : values)
            put_one(value);
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
    template <class Value> void get_one(Value& value) {
        static_assert(std::is_trivially_copyable_v<Value>);
        take(&value, sizeof value);
    }
    template <class Value> void get_one(std::optional<Value>& value) {
        bool has_value = false;
        get_one(has_value);
        if (has_value)
            get_one(value.emplace());
    }
    template <class First, class Second> void get_one(std::pair<First, Second>& pair) {
        get_one(pair.first);
        get_one(pair.second);
    }
    void get_one(std::string& text) {
        text.resize(get_size());
        take(text.data(), text.size());
    }
    template <class Value> void get_one(std::vector<Value>& values) {
        values.resize(get_size());
        if constexpr (std::is_trivially_copyable_v<Value>)
            take(values.data(), values.size() * sizeof(Value));
        else
            for (Value& value : values)
                get_one(value);
    }
    template <class Value, class Order> void get_one(std::set<Value, Order>& values) {
        values.clear();
        for (std::size_t left = get_size(); left > 0; --left) {
            Value value{};
            get_one(value);
            values.insert(values.end(), std::move(value));
        }
    }

    std::string bytes_;
    std::size_t next_ = 0;
};

}  // namespace dataflow
