#include "modules/area_reciprocal/area_reciprocal.hpp"

#include "channels/port_binding.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/depth.hpp"

namespace faster {

ModuleDescription AreaReciprocal::describe(AcceleratorConfig const& config) {
    FractionBits const& fraction = config.fraction_bits;
    ModuleDescription module("area_reciprocal");
    module.reads_from("area");
    module.writes_to("area_reciprocal")
        .carries("1 / area from the reciprocal unit to the inlier unit")
        .of_bits(static_cast<unsigned>(fraction.area_reciprocal + 2 * fraction.vertex_xy) +
                 1)  // that of an area of code 1
        .flushes_after(36, "Pipeline stages from the read of an area to the write of its reciprocal.");
    module.number("interval")
        .means(
            "Cycles from the area of a drawn triangle to the next area; so long each stage of the divider works at one "
            "quotient, and there are that many times fewer of them.")
        .in("cycles")
        .is(1)
        .within(1, 64);
    return module;
}

void AreaReciprocal::work(std::size_t i) {
    for (std::uint32_t left = core_.sample(i).triangle_count; left > 0; --left) {
        clock_.here();
        std::int64_t const area = area_in.read();
        bool const is_drawn = area > 0;
        if (is_drawn) {
            clock_.here();
            area_reciprocal_out.write(datapath::reciprocal_of(area, core_.stimulus.fraction));
        }
        clock_.advance(is_drawn ? clock_.number("interval") : 1);
    }
}

}  // namespace faster
