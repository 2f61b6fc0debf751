// The design of examples/pipeline by functions over hls::stream, which also go through an HLS tool.
#include <hls_design.hpp>

#include "functions.hpp"

using namespace dataflow;

struct Pipeline : HlsDesign {
    hls::stream<std::uint32_t> number{"number"};
    hls::stream<std::uint32_t> product{"product"};
    std::uint32_t sum = 0;

    explicit Pipeline(Numbers const& numbers) {
        auto const count = static_cast<unsigned>(numbers["workload.numbers"]);
        process("reader", [this, count] { reader(number, count); });
        process("scaler", [this, count] { scaler(number, product, count); });
        process("writer", [this, count] { sum = writer(product, count); });
    }
    Counters results() const override { return {sum}; }
    static SimpleFacts facts() {
        return {"hls_pipeline",
                {{"workload.numbers", 1000, "Numbers of one sample."}},
                {{"sum", "-", Tells::result, "of all products"}}};
    }
};

FASTER_HLS_PROGRAM(Pipeline, "A reader, a scaler and a writer")
