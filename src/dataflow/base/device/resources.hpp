#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "dataflow/base/device/block_ram.hpp"
#include "dataflow/base/device/unit_path.hpp"

namespace dataflow {

/// What something takes of a device.
struct Resources {
    double lut = 0;     ///< look-up tables, with those that are shift registers or distributed RAM
    double ff = 0;      ///< flip-flops
    double dsp = 0;     ///< DSP48E2
    double ramb36 = 0;  ///< block RAMs of 36 Kbit; a RAMB18 is half of one
};
constexpr Resources operator+(Resources const& a, Resources const& b) {
    return {a.lut + b.lut, a.ff + b.ff, a.dsp + b.dsp, a.ramb36 + b.ramb36};
}
constexpr Resources operator*(double times, Resources const& a) {
    return {times * a.lut, times * a.ff, times * a.dsp, times * a.ramb36};
}
constexpr Resources operator-(Resources const& a, Resources const& b) { return a + -1.0 * b; }
inline Resources& operator+=(Resources& a, Resources const& b) { return a = a + b; }

struct Device {
    std::string_view name;
    Resources has;
};
/// The ZCU102's. Source: AMD DS891.
constexpr Device xczu9eg{"XCZU9EG", {274080, 548160, 2520, ramb36_of_device}};

/// How a figure came about, the surest first. A sum is as sure as the least sure of its parts.
enum class ResourceBasis {
    synthesized,   ///< of this very configuration
    interpolated,  ///< between synthesized configurations, or along them
    counted,       ///< by hand, from widths and primitives
    unknown,       ///< nobody has said, and nothing is added
};

/// A part of a core, or of what is beside the cores.
struct ResourcePart {
    std::string name;
    Resources amount;
    ResourceBasis basis = ResourceBasis::counted;
};
/// Nothing counts as synthesized.
ResourcePart sum_of(std::string name, std::vector<ResourcePart> const& parts);

/// What a design tells of its resources besides its memories, which are counted from their shapes.
struct ToldResources {
    std::vector<std::vector<ResourcePart>> modules;  ///< parts of each process, by its number; or nothing
    std::vector<ResourcePart> fifos;                 ///< by their numbers; or nothing: counted from their shapes
    std::vector<std::vector<UnitPath>> paths;        ///< longest of each process, by its number; or nothing
    Resources beside;                                ///< for each core: what the chip has and the cores do not
    std::string beside_is;                           ///< what that is, and who says so; empty: not known
};

}  // namespace dataflow
