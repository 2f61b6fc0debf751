#include "kernel/recording/signal_filter.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fnmatch.h>
#include <utility>

#include "kernel/base/input_error.hpp"
#include "kernel/base/nearest_name.hpp"

namespace faster::recording {

namespace {
std::vector<std::string> all_names(Parts const& parts) {
    std::vector<std::string> names;
    for (std::size_t const module : modules_of(parts))
        names.emplace_back(module_names[module]);
    for (std::size_t const fifo : fifos_of(parts))
        names.emplace_back(fifo_names[fifo]);
    for (std::size_t const bram : brams_of(parts))
        names.emplace_back(bram_names[bram]);
    return names;
}
bool fits(std::string const& pattern, char const* name) { return fnmatch(pattern.c_str(), name, 0) == 0; }
}  // namespace

SignalFilter::SignalFilter(std::vector<std::string> patterns, Parts const& parts)
    : patterns_(std::move(patterns)), parts_(parts) {
    std::vector<std::string> const names = all_names(parts);
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

bool SignalFilter::shows(ModuleId module) const { return has_part(parts_, module) && matches(name_of(module)); }
bool SignalFilter::shows(FifoId fifo) const {
    FifoEnds const ends = ends_of(parts_, fifo);
    return has_part(parts_, fifo) && (matches(name_of(fifo)) || shows(ends.writer) || shows(ends.reader));
}
bool SignalFilter::shows(BramId bram) const {
    return has_part(parts_, bram) && (matches(name_of(bram)) || shows(owner_of(bram)) || shows(reader_of(bram)));
}

}  // namespace faster::recording
