#include "poses/commands/experiment_estimates.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>

#include "dataflow/base/enumerators.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/fnv1a.hpp"
#include "dataflow/base/host_clock.hpp"
#include "dataflow/run/config/key_value.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_file.hpp"
#include "faster/workload/files/pose_numbers.hpp"
#include "poses/bop/read_dataset.hpp"
#include "poses/commands/estimate_scene.hpp"
#include "poses/commands/estimate_scorers.hpp"
#include "poses/estimation/estimator.hpp"
#include "poses/judging/counted_poses.hpp"

namespace faster {

namespace {

/// Of all keys, and of the program.
std::string keys_text(LoadedConfig const& loaded) {
    std::string text = FASTER_VERSION "\n";
    for (ResolvedKey const& key : resolved_keys(loaded.config, KeyScope::all))
        text += key.key + "=" + json_text(key.value) + "\n";
    return text;
}

/// Contents of files by their path: each is read once.
class Contents {
  public:
    std::string const& hash_of(std::filesystem::path const& path) {
        std::string& hash = hashes_[path];
        if (hash.empty())
            hash = fnv1a_digits(io::read_file(path));
        return hash;
    }

  private:
    std::map<std::filesystem::path, std::string> hashes_;
};

std::string pose_identity(Pose const& pose) {
    Eigen::Vector3d const& t = pose.translation;
    return fmt::format("{} {} {} {}", files::row_major_text(pose.rotation), t.x(), t.y(), t.z());
}

std::string target_text(SettingData const& setting, bop::Target const& target, std::vector<bop::Detection> const& boxes,
                        Contents& contents) {
    bop::DatasetImage const& image = *setting.dataset.find(target.image);
    bop::ObjectModel const& model = bop::model_of(setting.dataset, target.obj_id, setting.dataset.place_of_targets());
    for (std::filesystem::path const& mesh : {model.mesh, model.judged_mesh})
        if (!mesh.empty())
            files::require_mesh_file(mesh);
    Camera const& c = image.camera;
    std::string text =
        fmt::format("{} {} {} {} {} {} {} {} {}\n", contents.hash_of(image.depth), contents.hash_of(model.mesh),
                    model.judged_mesh.empty() ? "" : contents.hash_of(model.judged_mesh), model.unit_m,
                    image.depth_unit_m, c.fx, c.fy, c.cx, c.cy);
    for (bop::GroundTruth const* const truth : poses::most_visible(setting.dataset, target))
        text += pose_identity(truth->pose) + "\n";
    for (bop::Detection const& box : boxes)
        text += fmt::format("{} {} {} {} {}\n", box.box.left, box.box.top, box.box.width, box.box.height, box.score);
    return text;
}

/// The boxes of each estimate of a target: all of them, or the best by score one by one.
std::vector<std::vector<bop::Detection>> looks_at(SettingData const& setting, bop::Target const& target) {
    std::vector<bop::Detection> boxes = setting.boxes_of(target);
    if (target.inst_count < 2)
        return {boxes};
    std::stable_sort(boxes.begin(), boxes.end(),
                     [](bop::Detection const& a, bop::Detection const& b) { return a.score > b.score; });
    boxes.resize(std::min(boxes.size(), static_cast<std::size_t>(target.inst_count)));
    std::vector<std::vector<bop::Detection>> looks;
    looks.reserve(boxes.size());
    for (bop::Detection const& box : boxes)
        looks.push_back({box});
    return looks;
}

/// What the true pose nearest to `pose` would weigh, in the best of the boxes; 0 if it is not known.
double truth_weight(estimation::Scene const& scene, Pose const& pose, EstimatorConfig const& config,
                    IterationScorer& scorer) {
    estimation::TruePose const* const truth = nearest_truth(scene, pose);
    if (truth == nullptr)
        return 0;
    std::vector<estimation::Particle> particles(std::max<std::size_t>(1, scene.boxes.size()));
    for (std::size_t i = 0; i < particles.size(); ++i)
        particles[i] = {estimation::rotation_of(truth->pose.rotation), truth->pose.translation, i};
    double most = 0;
    for (estimation::WeightTerms const& terms : scorer.score(particles))
        most = std::max(most, terms.weight(config.coefficients()));
    return most;
}

}  // namespace

std::vector<bop::Detection> const& SettingData::boxes_of(bop::Target const& target) const {
    static std::vector<bop::Detection> const none;
    auto const found = boxes.find({target.image, target.obj_id});
    return found == boxes.end() ? none : found->second;
}

std::vector<WantedEstimate> wanted_estimates(std::vector<SettingData> const& settings,
                                             std::vector<MethodData> const& methods) {
    std::vector<std::string> keys;
    keys.reserve(methods.size());
    for (MethodData const& method : methods)
        keys.push_back(keys_text(method.loaded));
    Contents contents;
    std::vector<WantedEstimate> wanted;
    for (SettingData const& setting : settings)
        for (bop::Target const& target : setting.dataset.targets) {
            for (std::vector<bop::Detection> const& boxes : looks_at(setting, target)) {
                std::string const text = target_text(setting, target, boxes, contents);
                for (std::size_t i = 0; i < methods.size(); ++i)
                    wanted.push_back({&setting, &methods[i], target, boxes, fnv1a_digits(keys[i] + text)});
            }
        }
    std::stable_sort(wanted.begin(), wanted.end(), [](WantedEstimate const& a, WantedEstimate const& b) {
        return a.target.image.im_id < b.target.image.im_id;
    });
    return wanted;
}

estimation::Scene scene_of(WantedEstimate const& wanted) {
    return dataset_scene(wanted.method->loaded, wanted.setting->dataset, wanted.target, wanted.boxes);
}

experiments::EstimateResult estimated(WantedEstimate const& wanted) {
    auto const start = HostClock::now();
    LoadedConfig const& loaded = wanted.method->loaded;
    EstimatorConfig const& config = estimator_of(loaded.config);
    estimation::Scene scene = scene_of(wanted);
    std::unique_ptr<IterationScorer> const scorer = make_scorer(loaded.config, scene, 1);
    experiments::EstimateResult result;
    double heaviest = -1, its_adds_mm = 0;
    estimation::Estimate const estimate = estimation::estimate(
        scene, config, workload_of(loaded.config).samples.count,
        [&](std::vector<estimation::Particle> const& particles) { return scorer->score(particles); },
        [&](estimation::Iteration const& iteration) {
            auto const off = distances_from_truth(scene, pose_of(iteration.particles[iteration.best], scene.size));
            if (!off)
                return;
            if (iteration.best_weight() > heaviest)
                its_adds_mm = 1000 * off->adds_m;
            heaviest = std::max(heaviest, iteration.best_weight());
            result.adds_mm.push_back(its_adds_mm);
        });
    Pose const pose = final_pose(scene, estimate.particle, config);
    result.truth_weight = truth_weight(scene, pose, config, *scorer);
    result.pose = scene.own(pose);
    result.weight = estimate.weight;
    result.verdict = enumerator_name(verdict_of(scene, estimate.weight, config));
    result.seconds = seconds_since(start);
    return result;
}

}  // namespace faster
