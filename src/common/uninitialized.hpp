#pragma once
#include <memory>
#include <new>
#include <utility>

namespace faster {

/// An allocator whose containers leave new elements of trivial types as they are: for what is written over anyway.
template <class Element> struct Uninitialized : std::allocator<Element> {
    template <class Other> struct rebind { using other = Uninitialized<Other>; };

    Uninitialized() = default;
    template <class Other> explicit Uninitialized(Uninitialized<Other> const& /*other*/) noexcept {}

    template <class Other> void construct(Other* place) noexcept { ::new (static_cast<void*>(place)) Other; }
    template <class Other, class... Arguments> void construct(Other* place, Arguments&&... arguments) {
        ::new (static_cast<void*>(place)) Other(std::forward<Arguments>(arguments)...);
    }
};

}  // namespace faster
