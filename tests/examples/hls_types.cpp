// The tools' types by their names, and streams of them, as plain C++: what the headers alone do.
#include <ap_fixed.h>
#include <ap_int.h>
#include <cstdio>
#include <hls_stream.h>

namespace {

int failures = 0;

void check(bool holds, char const* what) {
    if (!holds)
        std::printf("failed: %s\n", what);
    failures += holds ? 0 : 1;
}

}  // namespace

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
    return failures;
}
