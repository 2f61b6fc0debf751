#include "modules/area_reciprocal.hpp"

#include "channels/port_binding.hpp"
#include "datapath/depth.hpp"

namespace faster {

AreaReciprocal::AreaReciprocal(sc_core::sc_module_name const& name, CoreContext const& core)
    : sc_module(name), core_(core), clock_(core.timing, name_of(ModuleId::area_reciprocal), core.time_base) {
    SC_THREAD(run);
}

void AreaReciprocal::end_of_elaboration() {
    clock_.connect_reads(channel_of(area_in));
    clock_.connect_writes(channel_of(area_reciprocal_out));
}

void AreaReciprocal::run() {
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        core_.begin_sample(ModuleId::area_reciprocal);
        for (std::uint32_t left = core_.sample(i).triangle_count; left > 0; --left) {
            clock_.here();
            std::int64_t const area = area_in.read();
            if (area > 0) {
                clock_.here();
                area_reciprocal_out.write(datapath::reciprocal_of(area, core_.stimulus.fraction));
            }
            clock_.advance(1);
        }
    }
}

}  // namespace faster
