// The tools' types by their names, and streams of them, as plain C++: what the headers alone do. And what is seen of
// functions that run without time.
#include <ap_fixed.h>
#include <ap_int.h>
#include <cstdio>
#include <cstdlib>
#include <faster_hls.h>
#include <hls_design.hpp>
#include <memory>
#include <string>

#include "dataflow/base/input_error.hpp"
#include "hls/untimed_network.hpp"

namespace {

int failures = 0;

void check(bool holds, char const* what) {
    if (!holds)
        std::printf("failed: %s\n", what);
    failures += holds ? 0 : 1;
}

/// Where one side has a sign, the other none, and both have up to 64 bits.
void check_signs() {
    ap_int<8> s = -5;
    ap_uint<8> const a = 200, b = 100;
    check(s < b && !(s < ap_int<4>(-6)) && a > -1 && s < 3U && -1 < a && b - a < 0, "compares numbers, not bits");
    check(a == 200U && s != 251 && s == -5 && ap_uint<64>(-1) > s, "equal if the number is");
    int const quotient = static_cast<int>((b - a) / 3);
    check(quotient == -33 && (s * b) / 7 == -71 && s % b == -5 && a * -2 == -400 && 7 - b == -93, "arithmetic");
    check(static_cast<double>(b - a) == -100.0 && static_cast<double>(s * a) == -1000.0, "of a double");
    check(ap_fixed<16, 10, AP_TRN, AP_SAT>(b - a).to_double() == -100.0, "and of a fixed-point number");
    check((ap_uint<32>(-1) * ap_uint<32>(-1)) == 0xFFFFFFFE00000001U, "64 bits without a sign");
    check(-a == -200 && (a & s) == 200 && (s | b) == -1 && (a ^ s) == -205, "bits as of numbers");
    ap_uint<16> const inverted = ~a;
    check(inverted == 55 && !static_cast<bool>(~ap_uint<1>(1)) && ~s == 4, "inverts its own bits");
    ap_uint<16> const moved = a << 1;
    check(moved == 144 && (s << 1) == -10 && (s >> 1) == -3 && (a >> b) == 0 && (s >> 64) == -1, "shifts");
    check((ap_uint<32>(1) << 64) == 0 && (ap_uint<64>(5) >> 64) == 0 && (ap_int<8>(40) << -2) == 10 &&
              (ap_int<8>(40) >> -2) == -96,
          "shifts by more than there is, and the other way");
    s = s + b;
    check(s == 95, "adds up");
}

/// Above 64 bits.
void check_wide() {
    ap_uint<65> const highest = ap_uint<65>(1) << 64;
    ap_uint<80> const moved = (highest << 1) + (highest >> 63);
    check(moved == 2, "drops the bits beyond its width");
    ap_uint<80> const inverted = ~ap_uint<70>(5);
    check((inverted >> 70) == 0 && (inverted >> 69) == 1 && ~ap_int<70>(5) == -6, "inverts its own bits only");
    ap_int<100> const a = 512;
    check((a << -2) == 128 && (a >> ap_int<4>(-2)) == 2048 && (a << 300) == 0 && (ap_int<100>(-5) >> 200) == -1,
          "wide numbers the other way, and by more than there is");
    ap_int<100> b = a;
    b <<= 2;
    b >>= -1;
    check(b == 4096 && !ap_int<129>(0) && !!b, "and in place");
    ap_int<7> s = -20;
    ap_uint<70> const w = 9;
    s += w;
    check(s == -11, "adds a wide one to a narrow one");
    s -= w;
    s *= w;
    check(s == -52, "and wraps");
    s %= w;
    check(s == -7, "a remainder");
    s /= ap_int<70>(-2);
    s |= w;
    check(s == 11, "a quotient");
}

template <class Does> bool is_refused(Does does, std::string const& text = "") {
    try {
        does();
    } catch (dataflow::InputError const& error) {
        return std::string(error.what()).find(text) != std::string::npos;
    }
    return false;
}

/// Rows of two, none and one number.
struct Rows : dataflow::HlsDesign {
    hls::stream<int> number{"number"};
    Rows() {
        process("writer", [this] {
            for (int const length : {2, 0, 1}) {
                FASTER_LOOP(rows, 1);
                for (int i = 0; i < length; ++i) {
                    FASTER_PIPELINE(row, 1);
                    number.write(i);
                }
            }
        });
        dataflow::untimed::streams_of_design = nullptr;
    }
};

void check_loops_around_others() {
    Rows const rows;
    dataflow::untimed::UntimedNetwork network(rows.processes());
    network.run();
    using What = dataflow::untimed::Event::What;
    dataflow::untimed::Events const& events = network.events()[0];
    check(events.size() == 6 && events[2].what == What::leave && events[3].what == What::enter &&
              events[1].count == 2 && events[4].count == 1,
          "a loop around others takes no time where those have no iteration");
}

hls::stream<int> of_no_design("of_no_design");  // NOLINT(cert-err58-cpp)

struct Stranger : dataflow::HlsDesign {
    Stranger() {
        process("writer", [] { of_no_design.write(1); });
        dataflow::untimed::streams_of_design = nullptr;
    }
};

struct Forgetful : dataflow::HlsDesign {
    Forgetful() {
        hls::stream<int> const gone("gone");
        process("writer", [] {});
    }
};

void check_streams_of_nobody() {
    Stranger const stranger;
    dataflow::untimed::UntimedNetwork network(stranger.processes());
    check(is_refused([&] { network.run(); }), "a stream of no design");
    check(Forgetful().streams().front() == nullptr, "a stream that is gone");
}

struct Exact {
    std::int32_t a, b;
};
struct Padded {
    std::int32_t a;
    bool b;
};
struct Tools {
    ap_uint<8> a, b;
};
struct Said {
    static constexpr unsigned bits = 17;
    ap_uint<16> a;
    bool b;
};
template <class Token> unsigned bits_of() { return dataflow::untimed::TokenTraits<Token>::bits(); }

template <class Token> struct OneStream : dataflow::HlsDesign {
    hls::stream<Token> stream;
    explicit OneStream(std::string const& name) : stream(name) {
        process("writer", [this] { stream.write(Token()); });
        process("reader", [this] { stream.read(); });
    }
};
template <class Token> void complete(std::string const& name) { OneStream<Token>(name).complete(); }

void check_widths() {
    check(bits_of<Exact>() == 64 && bits_of<Said>() == 17 && bits_of<double>() == 64, "what is known");
    check(bits_of<Padded>() == 0 && bits_of<Tools>() == 0, "memory that is more than the wires");
    check(is_refused([] { complete<Tools>("pair"); }, "stream pair carries a struct"), "a struct of the tools' types");
    check(!is_refused([] { complete<Said>("pair"); }), "one that says its bits");
    check(is_refused([] { complete<int>("reader"); }, "a stream and a process of the design have the name reader"),
          "a stream by the name of a process");
}

struct TwoStreams : OneStream<int> {
    hls::stream<int> unused{"unused"};
    TwoStreams() : OneStream("used") {}
};

/// Both wait for each other before they write anything.
struct Circle : dataflow::HlsDesign {
    hls::stream<int> there{"there"}, back{"back"};
    Circle() {
        process("first", [this] { there.write(back.read()); });
        process("second", [this] { back.write(there.read()); });
    }
};

struct NobodyReads : dataflow::HlsDesign {
    hls::stream<int> word{"word"};
    NobodyReads() {
        process("writer", [this] { word.write(1); });
    }
};

/// What a body looks for in front of its read, as stages: with II 2, the first and the second.
struct InOrder : dataflow::HlsDesign {
    hls::stream<int> in{"in"}, before{"before"}, behind{"behind"}, asked{"asked"};
    InOrder() {
        process("source", [this] {
            for (int i = 0; i < 9; ++i)
                in.write(i);
        });
        process("middle", [this] {
            for (int i = 0; i < 9; ++i) {
                FASTER_PIPELINE(pass, 2, 5);
                bool const is_room = !asked.full();
                before.write_nb(i);
                int const number = in.read();
                behind.write_nb(number);
                if (is_room)
                    asked.write(number);
            }
        });
        process("sink", [this] {
            int number = 0;
            while (before.read_nb(number) || behind.read_nb(number) || asked.read_nb(number)) {
            }
        });
        keeps_tokens(behind);
    }
};

template <class Design> dataflow::CoreDescription described() {
    return dataflow::describe_hls_design({}, [](dataflow::Numbers const&) -> std::unique_ptr<dataflow::HlsDesign> {
        auto design = std::make_unique<Design>();
        design->complete();
        return design;
    });
}

void check_descriptions() {
    check(is_refused([] { described<TwoStreams>(); }, "stream unused of the design is not used with the defaults"),
          "a stream that nobody uses");
    check(is_refused([] { described<NobodyReads>(); }, "stream word of the design is not read with the defaults"),
          "a stream that nobody reads");
    check(is_refused([] { described<Circle>(); },
                     "is not written, as without time first waits for back, second waits for there for ever, with"),
          "who waits for whom before anything is written");
    for (dataflow::FifoEnd const& end : described<InOrder>().modules[1].ends)
        if (end.writes) {
            check(end.write_latency == (end.fifo == "behind" ? 1U : 0U), "a stage in the order of the body");
            check(end.may_keep_tokens == (end.fifo == "behind"), "tokens that may be left");
        }
}

void check_shown_tokens() {
    using Traits = dataflow::untimed::TokenTraits<ap_fixed<12, 4>>;
    check(Traits::shown(1.25) == 320 && Traits::shown(-0.25) == -64, "bits of a fixed-point number");
}

}  // namespace

// The libraries want a program's design, for which nobody asks here.
dataflow::Design const& dataflow::design() { std::abort(); }
dataflow::SimulatedDesign const& dataflow::simulated_design() { std::abort(); }

int sc_main(int /*argc*/, char** /*argv*/) {
    using Saturated = ap_fixed<8, 4, AP_RND, AP_SAT>;
    hls::stream<Saturated> saturated("saturated");
    saturated << Saturated(100.0);
    check(saturated.bits() == 8, "8 bits");
    check(saturated.read().to_double() == 7.9375, "saturates");
    ap_ufixed<4, 2> const cut = 1.3;
    check(cut.to_double() == 1.25, "truncates");
    ap_int<12> wrapped = 2049;
    check(wrapped == -2047, "wraps");
    hls::stream<ap_int<12>> narrow("narrow");
    check(narrow.bits() == 12 && narrow.is_signed(), "12 bits with a sign");
    check(narrow.empty() && !narrow.read_nb(wrapped), "nothing to read");
    check(narrow.write_nb(7) && !narrow.full() && narrow.size() == 1, "what is there");
    check(narrow.read_nb(wrapped) && wrapped == 7 && narrow.size() == 0, "what was written");
    check(narrow.capacity() == 2 && hls::stream<int, 16>().capacity() == 16, "what the type says");
    hls::stream<ap_uint<70>, 4> wide("wide");
    check(wide.bits() == 70 && !wide.is_signed() && wide.depth() == 4, "70 bits, 4 deep");
    wide.write(5);
    check(wide.read().to_int() == 5, "a wide one");
    check_signs();
    check_wide();
    check_widths();
    check_descriptions();
    check_loops_around_others();
    check_streams_of_nobody();
    check_shown_tokens();
    return failures;
}
