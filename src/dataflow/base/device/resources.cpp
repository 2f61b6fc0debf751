#include "dataflow/base/device/resources.hpp"

#include <algorithm>

namespace dataflow {

std::string_view name_of(ResourceBasis basis) {
    switch (basis) {
        case ResourceBasis::synthesized:
            return "synthesized";
        case ResourceBasis::interpolated:
            return "interpolated";
        case ResourceBasis::counted:
            return "counted";
        default:
            return "unknown";
    }
}

ResourcePart sum_of(std::string name, std::vector<ResourcePart> const& parts) {
    ResourcePart sum{std::move(name), {}, parts.empty() ? ResourceBasis::unknown : ResourceBasis::synthesized};
    for (ResourcePart const& part : parts) {
        sum.amount += part.amount;
        sum.basis = std::max(sum.basis, part.basis);
    }
    return sum;
}

}  // namespace dataflow
