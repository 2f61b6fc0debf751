#include "modules/inlier_unit/hidden_pixels.hpp"

#include <catch2/catch.hpp>

#include "dataflow/run/config/load_config.hpp"
#include "faster/reference/inlier_sweep.hpp"
#include "support/temp_folder.hpp"

namespace hidden_pixels_test {

using namespace faster;

constexpr int side = 8;
constexpr int fraction = 9;  // 2/256 m are 4 codes
constexpr std::uint16_t far = 2047;

/// A window in which nothing is drawn, and nothing was measured.
struct Window {
    Image<std::uint16_t> drawn{side, side};
    Image<std::uint16_t> observed{side, side};

    Window() { std::fill(drawn.pixels().begin(), drawn.pixels().end(), far); }
    void set(int row, int col, std::uint16_t depth, std::uint16_t reading) {
        drawn.at(row, col) = depth;
        observed.at(row, col) = reading;
    }
    SampleCounters swept(std::size_t pixels_at_once = side * side) const {
        SampleCounters counters;
        datapath::HiddenSweep const sweep(side, fraction);
        std::size_t const all = drawn.pixels().size();
        for (std::size_t first = 0; first < all; first += pixels_at_once)
            sweep.sweep(first, std::min(pixels_at_once, all - first), drawn.pixels().data(),
                        observed.pixels().data() + first, counters);
        return counters;
    }
    SampleCounters by_reference() const {
        SampleCounters counters;
        reference::count_hidden(drawn, observed, fraction, counters);
        return counters;
    }
};

using Box = std::array<std::uint64_t, 4>;
Box box(SampleCounters const& counters) {
    return {counters.visible_top, counters.visible_left, counters.visible_bottom, counters.visible_right};
}

TEST_CASE("A drawn pixel is hidden if something was measured more than 2/256 m in front of it", "[hidden]") {
    struct Case {
        std::uint16_t depth;
        std::uint16_t reading;
        bool hidden;
        bool visible;
    };
    for (Case const& one : {Case{500, 495, true, false},      // 5 codes in front
                            Case{500, 496, false, true},      // 4: an inlier
                            Case{500, 600, false, true},      // behind: contradicts, and hides nothing
                            Case{500, 0, false, true},        // no measurement
                            Case{1023, 1, true, false},       // just drawn
                            Case{1024, 1, false, false},      // from 2 m on nothing is
                            Case{far, 100, false, false}}) {  // nor here
        CAPTURE(one.depth, one.reading);
        Window window;
        window.set(3, 4, one.depth, one.reading);
        for (SampleCounters const& counters : {window.swept(), window.by_reference()}) {
            CHECK(counters.hidden == (one.hidden ? 1U : 0U));
            CHECK(box(counters) == (one.visible ? Box{3, 4, 3, 4} : Box{}));
        }
    }
}

TEST_CASE("The box is that of drawn, not hidden pixels inside the window's border", "[hidden]") {
    Window window;
    window.set(2, 5, 500, 500);
    window.set(4, 3, 500, 700);
    window.set(6, 1, 500, 100);  // hidden
    window.set(5, 6, 500, 0);
    window.set(0, 4, 500, 100);  // border
    window.set(7, 7, 500, 500);
    window.set(3, 0, 500, 500);
    for (SampleCounters const& counters : {window.swept(), window.swept(3), window.by_reference()}) {
        CHECK(counters.hidden == 1);
        CHECK(box(counters) == Box{2, 3, 5, 6});
    }
}

TEST_CASE("Hidden pixels need a depth buffer in which far is not drawn", "[hidden][config]") {
    test::TempFolder const folder;
    folder.write("test.yaml", "accelerator: {inlier_unit: {hidden: counted}, fraction_bits: {depth_buffer: 10}}");
    CHECK_THROWS_WITH(
        load_config(folder / "test.yaml"),
        Catch::Matchers::Contains("accelerator.inlier_unit.hidden = \"counted\", expected ignored because "
                                  "of accelerator.fraction_bits.depth_buffer = 10"));
    folder.write("test.yaml", "accelerator: {inlier_unit: {hidden: counted}, fraction_bits: {depth_buffer: 9}}");
    CHECK_NOTHROW(load_config(folder / "test.yaml"));
}

}  // namespace hidden_pixels_test
