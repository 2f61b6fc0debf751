#pragma once
#include <cstddef>
#include <memory>
#include <new>
#include <utility>

namespace dataflow {

/// An allocator whose containers leave new elements of trivial types as they are: for what is written over anyway.
template <class Element> struct Uninitialized {
    using value_type = Element;  // NOLINT(readability-identifier-naming): an allocator's

    Uninitialized() = default;
    template <class Other> explicit Uninitialized(Uninitialized<Other> const& /*other*/) noexcept {}

    Element* allocate(std::size_t count) { return std::allocator<Element>().allocate(count); }
    void deallocate(Element* elements, std::size_t count) { std::allocator<Element>().deallocate(elements, count); }
    void construct(Element* place) noexcept { ::new (static_cast<void*>(place)) Element; }
    template <class Other, class... Arguments> void construct(Other* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) Other(std::forward<Arguments>(arguments)...);
    }
};

template <class One, class Other>
bool operator==(Uninitialized<One> const& /*one*/, Uninitialized<Other> const& /*other*/) {
    return true;
}
template <class One, class Other>
bool operator!=(Uninitialized<One> const& /*one*/, Uninitialized<Other> const& /*other*/) {
    return false;
}

}  // namespace dataflow
