#include "recording/signal_filter.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fnmatch.h>
#include <utility>

#include "common/input_error.hpp"
#include "common/nearest_name.hpp"

namespace faster::recording {

namespace {
std::vector<std::string> all_names() {
    std::vector<std::string> names(module_names.begin(), module_names.end());
    names.insert(names.end(), fifo_names.begin(), fifo_names.end());
    names.insert(names.end(), bram_names.begin(), bram_names.end());
    return names;
}
bool fits(std::string const& pattern, char const* name) { return fnmatch(pattern.c_str(), name, 0) == 0; }
}  // namespace

SignalFilter::SignalFilter(std::vector<std::string> patterns) : patterns_(std::move(patterns)) {
    std::vector<std::string> const names = all_names();
    for (std::string const& pattern : patterns_) {
        auto const hit = [&pattern](std::string const& name) { return fits(pattern, name.c_str()); };
        if (std::none_of(names.begin(), names.end(), hit))
            throw InputError(
                fmt::format("--vcd-modules {}: matches no module, FIFO or block RAM, expected a name or a "
                            "pattern such as 'inlier*'{}",
                            pattern, did_you_mean(pattern, names)));
    }
}

bool SignalFilter::matches(char const* name) const {
    return patterns_.empty() || std::any_of(patterns_.begin(), patterns_.end(),
                                            [name](std::string const& pattern) { return fits(pattern, name); });
}

bool SignalFilter::shows(ModuleId module) const { return matches(name_of(module)); }
bool SignalFilter::shows(FifoId fifo) const {
    FifoEnds const& ends = fifo_ends[index_of(fifo)];
    return matches(name_of(fifo)) || shows(ends.writer) || shows(ends.reader);
}
bool SignalFilter::shows(BramId bram) const { return matches(name_of(bram)) || shows(owner_of(bram)); }

}  // namespace faster::recording
