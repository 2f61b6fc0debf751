#include "poses/estimation/counter_scorer.hpp"

#include <algorithm>
#include <functional>

#include "dataflow/base/on_threads.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/untimed_scorer.hpp"

namespace faster::estimation {

/// One thread's buffers. What the datapath's scorer does not know is left to the reference.
class CounterScorer::Worker {
  public:
    Worker(Stimulus const& stimulus, AcceleratorConfig const& config) : stimulus_(stimulus), config_(config) {
        if (config.flow == Flow::faster && datapath::UntimedScorer::scores(config.edge_map.algorithm))
            scorer_ = std::make_unique<datapath::UntimedScorer>(stimulus, config.edge_map, config.inlier_unit.hidden);
    }

    void score(std::size_t first, std::size_t end, std::vector<SampleCounters>& counters) {
        if (scorer_ == nullptr)
            return score_by_reference(first, end, counters);
        for (std::size_t i = first; i < end; ++i)
            counters[i] = scorer_->score(stimulus_.posed.poses[i], stimulus_.samples[i]);
    }

  private:
    void score_by_reference(std::size_t first, std::size_t end, std::vector<SampleCounters>& counters) const {
        reference::Scorer scorer = reference_scorer(stimulus_, config_);
        for (std::size_t i = first; i < end; ++i)
            counters[i] = scorer.run(i);
    }

    Stimulus const& stimulus_;
    AcceleratorConfig config_;
    std::unique_ptr<datapath::UntimedScorer> scorer_;
};

reference::Scorer reference_scorer(Stimulus const& stimulus, AcceleratorConfig const& config) {
    reference::Scorer scorer = config.flow == Flow::fpga_grip ? reference::Scorer(stimulus, config.edge_extraction)
                                                              : reference::Scorer(stimulus, config.edge_map);
    if (counts_hidden(config.inlier_unit))
        scorer.count_hidden();
    return scorer;
}

CounterScorer::CounterScorer(Stimulus const& stimulus, AcceleratorConfig const& config, std::size_t jobs)
    : stimulus_(stimulus) {
    for (std::size_t i = 0; i < jobs; ++i)
        workers_.push_back(std::make_unique<Worker>(stimulus, config));
}

CounterScorer::~CounterScorer() = default;

std::vector<SampleCounters> CounterScorer::score() {
    std::size_t const samples = stimulus_.samples.size();
    std::vector<SampleCounters> counters(samples);
    on_threads(workers_.size(), workers_.size(), [&](std::size_t i) {
        workers_[i]->score(samples * i / workers_.size(), samples * (i + 1) / workers_.size(), counters);
    });
    return counters;
}

}  // namespace faster::estimation
