// The tools' types by their names, and streams of them, as plain C++: what the headers alone do. And what is seen of
// functions that run without time.
#include <ap_axi_sdata.h>
#include <ap_fixed.h>
#include <ap_int.h>
#include <ap_shift_reg.h>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <faster_hls.h>
#include <hls_design.hpp>
#include <memory>
#include <sstream>
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

/// In place, where SystemC's operators see 64 bits.
void check_in_place() {
    ap_uint<24> a = 1;
    a <<= 78;
    check(a == 0, "shifts all out");
    a = 6;
    a <<= -2;
    check(a == 1, "shifts the other way");
    ap_int<12> s = 2;
    s %= ~std::uint64_t{0};
    check(s == 2, "a remainder of more than 63 bits");
    s = -9;
    s /= ap_uint<64>(~std::uint64_t{0});
    check(s == 0, "a quotient");
    ap_uint<8> u = 200;
    u /= ap_int<4>(-3);
    check(u == 190, "of both kinds");
    ap_uint<65> long_one = 0;
    long_one -= ap_uint<64>(std::uint64_t{1} << 63U);
    check(static_cast<bool>(long_one[64]) && static_cast<bool>(long_one[63]), "borrows above 64 bits");
}

template <int bits> int width_of(ap_uint<bits> /*number*/) { return bits; }
template <class Any> std::string printed(Any const& value, bool in_hex = false) {
    std::ostringstream out;
    if (in_hex)
        out << std::hex;
    out << value;
    return out.str();
}

/// As the tools write them.
void check_spelling() {
    ap_uint<8> const a = 200, b = 100;
    ap_int<9> const signed_one = a;
    ap_int<16> const shifted = a << 1;
    ap_uint<128> long_one = ap_uint<32>(7);
    ap_uint<8> const short_one = long_one;
    check(signed_one == 200 && shifted == 144 && long_one == 7 && short_one == 7, "converts where it is made");
    hls::stream<ap_int<16>> stream;
    stream.write(a);
    stream << a + b;
    check(stream.read() == 200 && stream.read() == 300, "and where it is written");
    check((a + b).to_int() == 300 && (a + b).length() == 9 && (a + b).range(3, 0) == 12 && (a + b)[2], "a result");
    check((~(a + b) & 511) == 211 && ((a + b) << 1).to_int() == 88, "as wide as the tools' is");
    check((a - b).length() == 9 && (a * signed_one).length() == 17 && (a / signed_one).length() == 9 &&
              (a % b).length() == 8 && (-a).length() == 9 && width_of(a) == 8,
          "and others");
    std::int64_t const plain = long_one;
    check(long_one && static_cast<int>(long_one) == 7 && plain == 7, "a plain number of a long one");
    ap_uint<8> const both = ap_uint<4>(5).concat(ap_uint<4>(3));
    check(both == 0x53 && signed_one.sign() == 0 && ap_int<70>(-1).sign(), "concatenation, sign");
    check(ap_uint<128>("0x1F", 16) == 31 && ap_int<8>("-101", 2) == -5 && ap_int<80>("-99", 10) == -99, "texts");
    ap_fixed<16, 8, AP_TRN, AP_WRAP, 0> fixed = ap_int<8>(-5);
    ap_int<8> const whole = ap_fixed<16, 8>(-3.5);
    check(fixed.to_double() == -5 && whole == -3 && ap_uint<8>(fixed) == 251 && fixed.length() == 16,
          "integers and fixed-point numbers");
    ap_fixed<60, 60> long_fixed;
    long_fixed.range(59, 0) = ap_uint<60>(0x123456789abcdef).range(59, 0);
    check(ap_int<60>(long_fixed) == 0x123456789abcdef, "an integer of more bits than a double has");
}

void check_printing() {
    check(printed(ap_ufixed<8, 4>(.25)) == "0.25" && printed(ap_fixed<32, 16>(0.1)) == "0.0999908", "as doubles");
    check(printed(ap_int<8>(-5)) == "-5" && printed(ap_uint<100>(12)) == "12", "decimal");
    check(printed(ap_uint<16>(0xbeef), true) == "0xbeef" && printed(ap_int<8>(-2), true) == "-0x2" &&
              printed(ap_uint<128>(0), true) == "0x0",
          "hexadecimal");
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
struct Complex {
    float real, imaginary;
};
struct Measured {
    std::int32_t cells;
    int length() const { return cells; }
};
struct SaidBeside {
    float value;
    bool is_last;
};

}  // namespace

template <> constexpr unsigned faster_bits<SaidBeside> = 33;

namespace {

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
    check(bits_of<Complex>() == 64 && bits_of<Measured>() == 32 && bits_of<SaidBeside>() == 33, "and of plain numbers");
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

/// Keeps what C++ lets a function keep from call to call.
struct Remembers : dataflow::HlsDesign {
    static int& calls() {
        static int number = 0;
        return number;
    }
    hls::stream<int> word{"word"};
    Remembers() {
        process("source", [this] { word.write(++calls()); });
        process("sink", [this] { word.read(); });
    }
};

/// Ends the program.
struct Crashes : dataflow::HlsDesign {
    hls::stream<int> word{"word"};
    Crashes() {
        process("source", [] { std::raise(SIGKILL); });
        process("sink", [this] { word.read(); });
    }
};

void check_descriptions() {
    check(described<Remembers>().modules.size() == 2 && Remembers::calls() == 0, "to be described is no call");
    check(is_refused([] { described<Crashes>(); },
                     "a function of the design has ended its process, by signal 9, expected functions that return"),
          "a function that crashes");
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

/// A quotient has the dividend's fraction, cut towards 0; by fewer bits of fraction than none, more.
void check_quotients() {
    ap_fixed<16, 8> const tall = 1.5, low = -2.25;
    ap_fixed<30, 15> quotient = tall / low;
    check(quotient.to_double() == -0.6640625, "cut towards 0");
    check((ap_fixed<16, 12>(12.5) / ap_fixed<16, 8>(1.0)).to_double() == 12.5, "of the dividend's fraction");
    check((ap_fixed<8, 4>(-7.5) / 2).to_double() == -3.75 && (7 / ap_ufixed<8, 4>(1.5)).to_double() == 4,
          "of integers");
    check((ap_fixed<8, 4>(5.0) / ap_fixed<8, 10>(12)).to_double() == 0.40625, "by a number without its lowest bits");
    ap_fixed<16, 8> divided = 10;
    divided /= low;
    check(divided.to_double() == -4.44140625, "in place");
    ap_fixed<70, 20> const wide = 3;
    quotient = wide / tall;
    check(quotient.to_double() == 2, "a wide one");
}

template <int width> void check_bits() {
    ap_uint<width> number = 6;
    check(number.get_bit(1) && !number.test(0) && number.countLeadingZeros() == width - 3, "bits of a number");
    number.set_bit(0, true);
    number.clear(1);
    number.set(3);
    number.invert(2);
    check(number == 9, "each by itself");
    number.reverse();
    check(number.get_bit(width - 1) && number.get_bit(width - 4) && number.countLeadingZeros() == 0, "the other way");
    ap_int<width> low = -1;
    low.clear(0);
    check(low == -2 && low.countLeadingZeros() == 0, "of a number with a sign");
    low = 0;
    low.set(width - 1);
    check(low < 0 && low.test(width - 1), "the sign itself");
}

void check_other_headers() {
    ap_shift_reg<int, 3> cells;
    check(cells.shift(1) == 0 && cells.shift(2, 0) == 1 && cells.shift(3, 0, false) == 2 && cells.read(1) == 1,
          "a shift register");
    using Word = ap_axiu<20, 0, 4, 0>;
    check(hls::stream<Word>().bits() == 20 + 3 + 3 + 1 + 4, "signals that are there");
    Word word;
    word.data = 0xFFFFFF;
    word.user = 1;
    word.last = 1;
    check(word.data == 0xFFFFF && word.user == 0 && word.last == 1, "a word of a stream");
    ap_axis<8, 1, 1, 1> low;
    low.data = 255;
    check(low.data == -1, "with a sign");
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
    check_in_place();
    check_spelling();
    check_printing();
    check_wide();
    check_widths();
    check_descriptions();
    check_loops_around_others();
    check_streams_of_nobody();
    check_shown_tokens();
    check_quotients();
    check_bits<16>();
    check_bits<70>();
    check_other_headers();
    return failures;
}
