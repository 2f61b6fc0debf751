#include "poses/quality/contour_quality.hpp"

#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "faster/workload/models/builtin_models.hpp"
#include "poses/quality/pose_survey.hpp"

namespace faster::quality::contour_quality_test {

using Rows = std::vector<std::string>;

/// 1 where a letter of `lit` stands.
Image<std::uint8_t> picture(Rows const& rows, std::string const& lit) {
    Image<std::uint8_t> image(static_cast<int>(rows.size()), static_cast<int>(rows.front().size()));
    for (int row = 0; row < image.height(); ++row)
        for (int col = 0; col < image.width(); ++col)
            image.at(row, col) =
                lit.find(rows[static_cast<std::size_t>(row)][static_cast<std::size_t>(col)]) != std::string::npos ? 1
                                                                                                                  : 0;
    return image;
}

/// `o` object, `#` edge beside it, `X` edge on the object.
ContourQuality judge(Rows const& rows, ContourSide side = ContourSide::outside) {
    return contour_quality(picture(rows, "#X"), picture(rows, "oX"), side);
}

TEST_CASE("The contour of a silhouette lies around it or within it", "[quality]") {
    Rows const shape{"......",  //
                     "..oo..",  //
                     "..ooo.",  //
                     "..ooo."};
    CHECK(contour_of(picture(shape, "o"), ContourSide::outside) == picture({"..##..",  //
                                                                            ".#..#.",  //
                                                                            ".#...#",  //
                                                                            ".#...#"},
                                                                           "#"));
    // Neither at the window's lower border, where the object may go on.
    CHECK(contour_of(picture(shape, "o"), ContourSide::inside) == picture({"......",  //
                                                                           "..##..",  //
                                                                           "..#.#.",  //
                                                                           "..#.#."},
                                                                          "#"));
}

TEST_CASE("A perfect contour is precise, complete, one pixel thick, closed and thin", "[quality]") {
    ContourQuality const quality = judge({"........",  //
                                          "...##...",  //
                                          "..#oo#..",  //
                                          "..#oo#..",  //
                                          "...##...",  //
                                          "........"});
    CHECK(quality.precision == 1);
    CHECK(quality.recall == 1);
    CHECK(quality.f1() == 1);
    CHECK(quality.thickness == 1);
    CHECK(quality.is_closed);
    CHECK(quality.is_thin);
}

TEST_CASE("One gap opens a contour", "[quality]") {
    ContourQuality const quality = judge({"........",  //
                                          "...##...",  //
                                          "..#oo#..",  //
                                          "...oo#..",  //
                                          "...##...",  //
                                          "........"});
    CHECK(quality.precision == 1);
    CHECK(quality.recall == Approx(7.0 / 8));
    CHECK_FALSE(quality.is_closed);
    CHECK(quality.is_thin);
}

TEST_CASE("Edges beside the contour cost precision and thickness, those further off precision only", "[quality]") {
    ContourQuality const quality = judge({"#..........",  //
                                          "...####....",  //
                                          "...##oo#...",  //
                                          "....#oo#...",  //
                                          ".....##....",  //
                                          "..........."});
    // Contour: 8 pixels, all found. 4 more are edges, one of them in the far corner; two of the others make a block of
    // 2 x 2 with (1,3) and (1,4). Shortest runs: 2 for (2,3) and (2,4), which have a neighbour in all four directions;
    // 1 for the rest.
    CHECK(quality.precision == Approx(8.0 / 12));
    CHECK(quality.recall == 1);
    CHECK(quality.thickness == Approx(13.0 / 11));
    CHECK(quality.is_closed);
    CHECK_FALSE(quality.is_thin);
}

TEST_CASE("An edge on the object is no hole, and part of the contour within", "[quality]") {
    Rows const border{"......",  //
                      ".XXXX.",  //
                      ".XooX.",  //
                      ".XXXX.",  //
                      "......"};
    ContourQuality const inside = judge(border, ContourSide::inside);
    CHECK(inside.precision == 1);
    CHECK(inside.recall == 1);
    CHECK(inside.is_closed);
    CHECK(judge(border, ContourSide::outside).precision == 0);
}

TEST_CASE("Without edges, without an object", "[quality]") {
    ContourQuality const blind = judge({"....",  //
                                        ".oo.",  //
                                        "...."});
    CHECK(blind.precision == 0);
    CHECK(blind.recall == 0);
    CHECK(blind.f1() == 0);
    CHECK_FALSE(blind.is_closed);
    ContourQuality const nothing = judge({"....", "...."});
    CHECK(nothing.recall == 1);
    CHECK(nothing.is_closed);
}

TEST_CASE("The designs do on built-in models what the thesis says of them", "[quality][edge_map]") {
    std::string const object = GENERATE("cracker_box", "tomato_soup_can", "banana", "mug");
    CAPTURE(object);
    Mesh const mesh = models::make(object);
    constexpr std::size_t poses = 12;
    auto const rows = survey(object, mesh, random_poses(mesh, poses, 3),
                             {EdgeMapAlgorithm::threshold, EdgeMapAlgorithm::transition, EdgeMapAlgorithm::bounded,
                              EdgeMapAlgorithm::dual_map, EdgeMapAlgorithm::inner_border});
    auto const mean = [](double sum) { return sum / static_cast<double>(poses); };
    // 5.1: thick, with many false positives.
    CHECK(mean(rows[0].precision) < 0.6);
    CHECK(mean(rows[0].thickness) > 1.05);
    CHECK(rows[0].thin <= poses / 4);
    // 5.2: no false positives, but gaps, more in some poses than in others.
    CHECK(mean(rows[1].precision) > 0.999);
    CHECK(mean(rows[1].recall) < 0.85);
    CHECK(rows[1].closed == 0);
    CHECK(rows[1].best.quality.recall > rows[1].worst.quality.recall + 0.05);
    // 5.3, 5.4, 7.2: complete and thin.
    for (std::size_t i = 2; i < rows.size(); ++i) {
        CAPTURE(i);
        CHECK(mean(rows[i].precision) > 0.999);
        CHECK(mean(rows[i].recall) > 0.999);
        CHECK(rows[i].thin == poses);
        CHECK(rows[i].closed >= poses - 1);
    }
}

TEST_CASE("Tables of a survey hold means and shares", "[quality]") {
    PoseSurvey row;
    row.algorithm = EdgeMapAlgorithm::bounded;
    row.object = "mug";
    row.add({1, 0.5, 1, true, true});
    row.add({0.5, 0.5, 2, true, false});
    PoseSurvey other = row;
    other.object = "banana";
    other.add({0, 0, 0, false, true});
    CHECK(survey_csv({row, other}) ==
          "algorithm,object,poses,precision,recall,thickness,closed,thin,closed_and_thin\n"
          "bounded,mug,2,0.7500,0.5000,1.5000,1.0000,0.5000,0.5000\n"
          "bounded,banana,3,0.5000,0.3333,1.0000,0.6667,0.6667,0.3333\n");
    CHECK(survey_markdown({row, other}) ==
          "| algorithm | poses | precision | recall | thickness [px] | closed | thin | closed and thin |\n"
          "| --- | --- | --- | --- | --- | --- | --- | --- |\n"
          "| bounded | 5 | 60.0 % | 40.0 % | 1.20 | 80.0 % | 60.0 % | 40.0 % |\n");
}

TEST_CASE("Equal seeds give equal poses", "[quality]") {
    Mesh const mesh = models::make("mug");
    auto const a = random_poses(mesh, 3, 5);
    auto const b = random_poses(mesh, 3, 5);
    CHECK(a[2].rotation == b[2].rotation);
    CHECK(a[2].translation == b[2].translation);
    CHECK(a[2].rotation != random_poses(mesh, 3, 6)[2].rotation);
}

}  // namespace faster::quality::contour_quality_test
