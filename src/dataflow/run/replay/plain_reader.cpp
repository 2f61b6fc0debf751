#include "dataflow/run/replay/plain_reader.hpp"

#include "dataflow/run/replay/sample_cutter.hpp"

namespace dataflow::replay {

SampleOperations PlainReader::read(std::size_t sample) {
    if (auto const unfinished = run_.unfinished.find(sample); unfinished != run_.unfinished.end())
        return unfinished->second;
    if (!tape_)
        tape_.emplace(run_.tape, LeadCore(*run_.blueprint, run_.lead));
    return joined(tape_->read(sample), tape_->known().book(), tape_->known().lead().group);
}

void append_sample(std::vector<timing::Operation> const& operations, timing::OperationLog& log) {
    auto operation = operations.begin();
    if (operation != operations.end() && operation->kind() == timing::Operation::Kind::wait &&
        operation->is_plain_wait())
        log.wait((operation++)->count());
    for (; operation != operations.end(); ++operation)
        log.append(*operation);
}

void tell_end(timing::CoreTiming& core) {
    for (std::size_t process = 0; process < core.processes().size(); ++process)
        core.process(process).tell_end();
}

void tell_sample(std::vector<timing::Operation> const& operations, timing::ProcessTiming& process) {
    append_sample(operations, process.log());
    for (timing::OperationLog* const tape : process.tapes())
        append_sample(operations, *tape);
}

}  // namespace dataflow::replay
