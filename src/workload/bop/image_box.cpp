#include "workload/bop/image_box.hpp"

namespace faster::bop {

ImageBox read_box(JsonNode const& node) {
    std::vector<double> const numbers = node.numbers(4);
    if (numbers[2] < 0 || numbers[3] < 0)
        node.fail("a box x, y, width, height of no negative size");
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

}  // namespace faster::bop
