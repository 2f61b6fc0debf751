#include "dataflow/run/replay/tape_writer.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

#include "dataflow/base/input_error.hpp"
#include "dataflow/run/replay/canonical_operations.hpp"

namespace dataflow::replay {

namespace {
constexpr std::size_t most_waiting = 16;  // samples: some megabytes

/// A process that reads several FIFOs mixes iterations of several ports in a loop, and how it tells them depends on how
/// many tokens it finds. In a lead group, that is who reads several FIFOs of the group: what else is read there is read
/// in one way only.
bool mixes_ports(LeadCore const& lead, std::size_t process) {
    if (!lead.has_followers())
        return true;
    std::vector<timing::Group::Inner> const& fifos = lead.group.fifos();
    auto const is_read = [&](timing::Group::Inner const& fifo) {
        return lead.group.members()[fifo.reader].process->index() == process;
    };
    return std::count_if(fifos.begin(), fifos.end(), is_read) > 1;
}

}  // namespace

TapeWriter::TapeWriter(RecordedRun& run, timing::Lead const& lead, std::size_t processes)
    : run_(run), lead_(lead), step_ports_(processes) {
    try {
        thread_ = std::make_unique<Worker>(most_waiting);
    } catch (std::system_error const& error) {
        throw HostError("no thread to record with (" + error.code().message() + "), expected room for more of them");
    }
}

void TapeWriter::put(std::size_t sample, SampleOperations operations) {
    thread_->tell(
        1, [this, sample, operations = std::move(operations)]() mutable { write(sample, std::move(operations)); });
}

void TapeWriter::finish() {
    thread_->finish();
    run_.tape.finish();
}

void TapeWriter::write(std::size_t sample, SampleOperations operations) {
    if (!cutter_)
        cutter_ = std::make_unique<SampleCutter>(*run_.blueprint, lead_);
    for (std::size_t i = 0; i < operations.size(); ++i) {
        if (mixes_ports(cutter_->lead(), i))
            return_tails(operations[i]);
        operations[i] = canonical(operations[i].data(), operations[i].size());
        for (timing::Operation const& operation : operations[i])
            if (operation.kind() == timing::Operation::Kind::step)
                step_ports_[i] = step_ports_[i] | timing::Ports(operation.ports());
    }
    run_.tape.put(sample, cutter_->cut(std::move(operations)), cutter_->book());
}

}  // namespace dataflow::replay
