#include "poses/judging/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <set>

#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::poses {
namespace {

/// Scores of one row: as they are, then of each draw.
using Replicates = std::vector<Scores>;

using Instances = std::vector<InstanceErrors>;

void leave_out_hidden(Instances& instances, double visible_from) {
    auto const is_hidden = [&](InstanceErrors const& instance) {
        return instance.visible_share.value_or(1) < visible_from;
    };
    instances.erase(std::remove_if(instances.begin(), instances.end(), is_hidden), instances.end());
}

/// Numbers of the images that hold an instance, in their order.
std::map<bop::ImageId, std::size_t> numbered_images(Instances const& instances) {
    std::map<bop::ImageId, std::size_t> numbers;
    for (InstanceErrors const& instance : instances)
        numbers[instance.image] = 0;
    std::size_t number = 0;
    for (auto& [image, its_number] : numbers)
        its_number = number++;
    return numbers;
}

std::set<int> objects_of(Instances const& instances) {
    std::set<int> objects;
    for (InstanceErrors const& instance : instances)
        objects.insert(instance.obj_id);
    return objects;
}

/// Those of an object; of all, if it is 0.
Instances instances_of(Judgement const& judgement, int obj_id) {
    Instances found;
    for (InstanceErrors const& instance : judgement.instances) {
        if (obj_id == 0 || instance.obj_id == obj_id)
            found.push_back(instance);
    }
    return found;
}

std::vector<double> ascending_up_to_limit(Instances const& instances, double InstanceErrors::*error) {
    std::vector<double> errors;
    for (InstanceErrors const& instance : instances) {
        if (instance.*error <= largest_add_m)
            errors.push_back(instance.*error);
    }
    std::sort(errors.begin(), errors.end());
    return errors;
}

std::array<Interval, score_count> intervals(Replicates const& replicates, Replicates const* first) {
    std::array<Interval, score_count> result;
    for (std::size_t score = 0; score < score_count; ++score) {
        std::vector<double> values;
        for (std::size_t i = 0; i < replicates.size(); ++i)
            values.push_back(replicates[i][score] - (first == nullptr ? 0 : (*first)[i][score]));
        result[score] = interval_of(values.front(), {values.begin() + 1, values.end()});
    }
    return result;
}

/// Of those rows of which draw `i` holds an instance.
double mean_of_known(std::vector<Replicates> const& rows, std::size_t i, std::size_t score) {
    double sum = 0, known = 0;
    for (Replicates const& row : rows) {
        bool const is_known = !std::isnan(row[i][score]);
        sum += is_known ? row[i][score] : 0;
        known += is_known ? 1 : 0;
    }
    return sum / known;
}

/// Score by score the mean of the rows', of those scores of which a mean says something and that all rows have.
Replicates mean_of(std::vector<Replicates> const& rows) {
    Replicates means(rows.front().size());
    for (std::size_t score = 0; score < score_count; ++score) {
        bool const has_mean =
            score_facts[score].has_mean &&
            std::none_of(rows.begin(), rows.end(), [&](auto const& row) { return std::isnan(row.front()[score]); });
        for (std::size_t i = 0; i < means.size(); ++i)
            means[i][score] = has_mean ? mean_of_known(rows, i, score) : std::numeric_limits<double>::quiet_NaN();
    }
    return means;
}

class Evaluator {
  public:
    /// All methods have the same instances.
    Evaluator(bop::Dataset const& dataset, Instances const& instances, EvaluationOptions const& options)
        : dataset_(dataset), image_numbers_(numbered_images(instances)), objects_(objects_of(instances)) {
        draws_ = drawn_images(image_numbers_.size(), options.replicates, options.seed);
        draws_.insert(draws_.begin(), ImageWeights(image_numbers_.size(), 1));  // the images as they are
    }

    std::size_t images() const { return image_numbers_.size(); }

    void add(JudgedMethod const& method, Evaluation& evaluation) {
        std::vector<Replicates> of_objects;
        for (int const obj_id : objects_)
            of_objects.push_back(add_row(method, obj_id, evaluation));
        add_row(method, 0, evaluation);
        add_mean(method, mean_of(of_objects), evaluation);
    }

  private:
    std::string name_of(int obj_id) const { return obj_id == 0 ? "all" : dataset_.models.at(obj_id).name; }

    Replicates replicates_of(Instances const& instances) const {
        std::vector<std::size_t> numbers;
        for (InstanceErrors const& instance : instances)
            numbers.push_back(image_numbers_.at(instance.image));
        ScoredInstances const scored(instances, numbers);
        Replicates replicates;
        replicates.reserve(draws_.size());
        for (ImageWeights const& draw : draws_)
            replicates.push_back(scored.scores(draw));
        return replicates;
    }

    /// The row's scores beside those of the first method, whose row of the same name came first.
    void set_scores(ScoreRow& row, Replicates const& replicates) {
        auto const& first = first_.emplace(std::pair(row.of, row.obj_id), replicates).first->second;
        row.scores = intervals(replicates, nullptr);
        row.more_than_first = intervals(replicates, &first);
    }

    Replicates add_row(JudgedMethod const& method, int obj_id, Evaluation& evaluation) {
        Instances const instances = instances_of(method.judgement, obj_id);
        ScoreRow row;
        row.method = method.name;
        row.of = obj_id == 0 ? ScoreRow::Of::all : ScoreRow::Of::object;
        row.obj_id = obj_id;
        row.object = name_of(obj_id);
        row.instances = instances.size();
        std::set<bop::ImageId> images;
        for (InstanceErrors const& instance : instances) {
            images.insert(instance.image);
            row.estimated += std::isfinite(instance.add_m) ? 1U : 0U;
        }
        row.images = images.size();
        Replicates replicates = replicates_of(instances);
        set_scores(row, replicates);
        evaluation.rows.push_back(row);
        evaluation.curves.push_back({method.name, obj_id, row.object, row.instances,
                                     ascending_up_to_limit(instances, &InstanceErrors::add_s_m),
                                     ascending_up_to_limit(instances, &InstanceErrors::add_m)});
        return replicates;
    }

    void add_mean(JudgedMethod const& method, Replicates const& replicates, Evaluation& evaluation) {
        ScoreRow row = evaluation.rows.back();  // of all: the same images and instances
        row.method = method.name;
        row.of = ScoreRow::Of::mean;
        row.object = "mean";
        set_scores(row, replicates);
        evaluation.rows.push_back(row);
    }

    bop::Dataset const& dataset_;
    std::map<bop::ImageId, std::size_t> image_numbers_;
    std::set<int> objects_;
    std::vector<ImageWeights> draws_;
    std::map<std::pair<ScoreRow::Of, int>, Replicates> first_;  // rows of the first method
};

}  // namespace

Evaluation evaluate(bop::Dataset const& dataset, std::vector<JudgedMethod> methods, EvaluationOptions const& options) {
    for (JudgedMethod& method : methods)
        leave_out_hidden(method.judgement.instances, options.visible_from);
    Instances const& instances = methods.front().judgement.instances;
    if (instances.empty())
        throw InputError(dataset.folder.string() + ": holds no true poses to compare with, expected some" +
                         (options.visible_from > 0
                              ? fmt::format(" of which --visible-from {:g} is visible", options.visible_from)
                              : ""));
    Evaluator evaluator(dataset, instances, options);
    Evaluation evaluation;
    evaluation.dataset = dataset.folder.string();
    evaluation.images = evaluator.images();
    evaluation.visible_from = options.visible_from;
    evaluation.of_unknown_visibility = static_cast<std::size_t>(std::count_if(
        instances.begin(), instances.end(), [](InstanceErrors const& instance) { return !instance.visible_share; }));
    evaluation.seed = options.seed;
    evaluation.replicates = options.replicates;
    evaluation.methods = std::move(methods);
    for (JudgedMethod const& method : evaluation.methods)
        evaluator.add(method, evaluation);
    return evaluation;
}

}  // namespace faster::poses
