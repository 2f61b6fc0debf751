#include <array>
#include <catch2/catch.hpp>
#include <cstdint>
#include <random>

#include "faster/dataflow_names.hpp"
#include "support/engine_agreement.hpp"
#include "support/parts.hpp"
#include "support/random_stimulus.hpp"

namespace faster::testing::engine_vs_twin_test {

struct TrialOptions {
    RandomConfigOptions config;
    RandomStimulusOptions stimulus;
    bool has_extreme_depths = false;  ///< of FIFOs: a few tokens, or a good part of a sample
};

TrialOptions small_windows() {
    TrialOptions options;
    options.config.cores = {1, 4};
    options.stimulus.width = {24, 64};
    options.stimulus.height = {24, 64};
    options.stimulus.window = {4, 24};
    options.stimulus.samples = {0, 6};
    return options;
}

bool check_seed(std::uint64_t seed, TrialOptions options) {
    CAPTURE(seed);
    options.stimulus.random_fraction_bits = seed % 3 == 0;
    Stimulus const stimulus = random_stimulus(seed, options.stimulus);
    AcceleratorConfig config = random_config(seed, options.config);
    if (options.has_extreme_depths) {
        std::mt19937_64 random(seed);
        for (FifoId const id : fifo_ids)
            config.fifo(id).depth = std::array<std::uint64_t, 6>{1, 2, 5, 70, 300, 1500}[random() % 6];
    }
    adopt(stimulus, config);
    return check_agreement(config, stimulus);
}

/// Runs the seeds first, first + 1, ...; returns how many deadlocked.
int check_seeds(std::uint64_t first, std::uint64_t count, TrialOptions const& options) {
    int deadlocks = 0;
    for (std::uint64_t seed = first; seed < first + count; ++seed)
        deadlocks += check_seed(seed, options) ? 0 : 1;
    return deadlocks;
}

TEST_CASE("Engines and twin agree: deadlock-free, seeds 1000 to 1119", "[engine_vs_twin]") {
    CHECK(check_seeds(1000, 120, small_windows()) == 0);
}

TEST_CASE("Engines and twin agree: any configuration, seeds 2000 to 2119", "[engine_vs_twin]") {
    TrialOptions options = small_windows();
    options.config.is_deadlock_free = false;
    int const deadlocks = check_seeds(2000, 120, options);
    CHECK(deadlocks > 10);  // or the mixture tests nothing
    CHECK(deadlocks < 110);
}

TEST_CASE("Engines and twin agree: shallow FIFOs, many deadlocks", "[engine_vs_twin]") {
    TrialOptions options = small_windows();
    options.config.is_deadlock_free = false;
    options.config.fifo_depth = {1, 3};
    CHECK(check_seeds(3000, 60, options) > 10);
}

TEST_CASE("Engines and twin agree: long intervals and few ports", "[engine_vs_twin]") {
    TrialOptions options = small_windows();
    options.config.max_target_ii = 12;
    options.config.max_recurrence_ii = 12;
    options.config.max_ports = 1;
    options.stimulus.window = {1, 10};
    options.stimulus.triangles = {0, 6};
    check_seeds(4000, 40, options);
}

TEST_CASE("Engines and twin agree: many cores, deep FIFOs, larger windows", "[engine_vs_twin]") {
    TrialOptions options;
    options.config.fifo_depth = {1, 2000};
    check_seeds(5000, 20, options);
}

TEST_CASE("Engines and twin agree: shallow FIFOs beside deep ones", "[engine_vs_twin]") {
    TrialOptions options;
    options.stimulus.window = {16, 40};
    options.stimulus.samples = {1, 4};
    options.config.cores = {1, 3};
    options.config.is_deadlock_free = false;
    options.has_extreme_depths = true;
    CHECK(check_seeds(5100, 60, options) < 45);
    options.config.any_scan = true;
    options.config.any_region = true;
    options.config.any_clearing = true;
    options.config.any_buffers = true;
    options.config.any_partition = true;
    options.config.max_lanes = 5;
    CHECK(check_seeds(60140, 40, options) < 35);  // 60156: a map is still being cleared when the run ends
}

TEST_CASE("Engines and twin agree: every edge map algorithm", "[engine_vs_twin][edge_map]") {
    std::uint64_t seed = 7000;
    for (EdgeMapAlgorithm const algorithm :
         {EdgeMapAlgorithm::threshold, EdgeMapAlgorithm::transition, EdgeMapAlgorithm::bounded,
          EdgeMapAlgorithm::dual_map_4_1_2, EdgeMapAlgorithm::inner_border}) {
        CAPTURE(static_cast<int>(algorithm));
        TrialOptions options = small_windows();
        options.config.algorithm = algorithm;
        options.config.is_deadlock_free = seed % 200 == 0;
        check_seeds(seed, 15, options);
        seed += 100;
    }
}

TEST_CASE("Engines and twin agree: any way to clear the maps and to read neighbours", "[engine_vs_twin][edge_map]") {
    std::uint64_t seed = 7700;
    for (EdgeMapAlgorithm const algorithm :
         {EdgeMapAlgorithm::dual_map, EdgeMapAlgorithm::bounded, EdgeMapAlgorithm::inner_border}) {
        CAPTURE(static_cast<int>(algorithm));
        TrialOptions options = small_windows();
        options.config.algorithm = algorithm;
        options.config.any_clearing = true;
        check_seeds(seed, 15, options);
        seed += 100;
    }
}

TEST_CASE("Engines and twin agree: any banks, clearings and lanes", "[engine_vs_twin][partition][lanes]") {
    std::uint64_t seed = 8000;
    for (EdgeMapAlgorithm const algorithm : {EdgeMapAlgorithm::dual_map, EdgeMapAlgorithm::bounded,
                                             EdgeMapAlgorithm::dual_map_4_1_2, EdgeMapAlgorithm::inner_border}) {
        CAPTURE(static_cast<int>(algorithm));
        TrialOptions options = small_windows();
        options.config.algorithm = algorithm;
        options.config.any_clearing = true;
        options.config.any_partition = true;
        options.config.max_lanes = seed % 200 == 0 ? 3 : 9;
        options.config.is_deadlock_free = seed != 8200;
        options.stimulus.window = {9, 24};
        options.config.max_ports = 2;
        check_seeds(seed, 10, options);
        seed += 100;
    }
}

TEST_CASE("Engines and twin agree: any way to prepare and to scan triangles, seeds 8000 to 8059", "[engine_vs_twin]") {
    TrialOptions options = small_windows();
    options.config.any_scan = true;
    CHECK(check_seeds(8000, 60, options) == 0);
}

TEST_CASE("Engines and twin agree: any scan, any FIFOs, many triangles", "[engine_vs_twin]") {
    TrialOptions options = small_windows();
    options.config.any_scan = true;
    options.config.is_deadlock_free = false;
    options.config.fifo_depth = {1, 8};
    options.stimulus.triangles = {0, 40};
    int const deadlocks = check_seeds(8200, 80, options);
    CHECK(deadlocks > 10);
    CHECK(deadlocks < 75);
}

TEST_CASE("Engines and twin agree: any scan with long intervals and few ports", "[engine_vs_twin]") {
    TrialOptions options = small_windows();
    options.config.any_scan = true;
    options.config.max_target_ii = 12;
    options.config.max_recurrence_ii = 12;
    options.config.max_ports = 1;
    options.stimulus.window = {1, 10};
    options.stimulus.triangles = {0, 6};
    check_seeds(8300, 40, options);
}

TEST_CASE("Engines and twin agree: any scan with every edge map algorithm", "[engine_vs_twin][edge_map]") {
    std::uint64_t seed = 8400;
    for (EdgeMapAlgorithm const algorithm :
         {EdgeMapAlgorithm::threshold, EdgeMapAlgorithm::transition, EdgeMapAlgorithm::bounded,
          EdgeMapAlgorithm::dual_map_4_1_2, EdgeMapAlgorithm::inner_border}) {
        CAPTURE(static_cast<int>(algorithm));
        TrialOptions options = small_windows();
        options.config.any_scan = true;
        options.config.any_clearing = true;
        options.config.algorithm = algorithm;
        check_seeds(seed, 10, options);
        seed += 100;
    }
}

TEST_CASE("Engines and twin agree: any scan, deep FIFOs, larger windows", "[engine_vs_twin]") {
    TrialOptions options;
    options.config.any_scan = true;
    options.config.fifo_depth = {1, 2000};
    check_seeds(8900, 20, options);
}

TEST_CASE("Engines and twin agree: any lanes of the scan, banks, clearings and scans", "[engine_vs_twin][lanes]") {
    for (std::uint64_t const seed : {9000U, 9100U, 9200U}) {
        TrialOptions options = small_windows();
        options.config.algorithm = EdgeMapAlgorithm::inner_border;
        options.config.any_scan = true;
        options.config.any_clearing = true;
        options.config.any_partition = true;
        options.config.max_scan_lanes = seed == 9200 ? 32 : 8;
        options.config.max_lanes = 8;
        options.config.is_deadlock_free = seed != 9100;
        options.stimulus.window = {9, 24};
        options.config.max_ports = 2;
        check_seeds(seed, 20, options);
    }
}

TEST_CASE("Engines and twin agree: any swept region with every edge map algorithm", "[engine_vs_twin][sweep_region]") {
    std::uint64_t seed = 9000;
    for (EdgeMapAlgorithm const algorithm :
         {EdgeMapAlgorithm::threshold, EdgeMapAlgorithm::transition, EdgeMapAlgorithm::bounded,
          EdgeMapAlgorithm::dual_map, EdgeMapAlgorithm::dual_map_4_1_2, EdgeMapAlgorithm::inner_border}) {
        CAPTURE(static_cast<int>(algorithm));
        TrialOptions options = small_windows();
        options.config.algorithm = algorithm;
        options.config.any_region = true;
        options.config.any_scan = true;
        options.config.any_clearing = true;
        options.config.any_partition = true;
        options.config.max_lanes = seed % 200 == 0 ? 3 : 9;
        options.config.is_deadlock_free = seed % 300 != 0;
        options.stimulus.window = {9, 24};
        check_seeds(seed, 12, options);
        seed += 100;
    }
}

TEST_CASE("Engines and twin agree: any swept region, tiny windows", "[engine_vs_twin][sweep_region]") {
    TrialOptions options = small_windows();
    options.config.any_region = true;
    options.config.fifo_depth = {1, 4};
    options.stimulus.window = {1, 8};
    options.stimulus.triangles = {0, 5};
    CHECK(check_seeds(9600, 60, options) == 0);
}

TEST_CASE("Engines and twin agree: every kind of triangle under the default machine", "[engine_vs_twin]") {
    for (int kind = 0; kind < triangle_kind_count; ++kind) {
        CAPTURE(kind);
        RandomStimulusOptions options;
        options.kind = static_cast<TriangleKind>(kind);
        options.samples = {3, 3};
        options.triangles = {1, 12};
        Stimulus const stimulus = random_stimulus(6000 + static_cast<std::uint64_t>(kind), options);
        AcceleratorConfig config;
        config.cores = 2;
        REQUIRE(check_agreement(config, stimulus));
    }
}

}  // namespace faster::testing::engine_vs_twin_test
