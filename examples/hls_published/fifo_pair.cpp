// 61_dataflow and 62_stream of the public hls-directives as functions: two loops that are not pipelined.
#include <ap_int.h>
#include <faster_hls.h>
#include <hls_design.hpp>

namespace {

using Word = ap_int<32>;

void producer(hls::stream<Word, 16>& word, int words) {
    for (int i = 0; i < words; ++i) {
        FASTER_LOOP(send, 3);
        word.write(i);
    }
}

Word consumer(hls::stream<Word>& word, int words) {
    Word sum = 0;
    for (int i = 0; i < words; ++i) {
        FASTER_LOOP(receive, 2);
        sum += word.read();
    }
    return sum;
}

struct FifoPair : dataflow::HlsDesign {
    hls::stream<Word, 16> word{"word"};
    Word sum = 0;

    explicit FifoPair(dataflow::Numbers const& numbers) {
        int const words = static_cast<int>(numbers["workload.words"]);
        process("producer", [this, words] { producer(word, words); });
        process("consumer", [this, words] { sum = consumer(word, words); });
    }
    dataflow::Counters results() const override { return {static_cast<std::uint64_t>(sum.to_int64())}; }
    static dataflow::SimpleFacts facts() {
        return {"hls_fifo_pair",
                {{"workload.words", 16, "Words of one call."}},
                {{"sum", "-", dataflow::Tells::result, "of all words"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(FifoPair, "Two loops that are not pipelined, and a FIFO")
