#include "faster/retimable.hpp"

#include <set>
#include <string>

#include "faster/clear_design.hpp"
#include "kernel/config/key_names.hpp"
#include "kernel/config/keys.hpp"

namespace faster {

namespace {

std::set<std::string> names_of(Keys const& keys) {
    std::set<std::string> names;
    for (Key const& key : keys)
        names.insert(key.name());
    return names;
}

/// A loop that clears a word of every bank takes more or less of them.
bool moves_wide_clearing(std::string const& key, AcceleratorConfig const& config) {
    for (std::size_t i = 0; i < bram_count; ++i)
        if (key.rfind(bram_key_name(BramId{i}, "partition."), 0) == 0)
            return clearing_of(BramId{i}, config) == MapClearing::wide;
    return false;
}

}  // namespace

bool is_retimable(Key const& key, AcceleratorConfig const& config) {
    static std::set<std::string> const retimable = names_of(retiming_keys());
    return retimable.count(key.name()) > 0 && !moves_wide_clearing(key.name(), config);
}

}  // namespace faster
