#include "dataflow/core/time/core_timing.hpp"

#include <algorithm>
#include <stdexcept>

namespace dataflow::timing {

FifoTiming& CoreTiming::add_fifo(FifoShape shape) { return fifos_.emplace_back(std::move(shape)); }

ProcessTiming& CoreTiming::add_process(std::string name, std::shared_ptr<ProcessShape> shape) {
    if (processes_.size() == most_processes)
        throw std::logic_error(name + ": a core has at most " + std::to_string(most_processes) + " processes");
    return processes_.emplace_back(std::move(name), static_cast<unsigned>(processes_.size()), std::move(shape));
}

std::size_t CoreTiming::number_of(FifoTiming const& fifo) const {
    auto const same = [&fifo](FifoTiming const& other) { return &other == &fifo; };
    return static_cast<std::size_t>(std::find_if(fifos_.begin(), fifos_.end(), same) - fifos_.begin());
}

std::size_t CoreTiming::number_of(MemoryStream const& stream) const {
    auto const same = [&stream](MemoryStream const& other) { return &other == &stream; };
    return static_cast<std::size_t>(std::find_if(streams_.begin(), streams_.end(), same) - streams_.begin());
}

void CoreTiming::connect() {
    if (!ends_.empty())
        return;
    ends_.assign(fifos_.size(), Ends{});
    for (ProcessTiming const& process : processes_)
        for (unsigned port = 0; port < process.port_count(); ++port) {
            if (process.fifo(port).is_stream())
                continue;
            Ends& both = ends_[number_of(process.fifo(port))];
            (process.writes(port) ? both.writer : both.reader) = static_cast<int>(process.index());
        }
    for (ProcessTiming& process : processes_)
        for (unsigned port = 0; port < process.port_count(); ++port) {
            if (process.fifo(port).is_stream())
                continue;
            int const other = other_end(process, port);
            process.set_neighbour(port, other < 0 ? 0 : bit_of(other));
        }
    find_patient();
    note_connected();
}

std::unique_ptr<CoreTiming> CoreTiming::blank_copy() const {
    auto copy = std::make_unique<CoreTiming>();
    copy->be_blank_copy_of(*this);
    return copy;
}

void CoreTiming::be_blank_copy_of(CoreTiming const& core) {
    for (FifoTiming const& fifo : core.fifos_)
        add_fifo(fifo.shape());
    for (MemoryStream const& stream : core.streams_)
        add_stream(stream.name(), stream.enters_by());
    for (ProcessTiming const& process : core.processes_) {
        ProcessTiming& same = add_process(process.name(), process.shape());
        for (unsigned port = 0; port < process.port_count(); ++port) {
            if (process.fifo(port).is_stream()) {
                same.add_stream(stream(core.number_of(*process.stream())));
                continue;
            }
            FifoTiming& own = fifo(core.number_of(process.fifo(port)));
            process.writes(port) ? same.add_writes(own) : same.add_reads(own);
        }
    }
}

std::unique_ptr<CoreTiming> CoreTiming::copy() {
    complete_counters();
    std::unique_ptr<CoreTiming> same = blank_copy();
    for (std::size_t i = 0; i < fifos_.size(); ++i)
        same->fifos_[i] = fifos_[i];
    for (std::size_t i = 0; i < streams_.size(); ++i)
        same->streams_[i].take_state(streams_[i]);
    for (std::size_t i = 0; i < processes_.size(); ++i)
        same->processes_[i].take_state(processes_[i]);
    return same;
}

/// Two processes with nothing but deep FIFOs between them.
void CoreTiming::find_patient() {
    constexpr std::uint64_t deep = 64;
    patient_.assign(processes_.size(), all_processes());
    for (std::size_t i = 0; i < fifos_.size(); ++i) {
        if (fifos_[i].shape().capacity >= deep || ends_[i].writer < 0 || ends_[i].reader < 0)
            continue;
        patient_[static_cast<std::size_t>(ends_[i].writer)] &= ~bit_of(ends_[i].reader);
        patient_[static_cast<std::size_t>(ends_[i].reader)] &= ~bit_of(ends_[i].writer);
    }
}

void CoreTiming::settle(ProcessMask runnable, ProcessMask held) {
    ProcessMask later = 0;
    for (runnable &= ~held; (runnable | later) != 0;) {
        // Downstream processes first: what they read is what makes room for those before them. Who has a deep FIFO to
        // fill or to empty comes last, and then has much to do at once.
        ProcessMask const next = runnable != 0 ? runnable : later;
        auto const index = 63U - static_cast<unsigned>(__builtin_clzll(next));
        runnable &= ~bit_of(index);
        later &= ~bit_of(index);
        ProcessTiming& process = processes_[index];
        if (process.finished())
            continue;
        ProcessMask woken = 0;
        if (process.is_running(ProcessTiming::long_count))
            woken = run_ahead(process);
        woken = (woken | process.advance()) & ~held;
        runnable |= woken & ~patient_[index];
        later |= woken & patient_[index];
    }
}

bool CoreTiming::keep_more() {
    bool keeps_more = false;
    for (FifoTiming& fifo : fifos_)
        if (fifo.is_unlimited() && fifo.known_writes() == 0) {
            fifo.keep_more();
            keeps_more = true;
        }
    return keeps_more;
}

Cycles CoreTiming::unknown_from() const {
    Cycles from = ~Cycles{0};
    for (ProcessTiming const& process : processes_)
        if (process.finished() && process.port_count() > 0)
            from = std::min(from, process.not_before());
    return from;
}

void CoreTiming::resolve(bool to_the_end) {
    connect();
    look_at_logs();
    go_on(to_the_end);
    if (to_the_end)
        complete_counters();
    for (ProcessTiming& process : processes_)
        process.log().compact();
    shorten_trail();
}

void CoreTiming::go_on(bool /*to_the_end*/) {
    do
        settle(all_processes(), 0);
    while (keep_more());
}

void CoreTiming::resolve_processes(ProcessMask processes) {
    connect();
    look_at_logs();
    settle(processes, 0);
    while (!streams_.empty() && keep_more())
        settle(all_processes(), 0);
    shorten_trail();
}

void CoreTiming::leave_trail(ShortenTrail shorten, std::size_t length) {
    shorten_trail_ = shorten;
    trail_ = std::make_unique<Trail>(length);
    for (ProcessTiming& process : processes_)
        process.set_trail(trail_.get());
    note_trail(*trail_);
}

void CoreTiming::shorten_trail() {
    if (trail_ == nullptr || !trail_->is_long())
        return;
    connect();
    shorten_trail_(*this, *trail_);
}

/// Who has to go on before a process can.
std::string CoreTiming::name_at_other_end(ProcessTiming const& process, unsigned port) const {
    if (process.fifo(port).is_stream())
        return "memory";
    int const other = other_end(process, port);
    return other < 0 ? "nobody" : processes_[static_cast<std::size_t>(other)].name();
}

std::vector<BlockedProcess> CoreTiming::blocked() {
    connect();
    std::vector<BlockedProcess> blocked;
    for (ProcessTiming& process : processes_) {
        ProcessTiming::Status const status = process.front();
        bool const starving = status == ProcessTiming::Status::exhausted && process.starving_port() >= 0;
        if (status != ProcessTiming::Status::blocked && !starving && !process.waits_for_room())
            continue;
        process.take_back_write_waits();
        unsigned const port = process.waits_for_room() ? process.flushing_port()
                              : starving               ? process.starved_port()
                                                       : process.missing_port();
        FifoTiming const& fifo = process.fifo(port);
        BlockedProcess one;
        one.process = process.name();
        one.position = process.position();
        one.fifo = fifo.name();
        one.to_write = process.writes(port);
        one.occupancy = std::min(fifo.writes() - fifo.reads(), fifo.shape().capacity);
        one.capacity = fifo.shape().capacity;
        one.since = process.waiting_since();
        one.site = process.site_at_hand(port);
        one.for_memory = fifo.is_stream();
        one.other = name_at_other_end(process, port);
        blocked.push_back(one);
    }
    return blocked;
}

}  // namespace dataflow::timing
