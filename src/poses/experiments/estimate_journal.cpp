#include "poses/experiments/estimate_journal.hpp"

namespace faster::experiments {

Json to_json(EstimateResult const& result) {
    Json rotation = Json::array();
    for (Eigen::Index i = 0; i < 9; ++i)
        rotation.push_back(result.pose.rotation(i / 3, i % 3));
    Eigen::Vector3d const& t = result.pose.translation;
    return {{"R", rotation},
            {"t", {t.x(), t.y(), t.z()}},
            {"weight", result.weight},
            {"truth_weight", result.truth_weight},
            {"verdict", result.verdict},
            {"seconds", result.seconds},
            {"adds_mm", result.adds_mm}};
}

void from_json(Json const& json, EstimateResult& result) {
    for (Eigen::Index i = 0; i < 9; ++i)
        result.pose.rotation(i / 3, i % 3) = json.at("R").at(static_cast<std::size_t>(i)).get<double>();
    for (Eigen::Index i = 0; i < 3; ++i)
        result.pose.translation(i) = json.at("t").at(static_cast<std::size_t>(i)).get<double>();
    result.weight = json.at("weight").get<double>();
    result.truth_weight = json.at("truth_weight").get<double>();
    result.verdict = json.at("verdict").get<std::string>();
    result.seconds = json.at("seconds").get<double>();
    result.adds_mm = json.at("adds_mm").get<std::vector<double>>();
}

}  // namespace faster::experiments
