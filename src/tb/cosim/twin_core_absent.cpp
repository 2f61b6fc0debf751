#include <stdexcept>

#include "tb/cosim/twin_core.hpp"

namespace faster::rtl {

struct TwinCore::Parts {};

bool has_twin() { return false; }

TwinCore::TwinCore(TwinSettings const&, Stimulus const&, std::size_t, std::size_t) {
    throw std::logic_error("there is no twin: built without Verilator");
}
TwinCore::~TwinCore() = default;

std::uint32_t TwinCore::writes() const { return 0; }
std::uint32_t TwinCore::reads() const { return 0; }
std::int64_t TwinCore::field(std::size_t, std::size_t) const { return 0; }
bool TwinCore::maps_are_built() const { return false; }
bool TwinCore::depth_buffer_is_drawn() const { return false; }
std::vector<std::uint8_t> TwinCore::edge_map() const { return {}; }
std::vector<std::uint8_t> TwinCore::object_map() const { return {}; }
std::vector<std::uint16_t> TwinCore::depth_buffer() const { return {}; }
void TwinCore::step() {}

}  // namespace faster::rtl
