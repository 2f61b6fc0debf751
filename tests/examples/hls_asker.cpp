// A process that asks until it has an answer, in a loop that takes nothing, and one that talks until it is stopped:
// of what it has said, words are left.
#include <faster_hls.h>
#include <hls_design.hpp>

namespace {

void asker(hls::stream<int>& question, hls::stream<int>& answer, unsigned questions, std::uint32_t& waits) {
    waits = 0;
    for (unsigned i = 0; i < questions; ++i) {
        question.write(static_cast<int>(i));
        while (answer.empty()) {
            FASTER_PIPELINE(wait, 1, 1);
            ++waits;
        }
        answer.read();
    }
}

void answerer(hls::stream<int>& question, hls::stream<int>& answer, unsigned questions) {
    for (unsigned i = 0; i < questions; ++i) {
        FASTER_PIPELINE(think, 9, 9);
        answer.write(question.read() + 1);
    }
}

void talker(hls::stream<int>& word, hls::stream<bool>& stop) {
    for (bool is_stopped = false; !is_stopped;) {
        FASTER_PIPELINE(talk, 2, 3);
        word.write_nb(1);
        stop.read_nb(is_stopped);
    }
}

void listener(hls::stream<int>& word, hls::stream<bool>& stop, unsigned words) {
    for (unsigned i = 0; i < words; ++i) {
        FASTER_PIPELINE(listen, 3);
        word.read();
    }
    stop.write(true);
}

struct Asker : dataflow::HlsDesign {
    hls::stream<int> question{"question"}, answer{"answer"}, word{"word"};
    hls::stream<bool> stop{"stop"};
    std::uint32_t waits = 0;

    explicit Asker(dataflow::Numbers const& numbers) {
        auto const count = static_cast<unsigned>(numbers["workload.numbers"]);
        process("talker", [=] { talker(word, stop); });
        process("listener", [=] { listener(word, stop, count); });
        process("answerer", [=] { answerer(question, answer, count); });
        process("asker", [=] { asker(question, answer, count, waits); });
        keeps_tokens(word);
    }
    dataflow::Counters results() const override { return {waits}; }
    static dataflow::SimpleFacts facts() {
        return {"hls_asker",
                {{"workload.numbers", 10, "Questions, and words that are listened to."}},
                {{"waits", "-", dataflow::Tells::result, "iterations in which no answer was there"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(Asker, "Processes that ask, and that go on until they are stopped")
