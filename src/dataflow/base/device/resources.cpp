#include "dataflow/base/device/resources.hpp"

#include <algorithm>

namespace dataflow {

ResourcePart sum_of(std::string name, std::vector<ResourcePart> const& parts) {
    ResourcePart sum{std::move(name), {}, parts.empty() ? ResourceBasis::unknown : ResourceBasis::synthesized};
    for (ResourcePart const& part : parts) {
        sum.amount += part.amount;
        sum.basis = std::max(sum.basis, part.basis);
    }
    return sum;
}

}  // namespace dataflow
