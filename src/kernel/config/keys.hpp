#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "faster/parts.hpp"
#include "kernel/config/key.hpp"

namespace faster {

using Keys = std::vector<Key>;

/// Every configuration key, once, in the order of the documentation. Keys of one section stand together.
Keys const& all_keys();

/// Those that decide how long a run takes and nothing else: depths and latencies of FIFOs, initiation intervals and
/// depths of loops, ports of block RAMs. All are integers. Without those of parts that are not there.
Keys timing_keys(Parts const& parts);

/// Those that may be changed without running the function again: timing_keys(), the kinds of FIFOs, partitions of block
/// RAMs, how many cores share the samples, the clock.
Keys retiming_keys();

/// The key of that dotted name, or null.
Key const* find_key(std::string_view name);

/// True if keys stand below `name`: "accelerator.fifos", but not "accelerator.window".
bool is_section(std::string_view name);

/// What may follow in a section, e.g. "raster_cores", "window", ... for "accelerator". The root is "".
std::vector<std::string> names_in_section(std::string_view section);

/// What is wrong with a dotted name that is neither key nor section, and what it was probably meant to be.
std::string unknown_key_problem(std::string_view name);

/// A key of one item of `workload.scene.objects`.
struct SceneObjectKey {
    KeyText text;  ///< the name is the last part only
    KeyKind kind = KeyKind::vector;
    bool required = false;
    std::string SceneObjectConfig::*object = nullptr;             ///< KeyKind::object
    std::array<double, 3> SceneObjectConfig::*numbers = nullptr;  ///< KeyKind::vector
};
std::vector<SceneObjectKey> const& scene_object_keys();

/// Parts of all_keys().
Keys accelerator_keys();
Keys workload_keys();

}  // namespace faster
