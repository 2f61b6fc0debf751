// How many samples of a workload the scorers without time score per second of one host core's time, the shortest of
// ROUNDS goes in turns.
//
//   faster_scorer_bench [CONFIG] [ROUNDS]
#include <cstdlib>
#include <ctime>
#include <fmt/format.h>
#include <limits>
#include <systemc>

#include "dataflow/run/config/load_config.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/reference/scorer.hpp"
#include "faster/workload/build_stimulus.hpp"
#include "modules/core/faster_design.hpp"
#include "modules/core/untimed_scorer.hpp"
#include "poses/grip/score_poses.hpp"

namespace faster {
namespace {

// The configuration's keys come with the modules, and those with libsystemc and its main().
[[maybe_unused]] bool const banner_is_off = setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1) == 0;

/// Least processor time of several goes [s], as others on the machine only ever add to it.
class Shortest {
  public:
    template <class Work> void time(Work work) {
        std::clock_t const start = std::clock();
        work();
        seconds_ = std::min(seconds_, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    double per_second(std::size_t samples) const { return static_cast<double>(samples) / seconds_; }

  private:
    double seconds_ = std::numeric_limits<double>::infinity();
};

void compare(Stimulus const& stimulus, AcceleratorConfig const& config, int rounds) {
    std::size_t const samples = stimulus.samples.size();
    reference::Scorer reference(stimulus, config.edge_map);
    datapath::UntimedScorer untimed(stimulus, config.edge_map);
    grip::PoseScorer const grip(stimulus, {});
    Shortest of_reference, of_untimed, of_grip;
    std::uint64_t difference = 0, points = 0;
    for (int round = 0; round < rounds; ++round) {
        std::uint64_t a = 0, b = 0;
        of_reference.time([&] {
            for (std::size_t i = 0; i < samples; ++i)
                a += reference.run(i).inlier;
        });
        of_untimed.time([&] {
            for (std::size_t i = 0; i < samples; ++i)
                b += untimed.score(stimulus.posed.poses[i], stimulus.samples[i]).inlier;
        });
        of_grip.time([&] {
            for (std::size_t i = 0; i < samples; ++i)
                points += grip.score(stimulus.posed.poses[i]).raw.points;
        });
        difference += a > b ? a - b : b - a;
    }
    double const base = of_reference.per_second(samples);
    fmt::print("{:<10} {:>10} {:>8}\n", "scorer", "samples/s", "ratio");
    for (auto const& [name, time] : {std::pair{"reference", of_reference}, {"untimed", of_untimed}, {"grip", of_grip}})
        fmt::print("{:<10} {:>10.0f} {:>8.2f}\n", name, time.per_second(samples), time.per_second(samples) / base);
    fmt::print("inliers that differ: {}; points per sample by grip: {}\n", difference,
               points / (samples * static_cast<std::size_t>(rounds)));
}

}  // namespace
}  // namespace faster

int sc_main(int argc, char** argv) {
    using namespace faster;
    LoadedConfig const loaded = load_config(argc > 1 ? argv[1] : "configs/faster_zcu102.yaml");
    AcceleratorConfig const& config = accelerator_of(loaded.config);
    compare(workload::build_stimulus(workload_of(loaded.config), config.window, config.fraction_bits), config,
            argc > 2 ? std::stoi(argv[2]) : 5);
    return 0;
}
