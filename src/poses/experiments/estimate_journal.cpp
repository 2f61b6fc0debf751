#include "poses/experiments/estimate_journal.hpp"

#include "dataflow/base/files/durable_file.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/tools/sweeps/journal_rows.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::experiments {

namespace {

std::string row_of(std::string const& id, EstimateResult const& result) {
    return sweeps::journal_row({{"estimate", id}, {"result", to_json(result)}});
}

/// Damaged rows are taken out of the file.
std::size_t read_cleaned(std::filesystem::path const& path, std::map<std::string, EstimateResult>& results) {
    if (!std::filesystem::exists(path))
        return 0;
    std::size_t const damaged = sweeps::read_journal_rows(io::read_file(path), [&](Json const& row) {
        results[row.at("estimate").get<std::string>()] = estimate_result_from_json(row.at("result"));
    });
    if (damaged > 0) {
        std::string text;
        for (auto const& [id, result] : results)
            text += row_of(id, result);
        io::write_file_durably(path, text);
    }
    return damaged;
}

}  // namespace

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

EstimateResult estimate_result_from_json(Json const& json) {
    EstimateResult result;
    for (Eigen::Index i = 0; i < 9; ++i)
        result.pose.rotation(i / 3, i % 3) = json.at("R").at(static_cast<std::size_t>(i)).get<double>();
    for (Eigen::Index i = 0; i < 3; ++i)
        result.pose.translation(i) = json.at("t").at(static_cast<std::size_t>(i)).get<double>();
    result.weight = json.at("weight").get<double>();
    result.truth_weight = json.at("truth_weight").get<double>();
    result.verdict = json.at("verdict").get<std::string>();
    result.seconds = json.at("seconds").get<double>();
    result.adds_mm = json.at("adds_mm").get<std::vector<double>>();
    return result;
}

EstimateJournal::EstimateJournal(std::filesystem::path const& path)
    : damaged_(read_cleaned(path, results_)), file_(path) {}

EstimateResult const* EstimateJournal::find(std::string const& id) const {
    auto const found = results_.find(id);
    return found == results_.end() ? nullptr : &found->second;
}

void EstimateJournal::append(std::string const& id, EstimateResult const& result) {
    file_.append(row_of(id, result));
    results_[id] = result;
}

}  // namespace faster::experiments
