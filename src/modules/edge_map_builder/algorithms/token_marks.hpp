#pragma once
#include <cstdint>

namespace faster::datapath {

/// Maps in which tokens that lie in the window may be marked in any order: W x W bytes, 1 for where there was one.
struct TokenMarks {
    std::uint8_t* edge;
    std::uint8_t* object;
};

}  // namespace faster::datapath
