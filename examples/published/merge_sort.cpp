// Four processes in a row with ping-pong buffers between them, each of which sorts longer runs: the merge sort that is
// design 17 of the public RealProbe. Of its processes the latencies are known, and no more: each is one iteration of
// that many states here.
#include <algorithm>
#include <numeric>

#include "dataflow/commands/simple_tool.hpp"

using namespace dataflow;

namespace {

using Words = std::vector<std::int32_t>;
constexpr unsigned stages = 4;
constexpr std::uint64_t words = 16;
constexpr Cycles latencies[stages] = {233, 33, 33, 105};

std::string stage_name(unsigned stage) { return "merge_" + std::to_string(stage); }
std::string buffer_name(unsigned stage) { return "runs_" + std::to_string(stage); }

class Merger : public SimpleModule {
  public:
    static ModuleDescription describe(unsigned stage) {
        ModuleDescription module(stage_name(stage));
        if (stage > 0)
            module.reads_from(buffer_name(stage - 1));
        if (stage + 1 < stages)
            module.writes_to(buffer_name(stage)).carries("sorted runs").of_bits(32).hands_over(words);
        module.loop("merge").does("merges runs of its buffer").of_states(latencies[stage] - 1);
        return module;
    }
    Merger(char const* name, SimpleCore& core, unsigned stage) : SimpleModule(name, core), core_(core), stage_(stage) {}

  private:
    void work(std::size_t /*sample*/) override {
        Words runs = stage_ > 0 ? core_.ping_pong<std::int32_t>(buffer_name(stage_ - 1)).take() : unsorted();
        clock_.repeat("merge", 1, [&](std::uint64_t) { merge(runs); });
        if (stage_ + 1 < stages)
            core_.ping_pong<std::int32_t>(buffer_name(stage_)).put(runs);
        else
            add_result({std::is_sorted(runs.begin(), runs.end()) ? 1U : 0U});
    }
    static Words unsorted() {
        Words all(words);
        std::iota(all.rbegin(), all.rend(), 0);
        return all;
    }
    /// Pairs of runs of 1, 2, 4 or 8 words.
    void merge(Words& runs) const {
        std::ptrdiff_t const length = std::ptrdiff_t{1} << stage_;
        for (auto run = runs.begin(); run != runs.end(); run += 2 * length)
            std::inplace_merge(run, run + length, run + 2 * length);
    }

    SimpleCore& core_;
    unsigned stage_;
};

class MergeSort : public SimpleCore {
  public:
    static CoreDescription describe(Numbers const& /*numbers*/) {
        std::vector<ModuleDescription> modules;
        for (unsigned stage = 0; stage < stages; ++stage)
            modules.push_back(Merger::describe(stage));
        return core_of(modules);
    }
    explicit MergeSort(SimpleCoreParts const& parts) : SimpleCore(parts) {
        for (unsigned stage = 0; stage + 1 < stages; ++stage)
            buffers_.push_back(std::make_unique<PingPong<std::int32_t>>(buffer_name(stage).c_str(),
                                                                        ping_pong_timing(buffer_name(stage))));
        for (unsigned stage = 0; stage < stages; ++stage)
            make_module<Merger>(stage_name(stage).c_str(), *this, stage);
    }

  private:
    std::vector<std::unique_ptr<PingPong<std::int32_t>>> buffers_;
};

SimpleSimulation<MergeSort> const& merge_sort() {
    static SimpleSimulation<MergeSort> const one(
        {"merge_sort", {}, {{"sorted", "-", Tells::result, "1 if the last process's words are"}}});
    return one;
}

}  // namespace

Design const& dataflow::design() { return merge_sort(); }
SimulatedDesign const& dataflow::simulated_design() { return merge_sort(); }

int sc_main(int argc, char** argv) {
    return run_tool({"merge_sort", "Four processes and ping-pong buffers", "1.0"}, standard_commands(), argc, argv);
}
