#pragma once
#include <string>

#include "dataflow/core/machine/module_description.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/key_builders.hpp"
#include "dataflow/run/config/key_names.hpp"
#include "dataflow/run/config/keys.hpp"

namespace dataflow {

/// The keys of a core's FIFOs, loops, setups and block RAMs, in the order of the description; parts that a
/// configuration does not have are among them. Their defaults and their texts are the description's.
Keys machine_keys(CoreDescription const& core);

/// What bounds the stages of a module's loop: its key `depth`, or `states` if it is not pipelined.
std::string stages_key_name(ModuleDescription const& module, std::string const& loop);

/// How many cores share the samples; name, meaning and source are the design's.
Key cores_key(std::string name, std::string meaning, std::string source);

/// accelerator.clock_mhz
Key clock_key(std::string source);

/// accelerator.fifo_rules
Key fifo_rules_key();

/// accelerator.calls
Key calls_key();

/// accelerator.architecture, for a design with presets. `field`: where its `Config` keeps the name.
template <class Config, class Field> Key architecture_key(std::string source, Field field) {
    Key key = KeyMaker<Config>::make_key(
        {architecture_key_name, "",
         "A design to start from: a file of configs/architectures, whose values the other keys here change.",
         std::move(source)},
        KeyKind::choice, field);
    key.choices = preset_names();
    return key;
}

}  // namespace dataflow
