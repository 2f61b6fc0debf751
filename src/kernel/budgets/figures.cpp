#include "kernel/budgets/figures.hpp"

namespace faster::budgets {

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

}  // namespace faster::budgets
