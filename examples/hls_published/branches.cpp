// Design 11_multicore of the public omnisim-benchmarks as functions: sixteen processors that fetch ahead of the
// branches which they execute, and one process that adds up what they did.
#include <array>
#include <faster_hls.h>
#include <hls_design.hpp>
#include <string>

namespace {

constexpr unsigned processors = 16;
using Streams = std::array<hls::stream<int>, processors>;

/// The target of a branch, or 0: of every so many instructions one is a branch, a little ahead.
int instruction_at(int address, unsigned processor) {
    auto const distance = static_cast<int>(20 + processor);
    return address % distance == 0 ? address + distance + 5 : 0;
}

void fetch(hls::stream<int>& instruction, hls::stream<int>& target, hls::stream<int>& count, unsigned processor,
           int end) {
    int fetched = 0;
    for (int address = 0; address < end; ++address) {
        FASTER_PIPELINE(fetch, 1, 3);
        ++fetched;
        instruction.write(instruction_at(address, processor));
        int branch = 0;
        if (target.read_nb(branch))
            address = branch;
    }
    instruction.write(-1);
    count.write(fetched);
}

void execute(hls::stream<int>& instruction, hls::stream<int>& target, hls::stream<int>& count) {
    int branches = 0;
    for (int next = 0; next >= 0;) {
        FASTER_PIPELINE(execute, 1, 2);
        next = instruction.read();
        if (next > 0) {
            target.write(next);
            ++branches;
        }
    }
    count.write(branches);
}

void add_up(Streams& fetched, Streams& executed, std::uint64_t& instructions, std::uint64_t& branches) {
    FASTER_STATES(add, 1);  // the tool unrolls the loop
    instructions = branches = 0;
    for (unsigned i = 0; i < processors; ++i) {
        instructions += static_cast<std::uint64_t>(fetched[i].read());
        branches += static_cast<std::uint64_t>(executed[i].read());
    }
}

struct Branches : dataflow::HlsDesign {
    Streams instruction, target, fetched, executed;
    std::uint64_t instructions = 0, branches = 0;

    explicit Branches(dataflow::Numbers const& numbers) {
        auto const end = static_cast<int>(numbers["workload.numbers"]);
        for (unsigned i = 0; i < processors; ++i)
            process("fetch" + std::to_string(i),
                    [this, i, end] { fetch(instruction[i], target[i], fetched[i], i, end); });
        for (unsigned i = 0; i < processors; ++i)
            process("execute" + std::to_string(i), [this, i] { execute(instruction[i], target[i], executed[i]); });
        process("add_up", [this] { add_up(fetched, executed, instructions, branches); });
        for (hls::stream<int>& stream : target)
            keeps_tokens(stream);
    }
    dataflow::Counters results() const override { return {instructions, branches}; }
    static dataflow::SimpleFacts facts() {
        return {"hls_branches",
                {{"workload.numbers", 2025, "Instructions of each processor's program."}},
                {{"instructions", "-", dataflow::Tells::result, "fetched by all processors"},
                 {"branches", "-", dataflow::Tells::result, "executed by all processors"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(Branches, "Processors that fetch ahead of their branches")
