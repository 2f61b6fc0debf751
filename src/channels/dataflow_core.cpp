#include "channels/dataflow_core.hpp"

#include <algorithm>
#include <utility>

#include "channels/fifo_channel.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/core/machine/build_core.hpp"

namespace dataflow {

DataflowCore::DataflowCore(sc_core::sc_module_name const& name, std::shared_ptr<Machine const> machine, CoreShare share,
                           TimeBase const& time_base)
    : sc_module(name),
      machine_(std::move(machine)),
      share_(share),
      time_base_(time_base),
      is_turn_over_(share.count == 0) {
    build_core(*timing_, *machine_);
    if (!timing_->streams().empty())
        memory_events_.resize(machine_->process_places());
    begun_.resize(timing_->processes().size());
    threads_.resize(begun_.size());
    has_process_.resize(begun_.size());
    for (MachineFifo const& fifo : machine_->fifos)
        if (fifo.hands_over > 0)
            made_.push_back(
                std::make_unique<HandOverChannel>((fifo.name + "_hand_over").c_str(), fifo_timing(fifo.name)));
}

std::vector<FifoChannel*> const& DataflowCore::channels() const {
    if (channels_.empty()) {
        channels_.resize(machine_->fifos.size());
        find_channels(*this);
    }
    return channels_;
}

/// The SystemC kernel knows everything that is part of an object.
void DataflowCore::find_channels(sc_core::sc_object const& parent) const {
    for (sc_core::sc_object* const child : parent.get_child_objects()) {
        if (auto* const channel = dynamic_cast<FifoChannel*>(child)) {
            FifoChannel*& place = channels_.at(timing_->number_of(channel->timing()));
            if (place != nullptr && dynamic_cast<HandOverChannel*>(place) == nullptr)  // which a PingPong replaces
                throw InputError("the FIFO " + channel->timing().name() + " has two channels, " +
                                 std::string(place->name()) + " and " + channel->name() + ", expected one");
            place = channel;
        }
        find_channels(*child);
    }
}

std::vector<TokenField> DataflowCore::token_fields(std::size_t fifo) const {
    FifoChannel const* const channel = channels()[fifo];
    return channel == nullptr ? std::vector<TokenField>() : channel->token_fields();
}

void DataflowCore::add_tap(std::size_t fifo, recording::TokenTap& tap) {
    if (channels()[fifo] != nullptr)
        channels()[fifo]->taps().push_back(&tap);
}

void DataflowCore::remove_tap(std::size_t fifo, recording::TokenTap& tap) {
    if (channels()[fifo] == nullptr)
        return;
    std::vector<recording::TokenTap*>& taps = channels()[fifo]->taps();
    taps.erase(std::remove(taps.begin(), taps.end(), &tap), taps.end());
}

WriteDistances* DataflowCore::write_distances(std::size_t process, std::string_view loop, std::string_view memory) {
    std::size_t const number = machine_->loop(process, loop);
    std::size_t const of_memory = machine_->memory(memory);
    std::optional<std::size_t> const found = machine_->loops[number].dependence_on(of_memory);
    if (!found)
        return nullptr;
    MachineDependence const& dependence = machine_->loops[number].dependences[*found];
    if (!watches_dependences_ && !dependence.interlocks())
        return nullptr;
    watched_.push_back(
        {number, *found, std::make_unique<WriteDistances>(machine_->memories[of_memory].words, dependence.span())});
    return watched_.back().distances.get();
}

std::vector<DependenceStatistics> DataflowCore::dependences() const {
    std::vector<DependenceStatistics> all;
    if (!watches_dependences_)  // what is there only serves iterations that wait
        return all;
    for (WatchedDependence const& one : watched_)
        all.push_back({one.loop, one.number, one.distances->smallest(), one.distances->counts()});
    std::sort(all.begin(), all.end(), [](DependenceStatistics const& a, DependenceStatistics const& b) {
        return a.loop != b.loop ? a.loop < b.loop : a.number < b.number;
    });
    return all;
}

void DataflowCore::throw_error() const {
    for (auto const& [process, error] : errors_)
        if (time_base_.engine == Engine::lockstep || timing_->processes()[process].log().exhausted())
            std::rethrow_exception(error);
}

void DataflowCore::catch_up() {
    if (time_base_.engine != Engine::decoupled)
        return;
    if (memory_ != nullptr)
        memory_->note_sample();
    else if (thread_ != nullptr)
        tell_thread();
    else
        timing_->resolve(false);
}

/// Everything is connected before the thread comes.
void DataflowCore::use_thread(Worker& thread) {
    timing_->resolve(false);
    thread_ = &thread;
    logs_for_thread_.resize(timing_->processes().size());
}

void DataflowCore::tell_thread() {
    std::vector<std::vector<timing::Operation>> told;
    std::size_t operations = 0;
    for (timing::OperationLog& log : logs_for_thread_) {
        told.emplace_back(log.begin(), log.begin() + log.pending());
        operations += log.pending();
        log.clear();
    }
    if (operations == 0)
        return;
    thread_->tell(operations, [this, told = std::move(told)] {
        for (std::size_t process = 0; process < told.size(); ++process)
            for (timing::Operation const& operation : told[process])
                timing_->process(process).log().append(operation);
        timing_->resolve(false);
    });
}

void DataflowCore::add_entry(std::size_t process, timing::MemoryEntry entry) {
    std::vector<std::size_t> const streams = streams_of(*machine_);
    for (std::size_t master = 0; master < streams.size(); ++master)
        if (machine_->streams[streams[master]].process == process) {
            if (entry_call_)
                entry_call_(master, entry);
            memory_->add(number_, master, std::move(entry));
            return;
        }
}

/// Iterations cannot wait for writes of which nobody tells.
void DataflowCore::require_interlocks() const {
    for (std::size_t const loop : loops_of(*machine_))
        for (std::size_t i = 0; i < machine_->loops[loop].dependences.size(); ++i) {
            auto const is_it = [=](WatchedDependence const& one) { return one.loop == loop && one.number == i; };
            if (machine_->loops[loop].dependences[i].interlocks() &&
                std::none_of(watched_.begin(), watched_.end(), is_it))
                throw InputError("the loop " + machine_->loop_name(loop) + " has hazards interlock on " +
                                 machine_->memories[machine_->loops[loop].dependences[i].memory].name +
                                 ", expected its module to ask for write_distances() in start_of_simulation()");
        }
}

/// One that is described and not there would never read or write, which looks like a deadlock.
void DataflowCore::require_modules() const {
    for (std::size_t const process : modules_of(*machine_))
        if (!has_process_[process])
            throw InputError("module " + machine_->processes[process].name +
                             " is described, but the core has no such module, expected it made in the core's "
                             "constructor");
}

std::optional<std::size_t> DataflowCore::running_process(std::size_t likely) const {
    sc_core::sc_process_b const* const running = sc_core::sc_get_current_process_b();
    if (running == nullptr || threads_[likely] == running)
        return likely;
    auto const found = std::find(threads_.begin(), threads_.end(), running);
    return found == threads_.end() ? std::nullopt : std::optional<std::size_t>(found - threads_.begin());
}

void DataflowCore::start_of_simulation() {
    require_modules();
    for (auto const& call : starts_)
        call();
}

void DataflowCore::begin_sample(std::size_t process) {
    std::size_t const sample = begun_[process]++;
    if (sample == 0) {
        threads_[process] = sc_core::sc_get_current_process_b();
        require_interlocks();
        await_turn_of(process);
    }
    for (auto const& call : process_begins_)
        call(process);
    if (process == machine_->begins)
        for (auto const& call : sample_begins_)
            call(sample);
}

/// All others wait for what these write.
void DataflowCore::await_turn_of(std::size_t process) const {
    std::vector<MachineEnd> const& ends = machine_->processes[process].ends;
    bool const reads = std::any_of(ends.begin(), ends.end(), [](MachineEnd const& end) {
        return !end.writes && (end.when == FifoEnd::When::within_call || end.when == FifoEnd::When::call_begins);
    });
    while (!reads && before_ != nullptr && !before_->is_turn_over_)
        sc_core::wait(before_->turn_ends_);
}

void DataflowCore::end_sample() {
    ++samples_ended_;
    catch_up();  // all of the sample is known now: a good moment
    if (progress_)
        progress_();
    if (samples_ended_ == share_.count)
        end_turn();
}

void DataflowCore::end_turn() {
    is_turn_over_ = true;
    turn_ends_.notify(sc_core::SC_ZERO_TIME);
}

}  // namespace dataflow
