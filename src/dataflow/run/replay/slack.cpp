#include "dataflow/run/replay/slack.hpp"

#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/replay/retime_many.hpp"

namespace dataflow::replay {

namespace {

/// The search along one direction of one key: first the farthest change, then doubling, then bisection.
class Search {
  public:
    Search(RecordedRun const& run, LoadedConfig const& loaded, Key const& key, std::int64_t direction,
           Cycles total_cycles, SensitivityStep& step)
        : run_(run), loaded_(loaded), key_(key), direction_(direction), total_cycles_(total_cycles), step_(step) {
        costly_ = step.valid ? farthest_valid() + 1 : 1;
        end_ = costly_ > most_slack ? SlackEnd::limit : SlackEnd::invalid;
        if (step.valid)
            learn(1, finishes(step) && step.total_cycles <= total_cycles, step.needs_run);
    }

    bool done() const { return costly_ - free_ <= 1; }
    /// The change to be tried next, unless done().
    Machine next() {
        if (end_ != SlackEnd::costs)
            tried_ = costly_ - 1;
        else
            tried_ = is_doubling_ && 2 * free_ < costly_ ? 2 * free_ : (free_ + costly_) / 2;
        return machine_of(changed_by(tried_).config);
    }
    void learn(std::optional<RunStatistics> const& retimed) {
        learn(tried_, retimed && !retimed->deadlocked() && retimed->total_cycles <= total_cycles_, !retimed);
    }
    void finish() { step_.slack = Slack{free_, end_ == SlackEnd::costs && is_unknown_ ? SlackEnd::unknown : end_}; }

  private:
    void learn(std::int64_t change, bool is_free, bool is_unknown) {
        if (is_free) {
            free_ = change;
            return;
        }
        is_doubling_ = end_ != SlackEnd::costs;
        costly_ = change;
        is_unknown_ = is_unknown;
        end_ = SlackEnd::costs;
    }

    LoadedConfig changed_by(std::int64_t change) const {
        LoadedConfig changed = loaded_;
        std::int64_t const value = std::get<std::int64_t>(key_.read(loaded_.config));
        key_.write(changed.config, KeyValue{value + direction_ * change});
        return changed;
    }

    bool is_valid(std::int64_t change) const {
        std::int64_t const value = std::get<std::int64_t>(key_.read(loaded_.config)) + direction_ * change;
        if (!accepts(key_.integers, value))
            return false;
        LoadedConfig const changed = changed_by(change);
        return cross_check(changed).empty() && allows_run_on(machine_of(changed.config), run_);
    }

    /// Keys are valid up to some value.
    std::int64_t farthest_valid() const {
        std::int64_t valid = 1;
        std::int64_t invalid = most_slack + 1;
        while (invalid - valid > 1) {
            std::int64_t const middle = (valid + invalid) / 2;
            (is_valid(middle) ? valid : invalid) = middle;
        }
        return valid;
    }

    RecordedRun const& run_;
    LoadedConfig const& loaded_;
    Key const& key_;
    std::int64_t direction_;
    Cycles total_cycles_;
    SensitivityStep& step_;
    std::int64_t free_ = 0;    // costs nothing
    std::int64_t costly_ = 1;  // costs, or cannot be tried: see end_
    std::int64_t tried_ = 0;
    SlackEnd end_ = SlackEnd::costs;
    bool is_doubling_ = true;
    bool is_unknown_ = false;  // what costly_ takes
};

}  // namespace

void find_slack(RecordedRun const& run, LoadedConfig const& loaded, Cycles total_cycles, std::vector<Sensitivity>& rows,
                std::function<void(std::size_t, std::size_t)> const& progress) {
    Keys const keys = timing_keys(loaded.config);
    std::vector<Search> searches;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        searches.emplace_back(run, loaded, keys[i], -1, total_cycles, rows[i].down);
        searches.emplace_back(run, loaded, keys[i], 1, total_cycles, rows[i].up);
    }
    ScriptedRun const scripted(run);
    for (std::size_t done = 0;;) {
        std::vector<Machine> machines;
        std::vector<Search*> open;
        for (Search& search : searches)
            if (!search.done()) {
                machines.push_back(search.next());
                open.push_back(&search);
            }
        if (open.empty())
            break;
        std::size_t const known = done + open.size();
        retime_many(scripted, machines, [&](std::size_t i, std::optional<RunStatistics> const& retimed) {
            open[i]->learn(retimed);
            if (progress)
                progress(++done, known);
        });
    }
    for (Search& search : searches)
        search.finish();
}

}  // namespace dataflow::replay
