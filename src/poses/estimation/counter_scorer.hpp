#pragma once
#include <memory>
#include <vector>

#include "faster/config/accelerator_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/reference/scorer.hpp"

namespace faster::estimation {

/// The untimed reference of the configured accelerator. `stimulus` is held by reference.
reference::Scorer reference_scorer(Stimulus const& stimulus, AcceleratorConfig const& config);

/// The counters of poses as the configured accelerator finds them, bit by bit, without its time.
class CounterScorer {
  public:
    /// `jobs`: threads, at least one. `stimulus`: a posed one, held by reference; its samples may change.
    CounterScorer(Stimulus const& stimulus, AcceleratorConfig const& config, std::size_t jobs);
    ~CounterScorer();
    CounterScorer(CounterScorer const&) = delete;
    CounterScorer& operator=(CounterScorer const&) = delete;

    /// Of the stimulus's samples as they are now.
    std::vector<SampleCounters> score();

  private:
    class Worker;

    Stimulus const& stimulus_;
    std::vector<std::unique_ptr<Worker>> workers_;
};

}  // namespace faster::estimation
