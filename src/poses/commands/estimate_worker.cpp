#include "poses/commands/estimate_worker.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>

#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/tools/sweeps/journal_rows.hpp"
#include "dataflow/tools/sweeps/sweep_folder.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/bop/pose_results.hpp"
#include "poses/commands/estimate_size.hpp"

namespace faster {

namespace fs = std::filesystem;

namespace {

constexpr char complaint_mark = '!';  // before what is wrong, in place of an estimate, which is a {...} of JSON

/// What one process does, and sends back.
std::string done_or_refused(WantedEstimate const& wanted) {
    try {
        return to_json(estimated(wanted)).dump();
    } catch (InputError const& error) {
        return complaint_mark + std::string(error.what());
    }
}

std::string place_of(WantedEstimate const& wanted) {
    return fmt::format("{}, {}: object {} in image {} of scene {}", wanted.setting->name, wanted.method->name,
                       wanted.target.obj_id, wanted.target.image.im_id, wanted.target.image.scene_id);
}

}  // namespace

void take_folder_of_estimates(fs::path const& folder, std::string const& kind) {
    sweeps::take_folder(folder, kind, [journal = folder / journal_of_estimates] {
        return fs::is_regular_file(journal) && sweeps::may_be_journal(io::read_file(journal));
    });
}

EstimateWorker::EstimateWorker(std::vector<WantedEstimate> const& wanted, experiments::EstimateJournal& journal)
    : journal_(journal) {
    for (WantedEstimate const& each : wanted)
        if (journal.find(each.id) == nullptr)
            pending_.push_back(&each);
}

/// Of an estimate by each method, the first stands for all.
WorkSize EstimateWorker::size(char const* command, std::size_t jobs) const {
    std::map<MethodData const*, double> seconds;
    WorkSize size;
    size.command = command;
    size.amount = fmt::format("{} estimates", pending_.size());
    for (WantedEstimate const* const each : pending_) {
        auto const [of_method, is_first] = seconds.try_emplace(each->method, 0);
        if (is_first)
            of_method->second = seconds_of_estimate(each->method->loaded.config, scene_of(*each).observed, false);
        size.seconds += of_method->second / static_cast<double>(jobs);
    }
    return size;
}

void EstimateWorker::work(std::size_t jobs, std::size_t all) {
    processes::SignalWatch const watch;
    std::size_t done = all - pending_.size();
    ProgressLine progress("estimates", done);
    processes::TaskStream stream;
    stream.next = [this](std::size_t number) -> std::optional<processes::Task> {
        if (number >= pending_.size())
            return std::nullopt;
        return processes::Task{[wanted = pending_[number]] { return done_or_refused(*wanted); }};
    };
    stream.ended = [&](std::size_t number, processes::Outcome const& outcome) {
        take(*pending_[number], outcome);
        progress.show(++done, all);
    };
    processes::run_stream(stream, jobs, watch);
}

void EstimateWorker::take(WantedEstimate const& wanted, processes::Outcome const& outcome) {
    if (outcome.kind != processes::Outcome::Kind::done) {
        ++failed_;
        warn("{}: the estimate crashed, failed or took too long\n", place_of(wanted));
        return;
    }
    if (outcome.output.front() == complaint_mark)
        throw InputError(fmt::format("{}: {}", place_of(wanted), outcome.output.substr(1)));
    journal_.append({{wanted.id, Json::parse(outcome.output).get<experiments::EstimateResult>()}});
}

std::string results_of(std::vector<WantedEstimate> const& wanted, experiments::EstimateJournal const& journal,
                       SettingData const& setting, MethodData const& method) {
    std::vector<bop::PoseEstimate> estimates;
    for_each_result(wanted, journal, setting, method,
                    [&](WantedEstimate const& each, experiments::EstimateResult const& result) {
                        bop::PoseEstimate estimate;
                        estimate.image = each.target.image;
                        estimate.obj_id = each.target.obj_id;
                        estimate.score = result.weight;
                        estimate.pose = result.pose;
                        estimates.push_back(estimate);
                    });
    return bop::pose_results_csv(estimates);
}

}  // namespace faster
