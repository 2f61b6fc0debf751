// A design of two functions that is right, with a loop around another, until MISTAKE says what it does wrong.
#include <cstdlib>
#include <faster_hls.h>
#include <hls_design.hpp>
#include <stdexcept>
#include <string>

namespace {

bool makes(char const* mistake) {
    char const* const wanted = std::getenv("MISTAKE");
    return wanted != nullptr && std::string(wanted) == mistake;
}

hls::stream<int>& shared_by_functions() {
    static hls::stream<int> stream("shared");
    return stream;
}

void sender(hls::stream<int>& number, std::uint64_t call) {
    for (int row = 0; row < 3; ++row) {
        FASTER_LOOP(rows, 2);
        for (int i = 0; i < 4; ++i) {
            FASTER_PIPELINE(send, 1);
            number.write(4 * row + i);
        }
    }
    if (makes("shared stream"))
        shared_by_functions().write(1);
    if (makes("late attempt") && call > 0)
        number.write_nb(1);
}

void adder(hls::stream<int>& number, std::uint32_t& sum) {
    if (makes("loop in states")) {
        FASTER_STATES(pause, 3);
        for (int i = 0; i < 2; ++i) {
            FASTER_PIPELINE(idle, 1);
        }
    }
    sum = makes("other's end") && number.full() ? 1 : 0;
    for (int i = 0; i < (makes("too many") ? 13 : 12); ++i) {
        FASTER_PIPELINE(add, 1);
        sum += static_cast<std::uint32_t>(number.read());
    }
    if (makes("shared stream"))
        sum += static_cast<std::uint32_t>(shared_by_functions().read());
}

struct Mistakes : dataflow::HlsDesign {
    hls::stream<int> number{"number"};
    std::uint32_t sum = 0;

    explicit Mistakes(dataflow::Numbers const& /*numbers*/) {
        if (makes("early token"))
            number.write(1);
        if (makes("constructor"))
            throw std::runtime_error("no such table");
        process("sender", [this] { sender(number, call()); });
        process("adder", [this] { adder(number, sum); });
    }
    dataflow::Counters results() const override {
        if (makes("results"))
            throw std::runtime_error("no such sum");
        return {sum};
    }
    static dataflow::SimpleFacts facts() {
        return {"hls_mistakes", {}, {{"sum", "-", dataflow::Tells::result, "of the numbers"}}};
    }
};

}  // namespace

FASTER_HLS_PROGRAM(Mistakes, "A design that is right unless told to make a mistake")
