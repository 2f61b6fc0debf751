#include "datapath/edge_map/edge_map_policy.hpp"

#include "datapath/edge_map/bounded_map.hpp"
#include "datapath/edge_map/dual_map.hpp"
#include "datapath/edge_map/dual_map_4_1_2.hpp"
#include "datapath/edge_map/inner_border.hpp"
#include "datapath/edge_map/threshold_map.hpp"
#include "datapath/edge_map/transition_map.hpp"

namespace faster::datapath {

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
            break;
    }
    return std::make_unique<DualMap>(window);
}

}  // namespace faster::datapath
