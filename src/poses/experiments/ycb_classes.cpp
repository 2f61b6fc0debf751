#include "poses/experiments/ycb_classes.hpp"

#include <algorithm>
#include <set>

namespace faster::experiments {

namespace {

bool is_box(std::string const& name) {
    static std::set<std::string> const names{"cracker_box", "sugar_box",  "pudding_box",
                                             "gelatin_box", "wood_block", "foam_brick"};
    return names.count(name) > 0;
}

bool is_can(std::string const& name) {
    static std::set<std::string> const names{"master_chef_can", "tomato_soup_can", "tuna_fish_can"};
    return names.count(name) > 0;
}

Pose half_turn(Eigen::Index axis) {
    Pose turn;
    turn.rotation = -Eigen::Matrix3d::Identity();
    turn.rotation(axis, axis) = 1;
    return turn;
}

}  // namespace

std::vector<std::string> const& ycb_classes() {
    static std::vector<std::string> const names{"master_chef_can",
                                                "cracker_box",
                                                "sugar_box",
                                                "tomato_soup_can",
                                                "mustard_bottle",
                                                "tuna_fish_can",
                                                "pudding_box",
                                                "gelatin_box",
                                                "potted_meat_can",
                                                "banana",
                                                "pitcher_base",
                                                "bleach_cleanser",
                                                "bowl",
                                                "mug",
                                                "power_drill",
                                                "wood_block",
                                                "scissors",
                                                "large_marker",
                                                "large_clamp",
                                                "extra_large_clamp",
                                                "foam_brick"};
    return names;
}

int obj_id_of(std::string const& name) {
    auto const& names = ycb_classes();
    auto const found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? 0 : static_cast<int>(found - names.begin()) + 1;
}

void add_symmetries(bop::ObjectModel& model, std::string const& name) {
    if (is_box(name))
        model.symmetries = {half_turn(0), half_turn(1), half_turn(2)};
    if (is_can(name))
        model.symmetries = {half_turn(0)};
    if (is_can(name) || name == "bowl")
        model.axes = {{}};
}

}  // namespace faster::experiments
