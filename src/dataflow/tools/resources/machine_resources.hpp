#pragma once
#include <optional>
#include <string>
#include <vector>

#include "dataflow/base/device/resources.hpp"
#include "dataflow/core/machine/machine.hpp"

namespace dataflow {

/// What a machine takes of a device. Everything is of one core, but for `cores`, `beside` and `chip`.
struct MachineResources {
    struct Module {
        ResourcePart sum;
        std::vector<ResourcePart> parts;
        std::optional<UnitPath> slowest;  ///< by what a stage of it takes; none if the design does not tell
    };
    std::vector<Module> modules;         ///< those that are there; none if the design does not tell
    std::vector<ResourcePart> fifos;     ///< those that are there
    std::vector<ResourcePart> memories;  ///< likewise, and line buffers: ramb36_count()
    ResourcePart core;
    ResourcePart cores;
    Resources beside;       ///< what the chip has beside the cores
    std::string beside_is;  ///< what that is; empty: not known, and nothing
    Resources chip;         ///< cores, and what is beside them

    bool fits(Device const& device) const;
};

MachineResources resources_of(Machine const& machine);

}  // namespace dataflow
