#include "kernel/budgets/figures.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace faster::budgets {

namespace {

bool ends_with(std::string_view text, std::string_view ending) {
    return text.size() >= ending.size() && text.substr(text.size() - ending.size()) == ending;
}

template <std::size_t N> bool is_one_of(std::string_view word, std::array<std::string_view, N> const& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool has_part(std::vector<std::string> const& parts, std::string_view part) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
}

}  // namespace

void Figures::set(std::string const& name, std::uint64_t value) {
    auto const [found, is_new] = index_.try_emplace(name, all_.size());
    if (is_new)
        all_.push_back({name, value});
    all_[found->second].value = value;
}

std::optional<std::uint64_t> Figures::find(std::string const& name) const {
    auto const found = index_.find(name);
    return found == index_.end() ? std::nullopt : std::optional(all_[found->second].value);
}

std::vector<std::string> parts_of(std::string const& name) {
    std::vector<std::string> parts(1);
    for (char const letter : name)
        if (letter == '.')
            parts.emplace_back();
        else
            parts.back() += letter;
    return parts;
}

bool is_in_cycles(std::string const& name) {
    if (ends_with(name, "_cycles") || ends_with(name, "_cycle") || ends_with(name, ".write_latency"))
        return true;
    std::vector<std::string> const parts = parts_of(name);
    if (has_part(parts, "stalls") || has_part(parts, "port_conflicts"))
        return true;
    constexpr std::array<std::string_view, 4> loop_shapes{"ii_target", "ii_recurrence", "ii", "depth"};
    return has_part(parts, "loops") && is_one_of(parts.back(), loop_shapes);
}

bool is_largest_over_cores(std::string const& name) {
    constexpr std::array<std::string_view, 10> shapes{
        "depth",         "capacity", "write_latency", "max_occupancy", "ii_target",
        "ii_recurrence", "ii",       "words",         "bits",          "ports"};
    return is_one_of(parts_of(name).back(), shapes);
}

}  // namespace faster::budgets
