#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>

#include "faster/dataflow_names.hpp"
#include "poses/bop/read_dataset.hpp"
#include "poses/judging/accuracy_plot.hpp"
#include "poses/judging/evaluation.hpp"
#include "poses/judging/evaluation_json.hpp"
#include "poses/judging/evaluation_text.hpp"
#include "poses/judging/judge.hpp"
#include "poses/judging/scores.hpp"
#include "poses/judging/visible_surface.hpp"
#include "support/bop_folder.hpp"
#include "support/input_error_text.hpp"

namespace pose_judge_test {

using namespace faster;
using namespace faster::poses;
using faster::bop::Dataset;
using faster::bop::PoseEstimate;
using faster::test::BopFolder;
using faster::test::input_error_text;
using Estimates = std::vector<PoseEstimate>;

/// Every target's true pose, shifted along x.
Estimates shifted_truths(Dataset const& dataset, double metres) {
    Estimates estimates;
    for (bop::DatasetImage const& image : dataset.images) {
        for (bop::GroundTruth const& object : image.objects) {
            PoseEstimate estimate{image.id, object.obj_id, 1, object.pose, 0.5, estimates.size() + 2, {}};
            estimate.pose.translation.x() += metres;
            estimates.push_back(estimate);
        }
    }
    return estimates;
}

Judgement judged(Dataset const& dataset, Estimates const& estimates, std::size_t jobs = 2) {
    return judge(dataset, estimates, "r.csv", {jobs, 0.015});
}

std::string complaint(Dataset const& dataset, Estimates const& estimates) {
    return input_error_text([&] { judged(dataset, estimates); });
}

ScoreRow const& row_of(Evaluation const& evaluation, std::string const& method, std::string const& object) {
    for (ScoreRow const& row : evaluation.rows) {
        if (row.method == method && row.object == object)
            return row;
    }
    throw std::logic_error("no row " + method + ", " + object);
}

/// The second method misses an object, and is 30 mm off elsewhere.
Evaluation two_methods(Dataset const& dataset, std::size_t jobs = 2) {
    Estimates worse = shifted_truths(dataset, 0.03);
    worse.erase(worse.begin() + 2);
    return evaluate(dataset,
                    {{"good", judged(dataset, shifted_truths(dataset, 0.001), jobs), 0.5},
                     {"worse", judged(dataset, worse, jobs), -1}},
                    {0, 3, 200});
}

TEST_CASE("Estimates that are off by a known shift have that error, and perfect ones have none", "[pose_judge]") {
    BopFolder const folder;
    Dataset const dataset = bop::read_dataset(folder.path());
    Judgement const perfect = judged(dataset, shifted_truths(dataset, 0));
    REQUIRE(perfect.instances.size() == 8);
    CHECK(perfect.left_out == 0);
    for (InstanceErrors const& instance : perfect.instances) {
        CHECK(instance.add_m == 0);
        CHECK(instance.add_s_m == 0);
        CHECK(instance.mssd_m == Approx(0).margin(1e-12));
        CHECK(instance.mssd_hits == 10);
        CHECK(instance.mspd_px == Approx(0).margin(1e-9));
        CHECK(instance.mspd_hits == 10);
        CHECK(*instance.vsd_recall == Approx(1));
    }
    for (InstanceErrors const& instance : judged(dataset, shifted_truths(dataset, 0.03)).instances) {
        CHECK(instance.add_m == Approx(0.03));
        CHECK(instance.add_s_m < (instance.obj_id == BopFolder::box ? 0.0300001 : 0.02));  // corners are far apart
        // 30 mm are 0.243 diameters of the box and 0.318 of the cylinder; no symmetry of theirs helps against a shift.
        CHECK(instance.mssd_hits == (instance.obj_id == BopFolder::box ? 6 : 4));
        // 30 mm are 3 px at 0.6 m, which count tenfold in an image of 64 px; nearer points move more.
        CHECK(instance.mspd_px > 30);
        CHECK(instance.mspd_px < 34);
        CHECK(instance.mspd_hits == 4);
        CHECK(*instance.vsd_recall < 0.6);
    }
    std::filesystem::remove_all(folder / "test/000001/depth");
    Judgement const without_depth = judged(bop::read_dataset(folder.path()), shifted_truths(dataset, 0));
    CHECK_FALSE(without_depth.instances[0].vsd_recall);
    CHECK(without_depth.instances[7].vsd_recall);
    CHECK(without_depth.instances[0].mspd_hits == 10);
}

TEST_CASE("An instance without an estimate is infinitely far off", "[pose_judge]") {
    BopFolder const folder;
    Dataset const dataset = bop::read_dataset(folder.path());
    Judgement const none = judged(dataset, {});
    REQUIRE(none.instances.size() == 8);
    CHECK(std::isinf(none.instances[0].add_m));
    CHECK(none.instances[0].mssd_hits == 0);
    CHECK(none.instances[2].visible_share == 0.5);
    Evaluation const evaluation = evaluate(dataset, {{"none", none, -1}}, {0, 1, 10});
    for (ScoreRow const& row : evaluation.rows) {
        CHECK(row.estimated == 0);
        for (Interval const& score : row.scores)
            CHECK((std::isnan(score.value) || (score.value == 0 && score.low == 0 && score.high == 0)));
    }
}

TEST_CASE("Of several estimates the best by score counts, and of equal ones the first", "[pose_judge]") {
    BopFolder const folder;
    Dataset const dataset = bop::read_dataset(folder.path());
    Estimates estimates = shifted_truths(dataset, 0.02);
    Estimates more = shifted_truths(dataset, 0);
    for (PoseEstimate& estimate : more)
        estimate.score = 0.9;
    estimates.insert(estimates.end(), more.begin(), more.end());
    CHECK(judged(dataset, estimates).instances[0].add_m == Approx(0.02));
    CHECK(judged(dataset, estimates).left_out == 8);
    estimates.back().score = 1;
    CHECK(judged(dataset, estimates).instances[7].add_m == Approx(0.02));
    estimates.back().score = 1.1;
    CHECK(judged(dataset, estimates).instances[7].add_m == 0);
}

TEST_CASE("Two instances of an object are matched, and only as many as the targets say", "[pose_judge]") {
    BopFolder const folder;
    Dataset dataset = bop::read_dataset(folder.path());
    bop::DatasetImage& image = dataset.images[0];
    bop::GroundTruth second = image.objects[0];
    second.pose.translation.x() += 0.5;
    second.visible_share = 0.9;
    bop::GroundTruth hidden = second;
    hidden.pose.translation.x() += 0.5;
    hidden.visible_share = 0.1;
    image.objects.insert(image.objects.begin(), {hidden, second});
    dataset.targets = {{image.id, BopFolder::box, 2}};
    Estimates estimates(3);
    for (std::size_t i = 0; i < 3; ++i)
        estimates[i] = {image.id, BopFolder::box, 1.0 - 0.1 * static_cast<double>(i), second.pose, -1, i + 2, {}};
    estimates[0].pose.translation.x() += 0.01;
    estimates[1].pose.translation.x() -= 0.53;
    estimates[2].pose.translation.x() += 0.5;  // of the hidden one, and one too many
    Judgement const judgement = judged(dataset, estimates);
    REQUIRE(judgement.instances.size() == 2);
    CHECK(judgement.left_out == 1);
    CHECK(judgement.instances[0].visible_share == 1.0);
    CHECK(judgement.instances[0].add_m == Approx(0.03));
    CHECK(judgement.instances[1].visible_share == 0.9);
    CHECK(judgement.instances[1].add_m == Approx(0.01));
    REQUIRE(judgement.estimates.size() == 2);  // each from the nearest
    CHECK(judgement.estimates[0].line == 2);
    CHECK(judgement.estimates[0].add_m == Approx(0.01));
    CHECK(judgement.estimates[1].add_m == Approx(0.03));
    image.objects[0].visible_share.reset();  // nobody says that it is hidden
    CHECK(judged(dataset, estimates).instances[0].visible_share == std::nullopt);
    image.objects[0].visible_share = 0.1;
    dataset.targets[0].inst_count = 4;
    Judgement const fewer = judged(dataset, estimates);
    CHECK(fewer.instances.size() == 3);
    REQUIRE(fewer.warnings.size() == 1);
    CHECK_THAT(fewer.warnings[0],
               Catch::Contains("scene 1, image 0 has object 1 3 times, expected 4 as the targets say; "
                               "1 of 4 instances have no true pose"));
}

TEST_CASE("Estimates of something unknown, or of no target, are left out", "[pose_judge]") {
    BopFolder const folder;
    Dataset dataset = bop::read_dataset(folder.path());
    Estimates estimates = shifted_truths(dataset, 0);
    dataset.targets.pop_back();
    CHECK(judged(dataset, estimates).left_out == 1);
    CHECK(judged(dataset, estimates).warnings.empty());
    estimates[3].obj_id = 7;
    estimates[4].image.im_id = 4;
    estimates[3].problem = estimates[7].problem = "x";  // of what nobody asks for
    Judgement const judgement = judged(dataset, estimates);
    CHECK(judgement.left_out == 3);
    REQUIRE(judgement.warnings.size() == 1);
    CHECK(judgement.warnings[0] == "r.csv:5: scene_id, im_id, obj_id = 1, 3, 7, which " + folder.path().string() +
                                       " does not have; 2 of 8 rows are left out for that");
    estimates[0].problem = "r.csv:2: no rotation";
    CHECK(complaint(dataset, estimates) == "r.csv:2: no rotation");
    CHECK_THAT(complaint(dataset, {estimates[3]}),
               Catch::Contains("no row of the 1 is of a target of ") && Catch::Contains("such as 1, 0, 1"));
    dataset.images[0].objects[0].problem = "scene_gt.json: no pose";
    CHECK(complaint(dataset, {}) == "scene_gt.json: no pose");
    dataset.targets[0].obj_id = 9;
    CHECK_THAT(complaint(dataset, {}), Catch::Contains("test_targets_bop19.json: obj_id = 9, of which there is no ") &&
                                           Catch::EndsWith("obj_000009.ply, expected one of the dataset's: 1, 5"));
}

TEST_CASE("Estimates in metres are warned of", "[pose_judge]") {
    BopFolder const folder;
    Dataset const dataset = bop::read_dataset(folder.path());
    Estimates estimates = shifted_truths(dataset, 0);
    for (PoseEstimate& estimate : estimates)
        estimate.pose.translation /= 1000;
    REQUIRE(judged(dataset, estimates).warnings.size() == 1);
    CHECK_THAT(judged(dataset, estimates).warnings[0],
               Catch::Contains("r.csv: column t puts half of the objects within 0.6") &&
                   Catch::Contains("t is in millimetres"));
}

TEST_CASE("Rows are objects, all and their mean, and methods are compared on the same draws", "[pose_judge]") {
    BopFolder const folder;
    Dataset const dataset = bop::read_dataset(folder.path());
    Evaluation const evaluation = two_methods(dataset);
    CHECK(evaluation.images == 4);
    CHECK(evaluation.rows.size() == 8);
    ScoreRow const& box = row_of(evaluation, "worse", "obj_000001");
    CHECK(box.instances == 4);
    CHECK(box.estimated == 3);
    double const of_box = 100 * area_under_accuracy({{0.03, 3}}, 4);
    CHECK(box.scores[1].value == Approx(of_box));
    CHECK(box.scores[1].low < of_box);
    CHECK(row_of(evaluation, "worse", "all").scores[5].value == Approx(87.5));
    double const of_cylinder = row_of(evaluation, "worse", "obj_000005").scores[1].value;
    CHECK(of_cylinder > of_box);
    ScoreRow const& mean = row_of(evaluation, "worse", "mean");
    CHECK(std::isnan(mean.scores[1].value));  // of the toolbox's areas there is none
    CHECK(mean.scores[8].value ==
          Approx((box.scores[8].value + row_of(evaluation, "worse", "obj_000005").scores[8].value) / 2));

    Interval const& difference = row_of(evaluation, "worse", "all").more_than_first[4];  // ADD below 2 cm
    CHECK(difference.value == Approx(-100));
    CHECK(difference.low == Approx(-100));  // in every draw: no width, though the draws differ
    CHECK(difference.high == Approx(-100));
    for (Interval const& none : row_of(evaluation, "good", "all").more_than_first)
        CHECK((none.low == 0 && none.high == 0));
    for (ScoreRow const& row : evaluation.rows) {
        for (Interval const& score : row.scores)
            CHECK((std::isnan(score.value) || (score.low <= score.value && score.value <= score.high)));
    }
}

TEST_CASE("What is not known of one object is not known of the objects' mean", "[pose_judge]") {
    BopFolder const folder;
    Dataset const dataset = bop::read_dataset(folder.path());
    Judgement judgement = judged(dataset, shifted_truths(dataset, 0));
    for (InstanceErrors& instance : judgement.instances)
        if (instance.obj_id == BopFolder::box)
            instance.vsd_recall.reset();
    Evaluation const evaluation = evaluate(dataset, {{"a", judgement, -1}}, {0, 3, 20});
    auto const vsd_of = [&](char const* object) {
        for (ScoreRow const& row : evaluation.rows)
            if (row.object == object)
                for (std::size_t score = 0; score < score_count; ++score)
                    if (std::string(score_facts[score].name) == "vsd_recall")
                        return row.scores[score];
        throw std::logic_error("no VSD");
    };
    CHECK(vsd_of("obj_000005").value == Approx(100));
    CHECK(std::isnan(vsd_of("obj_000001").value));
    CHECK(std::isnan(vsd_of("mean").value));
    CHECK(std::isnan(vsd_of("mean").low));
}

TEST_CASE("An object a hand's breadth away is drawn, and has a VSD", "[pose_judge]") {
    Camera const camera = BopFolder::camera();
    Pose near;
    near.translation = {0, 0, 0.12};  // its near side is at 7 cm
    DistanceImage const drawn = drawn_distances(BopFolder::mesh_of(BopFolder::box), near, camera);
    CHECK(drawn.at(23, 31) == Approx(0.07).epsilon(0.01));
}

TEST_CASE("What two methods both miss does not part them in any draw", "[pose_judge]") {
    BopFolder const folder;
    Dataset const dataset = bop::read_dataset(folder.path());
    Estimates near = shifted_truths(dataset, 0.001), far = shifted_truths(dataset, 0.03);
    for (Estimates* const estimates : {&near, &far})
        estimates->erase(estimates->begin(), estimates->begin() + 2);  // all of the first image
    Evaluation const evaluation =
        evaluate(dataset, {{"near", judged(dataset, near), -1}, {"far", judged(dataset, far), -1}}, {0, 3, 200});
    ScoreRow const& row = row_of(evaluation, "far", "all");
    CHECK(row.scores[5].high - row.scores[5].low > 20);  // ADD below 4 cm
    CHECK(row.more_than_first[5].low == 0);
    CHECK(row.more_than_first[5].high == 0);
}

TEST_CASE("Instances that are hidden too much can be left out", "[pose_judge]") {
    BopFolder const folder;
    Dataset const dataset = bop::read_dataset(folder.path());
    Judgement const judgement = judged(dataset, shifted_truths(dataset, 0.01));
    auto const visible_from = [&](double share) { return evaluate(dataset, {{"m", judgement, -1}}, {share, 1, 10}); };
    CHECK(row_of(visible_from(0.5), "m", "obj_000001").instances == 4);
    CHECK(row_of(visible_from(0.51), "m", "obj_000001").instances == 2);  // hidden by half in two images
    CHECK(row_of(visible_from(0.51), "m", "all").instances == 6);
    Judgement of_unknown = judgement;
    for (InstanceErrors& instance : of_unknown.instances)
        instance.visible_share.reset();
    CHECK(evaluate(dataset, {{"m", of_unknown, -1}}, {1, 1, 10}).rows.back().instances == 8);
}

TEST_CASE("The same seed gives the same bytes, whatever the threads", "[pose_judge]") {
    BopFolder const folder;
    Dataset const dataset = bop::read_dataset(folder.path());
    Evaluation const one = two_methods(dataset, 1), four = two_methods(dataset, 4);
    CHECK(evaluation_json(one).dump() == evaluation_json(four).dump());
    CHECK(scores_csv(one) == scores_csv(four));
    CHECK(errors_csv(one) == errors_csv(four));
    CHECK(evaluation_markdown(one) == evaluation_markdown(four));
}

TEST_CASE("Tables hold what has been found", "[pose_judge]") {
    BopFolder const folder;
    Evaluation const evaluation = two_methods(bop::read_dataset(folder.path()));
    std::string const text = evaluation_markdown(evaluation);
    CHECK_THAT(text, Catch::Contains("8 instances in 4 images") && Catch::Contains("200 bootstraps") &&
                         Catch::Contains("| obj_000001 | worse | 4 | 3 |") &&
                         Catch::Contains("Points more than good") && Catch::Contains("| all | worse | -") &&
                         Catch::Contains("| mean | worse | - | - |") && Catch::Contains("good: 0.500 s per image"));
    CHECK_THAT(errors_csv(evaluation), Catch::Contains("good,1,3,1,0.5000,0.001000,") &&
                                           Catch::Contains("\nworse,1,3,1,0.5000,,,,0,,0,0.00\n"));
    CHECK_THAT(curves_csv(evaluation), Catch::Contains("worse,all,add,0.030000,87.5000\n"));
    CHECK_THAT(evaluation_html(evaluation), Catch::Contains("\"format\":\"faster-evaluation\""));
    Json const json = evaluation_json(evaluation);
    CHECK(json["rows"].size() == 8);
    CHECK(json["methods"][1]["mean_time_s"].is_null());
}

TEST_CASE("A curve rises where its errors are, in the colour of its method", "[pose_judge]") {
    BopFolder const folder;
    Evaluation const evaluation = two_methods(bop::read_dataset(folder.path()));
    Image<Colour> const plot = accuracy_plot(evaluation, CurveOf::add);
    Colour const good{0, 114, 178}, worse{213, 94, 0};
    // A panel of 330 px: its axes begin 52 px from its left and 34 from its top, and are 260 x 200 px.
    CHECK(plot.width() == 3 * 330);
    auto const pixel = [&](double centimetres, double percent) {
        return plot.at(34 + static_cast<int>(std::lround(2 * (100 - percent))),
                       52 + static_cast<int>(std::lround(26 * centimetres)));
    };
    CHECK(pixel(0.1, 50) == good);
    CHECK(pixel(3, 40) == worse);
    CHECK(pixel(6, 75) == worse);  // the box: one of four is missed
    CHECK(pixel(6, 100) == good);
    CHECK(pixel(7, 90) == Colour{255, 255, 255});
}

}  // namespace pose_judge_test
