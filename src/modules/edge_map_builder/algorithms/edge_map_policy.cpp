#include "modules/edge_map_builder/algorithms/edge_map_policy.hpp"

#include <stdexcept>

#include "modules/edge_map_builder/algorithms/bounded_map.hpp"
#include "modules/edge_map_builder/algorithms/dual_map.hpp"
#include "modules/edge_map_builder/algorithms/dual_map_4_1_2.hpp"
#include "modules/edge_map_builder/algorithms/inner_border.hpp"
#include "modules/edge_map_builder/algorithms/threshold_map.hpp"
#include "modules/edge_map_builder/algorithms/transition_map.hpp"

namespace faster::datapath {

void EdgeMapPolicy::take_run(int row, int first_col, int end_col, bool rightwards) {
    for (int i = 0; i < end_col - first_col; ++i) {
        int const col = rightwards ? first_col + i : end_col - 1 - i;
        take({static_cast<std::int16_t>(row), static_cast<std::int16_t>(col), EdgeTokenKind::Object}, nullptr, 1);
    }
}

std::unique_ptr<EdgeMapPolicy> make_edge_map_policy(EdgeMapAlgorithm algorithm, int window) {
    switch (algorithm) {
        case EdgeMapAlgorithm::threshold:
            return std::make_unique<ThresholdMap>(window);
        case EdgeMapAlgorithm::transition:
            return std::make_unique<TransitionMap>(window);
        case EdgeMapAlgorithm::bounded:
            return std::make_unique<BoundedMap>(window);
        case EdgeMapAlgorithm::dual_map_4_1_2:
            return std::make_unique<DualMapFirstWrite>(window);
        case EdgeMapAlgorithm::inner_border:
            return std::make_unique<InnerBorder>(window);
        case EdgeMapAlgorithm::dual_map:
            return std::make_unique<DualMap>(window);
    }
    throw std::logic_error("an edge map algorithm without a class");
}

}  // namespace faster::datapath
