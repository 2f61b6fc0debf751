#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "poses/bop/dataset.hpp"
#include "poses/judging/bootstrap.hpp"
#include "poses/judging/judge.hpp"

namespace faster::poses {

/// A method's estimates, judged.
struct JudgedMethod {
    std::string name;
    Judgement judgement;
    double mean_time_s = -1;  ///< per image, of those with a time; -1 unknown
};

/// A line of the table: a method on an object, on all instances together, or the mean of its objects' scores.
struct ScoreRow {
    enum class Of { object, all, mean };

    std::string method;
    Of of = Of::object;
    int obj_id = 0;      ///< 0 but for an object
    std::string object;  ///< its name; "all", "mean"
    std::size_t images = 0;
    std::size_t instances = 0;
    std::size_t estimated = 0;  ///< instances that have an estimate, however bad
    std::array<Interval, score_count> scores;
    std::array<Interval, score_count> more_than_first;  ///< score less that of the first method, on the same images
};

/// Errors by which a curve of accuracy rises, ascending, up to 0.1 m.
struct AccuracyCurve {
    std::string method;
    int obj_id = 0;  ///< 0: all
    std::string object;
    std::size_t instances = 0;
    std::vector<double> add_s_m, add_m;
};

/// Methods side by side on one dataset.
struct Evaluation {
    std::string dataset;
    std::size_t images = 0;                 ///< that hold an instance
    double visible_from = 0;                ///< only instances of which at least this share is visible
    std::size_t of_unknown_visibility = 0;  ///< instances that stay for want of knowing
    std::uint64_t seed = 0;
    std::size_t replicates = 0;
    std::vector<JudgedMethod> methods;
    std::vector<ScoreRow> rows;  ///< by method; objects by id, then all, then mean; a score that is not known is NaN
    std::vector<AccuracyCurve> curves;
};

struct EvaluationOptions {
    double visible_from = 0;  ///< leaves out instances of which less is visible; those of which it is not known stay
    std::uint64_t seed = 1;   ///< of the bootstrap
    std::size_t replicates = 1000;
};

/// Scores with their intervals: 95 % of `replicates` bootstraps over images. All methods see the same draws, so that
/// differences between them have intervals of their own. Throws InputError if there are no instances.
Evaluation evaluate(bop::Dataset const& dataset, std::vector<JudgedMethod> methods, EvaluationOptions const& options);

}  // namespace faster::poses
