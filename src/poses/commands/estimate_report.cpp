#include "poses/commands/estimate_report.hpp"

#include <fmt/format.h>
#include <iterator>
#include <nlohmann/json.hpp>

#include "dataflow/base/enumerators.hpp"
#include "dataflow/run/config/key_value.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

namespace {

using Json = nlohmann::ordered_json;

std::string sentence_on(EstimateReport const& report) {
    switch (report.verdict) {
        case Verdict::weak:
            return fmt::format("Weak: the best weight is {:.4f}, below estimator.least_weight.", report.weight);
        case Verdict::no_readings:
            return "Not found: the depth image has no readings in the box.";
        case Verdict::found:
            break;
    }
    return fmt::format("Found, with weight {:.4f}.", report.weight);
}

template <class Number> std::string cell(std::optional<Number> const& value, char const* format) {
    return value ? fmt::format(fmt::runtime(format), *value) : "";
}

std::optional<double> add_mm(IterationRow const& row) {
    return row.best ? std::optional<double>(1000 * row.best->add_m) : std::nullopt;
}
std::optional<double> adds_mm(IterationRow const& row) {
    return row.best ? std::optional<double>(1000 * row.best->adds_m) : std::nullopt;
}

std::string text_row(IterationRow const& row) {
    return fmt::format("  {:>9} {:>11.4f} {:>11.4f} {:>9.1f} {:>11.2f} {:>12.2f} {:>9} {:>10} {:>9}\n", row.number,
                       row.best_weight, row.mean_weight, row.effective_samples, row.spread_mm, row.spread_deg,
                       cell(add_mm(row), "{:.2f}"), cell(adds_mm(row), "{:.2f}"), cell(row.iteration_ms, "{:.3f}"));
}

/// Few enough to be read.
bool is_printed(std::size_t index, std::size_t count) {
    constexpr std::size_t first_all = 3, then_every = 5;
    return index < first_all || index % then_every == 0 || index + 1 == count;
}

std::string pose_text(Pose const& pose) {
    std::string text = fmt::format("  translation [m]  {:.6f} {:.6f} {:.6f}\n", pose.translation.x(),
                                   pose.translation.y(), pose.translation.z());
    for (Eigen::Index row = 0; row < 3; ++row)
        text += fmt::format("  {:<15}  {:>9.6f} {:>9.6f} {:>9.6f}\n", row == 0 ? "rotation" : "", pose.rotation(row, 0),
                            pose.rotation(row, 1), pose.rotation(row, 2));
    return text;
}

Json pose_json(Pose const& pose) {
    Json rotation = Json::array();
    for (Eigen::Index row = 0; row < 3; ++row)
        rotation.push_back({pose.rotation(row, 0), pose.rotation(row, 1), pose.rotation(row, 2)});
    return {{"rotation", rotation},
            {"translation_m", {pose.translation.x(), pose.translation.y(), pose.translation.z()}}};
}

Json estimate_or_null(std::optional<Estimate> const& estimate) {
    return estimate ? Json{{"low", estimate->low}, {"typical", estimate->typical}, {"high", estimate->high}}
                    : Json(nullptr);
}

std::string estimate_cells(std::optional<Estimate> const& estimate) {
    return estimate ? fmt::format("{:.4f},{:.4f},{:.4f}", estimate->low, estimate->typical, estimate->high) : ",,";
}

Json iteration_json(IterationRow const& row) {
    return {{"iteration", row.number},
            {"run", row.run},
            {"best_sample", row.best_sample},
            {"best_weight", row.best_weight},
            {"mean_weight", row.mean_weight},
            {"effective_samples", row.effective_samples},
            {"spread_mm", row.spread_mm},
            {"spread_deg", row.spread_deg},
            {"translation_sigma_mm", row.translation_sigma_mm},
            {"rotation_sigma_deg", row.rotation_sigma_deg},
            {"best_add_mm", or_null(add_mm(row))},
            {"best_adds_mm", or_null(adds_mm(row))},
            {"cycles", or_null(row.cycles)},
            {"accelerator_ms", or_null(row.accelerator_ms)},
            {"iteration_ms", or_null(row.iteration_ms)},
            {"energy_mj", estimate_or_null(row.energy_mj)}};
}

Json boxes_json(std::vector<DetectionConfig> const& boxes) {
    Json list = Json::array();
    for (DetectionConfig const& box : boxes)
        list.push_back({{"left", box.left},
                        {"top", box.top},
                        {"width", box.width},
                        {"height", box.height},
                        {"confidence", box.confidence}});
    return list;
}

Json keys_json(std::vector<ResolvedKey> const& keys) {
    Json object = Json::object();
    for (ResolvedKey const& key : keys)
        object[key.key] = Json::parse(json_text(key.value));
    return object;
}

}  // namespace

std::optional<double> EstimateReport::total_ms() const {
    double total = refine_ms;
    for (IterationRow const& row : iterations) {
        if (!row.iteration_ms)
            return std::nullopt;
        total += *row.iteration_ms;
    }
    return total;
}

std::optional<Estimate> EstimateReport::total_mj() const {
    Estimate total = refine_mj.value_or(Estimate{});
    for (IterationRow const& row : iterations) {
        if (!row.energy_mj)
            return std::nullopt;
        total = total + *row.energy_mj;
    }
    return total;
}

std::string estimate_text(EstimateReport const& report) {
    std::string text = fmt::format("Pose of {}: {} iterations of {} samples, scored by {}\n\n", report.object,
                                   report.iterations.size(), report.samples, report.scorer);
    text += fmt::format("  {:>9} {:>11} {:>11} {:>9} {:>11} {:>12} {:>9} {:>10} {:>9}\n", "iteration", "best weight",
                        "mean weight", "effective", "spread [mm]", "spread [deg]", "ADD [mm]", "ADD-S [mm]", "ms");
    for (std::size_t i = 0; i < report.iterations.size(); ++i)
        if (is_printed(i, report.iterations.size()))
            text += text_row(report.iterations[i]);
    text += "\n" + sentence_on(report) + (report.stopped_early ? " Stopped by estimator.stop_weight.\n" : "\n");
    if (report.runs > 1)
        text += fmt::format("  run {} of {}, the heaviest\n", report.run + 1, report.runs);
    text += pose_text(report.pose);
    if (report.distances)
        text += fmt::format("  from the truth   ADD {:.2f} mm, ADD-S {:.2f} mm\n", 1000 * report.distances->add_m,
                            1000 * report.distances->adds_m);
    if (std::optional<double> const total = report.total_ms())
        text += fmt::format(
            "  time             {:.3f} ms, of which the host {:.3f} ms\n", *total,
            report.refine_ms + static_cast<double>(report.iterations.size()) *
                                   (report.host.start_us + report.host.collect_us + report.host.resample_us) / 1000);
    if (std::optional<Estimate> const total = report.total_mj())
        text += fmt::format("  energy           {:.2f} J ({:.2f} to {:.2f}), processing system included\n",
                            total->typical / 1000, total->low / 1000, total->high / 1000);
    return text;
}

std::string estimate_csv(EstimateReport const& report) {
    std::string text =
        "iteration,best_sample,best_weight,mean_weight,effective_samples,spread_mm,spread_deg,translation_sigma_mm,"
        "rotation_sigma_deg,best_add_mm,best_adds_mm,cycles,accelerator_ms,iteration_ms,energy_low_mj,"
        "energy_mj,energy_high_mj,run\n";
    for (IterationRow const& row : report.iterations)
        fmt::format_to(std::back_inserter(text),
                       "{},{},{:.9f},{:.9f},{:.3f},{:.4f},{:.4f},{:.4f},{:.4f},{},{},{},{},{},{},{}\n", row.number,
                       row.best_sample, row.best_weight, row.mean_weight, row.effective_samples, row.spread_mm,
                       row.spread_deg, row.translation_sigma_mm, row.rotation_sigma_deg, cell(add_mm(row), "{:.4f}"),
                       cell(adds_mm(row), "{:.4f}"), cell(row.cycles, "{}"), cell(row.accelerator_ms, "{:.6f}"),
                       cell(row.iteration_ms, "{:.6f}"), estimate_cells(row.energy_mj), row.run);
    return text;
}

std::string estimate_json(EstimateReport const& report) {
    Json json;
    json["format"] = "faster-estimate";
    json["version"] = 1;
    json["object"] = report.object;
    json["scorer"] = report.scorer;
    json["samples"] = report.samples;
    json["seed"] = report.seed;
    json["boxes"] = boxes_json(report.boxes);
    json["verdict"] = enumerator_name(report.verdict);
    json["pose"] = pose_json(report.pose);
    json["weight"] = report.weight;
    json["runs"] = report.runs;
    json["run"] = report.run;
    json["stopped_early"] = report.stopped_early;
    json["truth"] = report.truth ? pose_json(*report.truth) : Json(nullptr);
    json["add_mm"] = report.distances ? Json(1000 * report.distances->add_m) : Json(nullptr);
    json["adds_mm"] = report.distances ? Json(1000 * report.distances->adds_m) : Json(nullptr);
    json["refine_ms"] = report.refine_ms;
    json["total_ms"] = or_null(report.total_ms());
    json["total_mj"] = estimate_or_null(report.total_mj());
    json["iterations"] = Json::array();
    for (IterationRow const& row : report.iterations)
        json["iterations"].push_back(iteration_json(row));
    json["configuration"] = keys_json(report.keys);
    return json.dump(2) + "\n";
}

}  // namespace faster
