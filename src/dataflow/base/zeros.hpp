#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace dataflow {

/// Numbers that begin as zeros which the host need not write: of what is large, only the pages that are used take
/// memory.
template <class Number> class Zeros {
    static_assert(std::is_integral_v<Number>);

  public:
    explicit Zeros(std::size_t count)
        : count_(count), numbers_(static_cast<Number*>(std::calloc(count, sizeof(Number)))) {
        if (numbers_ == nullptr)
            throw std::bad_alloc();
    }

    Zeros(Zeros const& other) : Zeros(other.count_) { std::copy_n(other.data(), count_, data()); }
    Zeros(Zeros&&) noexcept = default;
    ~Zeros() = default;
    Zeros& operator=(Zeros const& other) {
        if (count_ != other.count_)
            return *this = Zeros(other);
        std::copy_n(other.data(), count_, data());
        return *this;
    }
    Zeros& operator=(Zeros&&) noexcept = default;

    std::size_t size() const { return count_; }
    Number* data() { return numbers_.get(); }
    Number const* data() const { return numbers_.get(); }
    Number& operator[](std::size_t i) { return numbers_[i]; }
    Number operator[](std::size_t i) const { return numbers_[i]; }

  private:
    struct Free {
        void operator()(Number* numbers) const { std::free(numbers); }
    };
    std::size_t count_;
    std::unique_ptr<Number[], Free> numbers_;
};

}  // namespace dataflow
