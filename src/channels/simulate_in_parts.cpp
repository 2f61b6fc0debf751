#include "channels/simulate_in_parts.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>
#include <limits>
#include <new>
#include <string>
#include <sys/mman.h>
#include <thread>

#include "channels/collect_from.hpp"
#include "channels/figure_fields.hpp"
#include "dataflow/base/byte_stream.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/process_pool.hpp"
#include "dataflow/core/machine/core_ends.hpp"

namespace dataflow {

namespace {

/// What the processes tell each other meanwhile, in memory that they share.
struct Meeting {
    std::atomic<std::uint64_t> samples_done{0};
    std::atomic<Cycles> end{0};  ///< the latest of all cores whose processes have come here
    std::atomic<unsigned> come{0};
    static_assert(std::atomic<std::uint64_t>::is_always_lock_free && std::atomic<Cycles>::is_always_lock_free);

    /// The end of the run. A process that does not come here ends those that wait.
    Cycles end_with_all(Cycles own, unsigned all) {
        Cycles latest = end;
        while (latest < own && !end.compare_exchange_weak(latest, own)) {
        }
        ++come;
        while (come < all)
            std::this_thread::sleep_for(std::chrono::microseconds(100));
        return end;
    }
};

class SharedMeeting {
  public:
    SharedMeeting()
        : place_(mmap(nullptr, sizeof(Meeting), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
        if (place_ == MAP_FAILED)
            throw HostError("no memory to share with another process");
        meeting_ = new (place_) Meeting;
    }
    ~SharedMeeting() { munmap(place_, sizeof(Meeting)); }
    SharedMeeting(SharedMeeting const&) = delete;
    SharedMeeting& operator=(SharedMeeting const&) = delete;

    Meeting& operator*() const { return *meeting_; }
    Meeting* operator->() const { return meeting_; }

  private:
    void* place_;
    Meeting* meeting_ = nullptr;
};

/// Cores [first, end).
struct Part {
    std::size_t first, end;
};

/// As many as there are jobs, or cores with samples.
std::vector<Part> parts_of(DataflowAccelerator const& accelerator, std::size_t jobs) {
    auto const& cores = accelerator.cores();
    auto const working = static_cast<std::size_t>(
        std::count_if(cores.begin(), cores.end(), [](auto const& core) { return core->share().count > 0; }));
    std::size_t const count = std::min(jobs, working);
    std::vector<Part> parts;
    for (std::size_t i = 0; i < count; ++i)
        parts.push_back({i * working / count, i + 1 == count ? cores.size() : (i + 1) * working / count});
    return parts;
}

bool can_be_parted(DataflowAccelerator const& accelerator, SimulationOptions const& options) {
    return options.figures_alone && !options.looks_at_cycles() && !options.hazards && options.recorded == nullptr &&
           accelerator.engine() == Engine::decoupled && accelerator.memory() == nullptr;
}

std::string to_bytes(RunStatistics const& part) {
    ValueWriter writer;
    auto const put = [&writer](auto const&... values) { writer.put(values...); };
    put(part.total_cycles, part.samples.size(), part.cores.size());
    for (SampleStatistics const& sample : part.samples)
        visit_sample(put, sample);
    for (CoreStatistics const& core : part.cores)
        visit_core(put, core);
    return writer.bytes();
}

RunStatistics from_bytes(std::string bytes, Machine const& machine) {
    ValueReader reader(std::move(bytes));
    auto const get = [&reader](auto&... values) { reader.get(values...); };
    RunStatistics part;
    get(part.total_cycles);
    part.samples.resize(reader.get_size());
    part.cores.resize(reader.get_size(), empty_core(machine));
    for (SampleStatistics& sample : part.samples)
        visit_sample(get, sample);
    for (CoreStatistics& core : part.cores)
        visit_core(get, core);
    return part;
}

struct PartFailed {};

/// Throws PartFailed if its cores do not come to their ends.
std::string figures_of(DataflowAccelerator& accelerator, Part part, unsigned parts, Meeting& meeting) {
    for (std::size_t i = part.first; i < part.end; ++i)
        accelerator.cores()[i]->set_progress([&meeting] { ++meeting.samples_done; });
    accelerator.limit_to(part.first, part.end);
    accelerator.run();
    Cycles own = 0;
    for (std::size_t i = part.first; i < part.end; ++i) {
        timing::CoreTiming& timing = accelerator.cores()[i]->timing();
        timing.resolve();
        if (!timing.blocked().empty())
            throw PartFailed();
        std::optional<RunEnd> const end = run_end(accelerator.machine(), timing);
        own = std::max(own, end ? end->cycle + 1 : 0);
    }
    RunStatistics run = collect_from(accelerator, part.first, part.end, meeting.end_with_all(own, parts));
    for (SampleStatistics& sample : run.samples)
        sample.core += part.first;
    return to_bytes(run);
}

void append(RunStatistics& run, RunStatistics part) {
    run.total_cycles = part.total_cycles;
    std::move(part.samples.begin(), part.samples.end(), std::back_inserter(run.samples));
    std::move(part.cores.begin(), part.cores.end(), std::back_inserter(run.cores));
}

/// What the parts have sent back, by their numbers. Throws PartFailed if one of them fails, which ends the others.
std::vector<std::string> run_parts(DataflowAccelerator& accelerator, std::vector<Part> const& parts,
                                   std::function<void(std::uint64_t)> const& progress) {
    SharedMeeting const meeting;
    std::vector<std::string> figures(parts.size());
    processes::TaskStream stream;
    stream.next = [&](std::size_t number) -> std::optional<processes::Task> {
        if (number == parts.size())
            return std::nullopt;
        processes::Task task{[&, number] {
            return figures_of(accelerator, parts[number], static_cast<unsigned>(parts.size()), *meeting);
        }};
        task.time_limit_s = std::numeric_limits<double>::infinity();
        return task;
    };
    stream.ended = [&](std::size_t number, processes::Outcome outcome) {
        if (outcome.kind != processes::Outcome::Kind::done)
            throw PartFailed();
        figures[number] = std::move(outcome.output);
    };
    stream.meanwhile = [&] {
        if (progress && meeting->samples_done > 0)
            progress(meeting->samples_done);
    };
    processes::run_stream(stream, parts.size(), processes::SignalWatch());
    return figures;
}

}  // namespace

std::optional<RunStatistics> simulate_in_parts(DataflowAccelerator& accelerator, SimulationOptions const& options) {
    if (!can_be_parted(accelerator, options))
        return std::nullopt;
    std::vector<Part> const parts = parts_of(accelerator, options.jobs);
    if (parts.size() < 2)
        return std::nullopt;
    RunStatistics run;
    run.machine = accelerator.machine();
    try {
        for (std::string& figures : run_parts(accelerator, parts, options.progress))
            append(run, from_bytes(std::move(figures), run.machine));
    } catch (PartFailed const&) {
        return std::nullopt;
    } catch (HostError const&) {  // no further process, or no memory for it
        return std::nullopt;
    }
    return run;
}

}  // namespace dataflow
