#include "dataflow/tools/sizing/writes_in_a_cycle.hpp"

#include <algorithm>

#include "dataflow/run/replay/plain_reader.hpp"

namespace dataflow::sizing {

namespace {

using timing::Operation;
using Kind = Operation::Kind;

/// Accesses of a process's ports since it last took time for sure, and the most that there were.
class Accesses {
  public:
    explicit Accesses(std::size_t ports) : now_(ports), most_(ports) {}

    void take(Operation const& operation) {
        timing::Ports(operation.ports()).each([&](unsigned port) {
            most_[port] = std::max(most_[port], ++now_[port]);
        });
        if (takes_time(operation))
            std::fill(now_.begin(), now_.end(), 0);
    }
    std::uint64_t most(std::size_t port) const { return most_[port]; }

  private:
    static bool takes_time(Operation const& operation) {
        switch (operation.kind()) {
            case Kind::wait:
                return operation.is_plain_wait() && operation.count() > 0;
            case Kind::step:
                return operation.count() > 0;
            case Kind::enter:
            case Kind::leave:
            case Kind::stamp:
                return false;
            default:
                return true;
        }
    }

    std::vector<std::uint64_t> now_, most_;
};

}  // namespace

std::vector<std::uint64_t> writes_in_a_cycle(replay::RecordedRun const& run) {
    std::vector<Accesses> processes;
    for (timing::ProcessTiming const& process : run.blueprint->processes())
        processes.emplace_back(process.port_count());
    replay::PlainReader reader(run);
    for (std::size_t sample = 0; sample < run.tape.samples(); ++sample) {
        replay::SampleOperations const operations = reader.read(sample);
        for (std::size_t i = 0; i < processes.size(); ++i)
            for (Operation const& operation : operations[i])
                processes[i].take(operation);
    }
    std::vector<std::uint64_t> most(run.blueprint->fifos().size(), 1);
    for (std::size_t i = 0; i < processes.size(); ++i) {
        timing::ProcessTiming const& process = run.blueprint->processes()[i];
        for (unsigned port = 0; port < process.port_count(); ++port)
            if (process.writes(port) && !process.fifo(port).is_stream()) {
                std::uint64_t& of_fifo = most[run.blueprint->number_of(process.fifo(port))];
                of_fifo = std::max(of_fifo, processes[i].most(port));
            }
    }
    return most;
}

}  // namespace dataflow::sizing
