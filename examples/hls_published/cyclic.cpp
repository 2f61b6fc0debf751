// Design 02_fig3_ex3 of the public omnisim-benchmarks as functions: a controller that reads the answer to each request
// before it goes on, and a processor that answers.
#include <faster_hls.h>
#include <hls_design.hpp>

namespace {

using Message = std::uint32_t;

void processor(hls::stream<Message>& request, hls::stream<Message>& response, unsigned messages) {
    for (unsigned i = 0; i < messages; ++i) {
        FASTER_PIPELINE(double, 1);
        response << 2 * request.read();
    }
}

void controller(hls::stream<Message>& request, hls::stream<Message>& response, Message& sum, unsigned messages) {
    sum = 0;
    for (unsigned i = 0; i < messages; ++i) {
        FASTER_PIPELINE(exchange, 1, 3);
        request << i;
        Message answer;
        response >> answer;
        sum += answer;
    }
}

struct Cyclic : dataflow::HlsDesign {
    hls::stream<Message> request{"request"};
    hls::stream<Message> response{"response"};
    Message sum = 0;

    explicit Cyclic(dataflow::Numbers const& numbers) {
        auto const messages = static_cast<unsigned>(numbers["workload.messages"]);
        process("processor", [this, messages] { processor(request, response, messages); });
        process("controller", [this, messages] { controller(request, response, sum, messages); });
    }
    dataflow::Counters results() const override { return {sum}; }
    static dataflow::SimpleFacts facts() {
        return {"hls_cyclic",
                {{"workload.messages", 2025, "Requests of one sample."}},
                {{"sum", "-", dataflow::Tells::result, "of all answers"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(Cyclic, "A controller and a processor that wait for each other")
