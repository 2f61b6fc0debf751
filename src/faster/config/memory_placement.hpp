#pragma once
#include <cstdint>

namespace faster {

/// Where something lies that the cores read again and again.
enum class Placement {
    external,  ///< in the external memory: fetched whenever it is used
    on_chip,   ///< in block RAMs, into which it is loaded before an iteration begins
};

/// Where the data of an iteration lie; keys `accelerator.memory.*`. Without effect as long as the model is ideal.
struct MemoryPlacement {
    Placement mesh = Placement::external;
    Placement observation = Placement::external;
    std::uint64_t observation_copies = 1;  ///< of an observation on the chip, each shared by cores
    // What memories on the chip have room for.
    std::uint64_t mesh_triangles = 4096;
    std::uint64_t observation_width = 640;  ///< [px]
    std::uint64_t observation_height = 480;
    // Where each begins [byte].
    std::uint64_t mesh_address = 0x1000'0000;
    std::uint64_t image_address = 0x2000'0000;
    std::uint64_t table_address = 0x2800'0000;
    std::uint64_t header_address = 0x3000'0000;
    std::uint64_t result_address = 0x3800'0000;
};

}  // namespace faster
