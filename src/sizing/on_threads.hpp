#pragma once
#include <cstddef>
#include <functional>

namespace faster::sizing {

/// work(0), ..., work(count - 1) on up to `jobs` threads, each of which takes the next number when it has done one.
/// Throws what one of them threw.
void on_threads(std::size_t count, unsigned jobs, std::function<void(std::size_t i)> const& work);

}  // namespace faster::sizing
