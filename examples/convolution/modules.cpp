#include "modules.hpp"

namespace convolution {

using dataflow::ModuleDescription;
using dataflow::tokens_of;

ModuleDescription Reader::describe() {
    ModuleDescription module("reader");
    module.writes_to("pixel").carries("pixels from the reader to the convolution").of_bits(8).leaves("read", 2);
    module.loop("read").does("sends one pixel per iteration").of_depth(3);
    return module;
}

void Reader::work(std::size_t image) {
    clock_.advance(1);
    clock_.pipeline("read", images_.pixels(), tokens_of(pixel_out), [&](std::uint64_t i, Pixel& pixel) {
        pixel = images_.pixel(image, i / images_.cols, i % images_.cols);
    });
}

/// An iteration reads its column of both rows of the line buffer and writes one of the two words: three accesses. That
/// is all that decides its initiation interval: the ports and banks of a configuration do the rest.
ModuleDescription Convolve::describe(Images const& images) {
    ModuleDescription module("convolve");
    module.reads_from("pixel").taken("convolve", 0);
    module.writes_to("sum").carries("sums from the convolution to the writer").of_bits(16).leaves("convolve", 5);
    module.loop("convolve")
        .does("works out the sum of one window per iteration")
        .of_depth(6)
        .accesses_memory("line_buffer", {{{0, 0}, {1, 0}}, {{0, 0}}});
    module.memory("line_buffer")
        .holds("the last two rows of the image")
        .of_words(2, images.cols, 8)
        .sized_by("workload.cols");
    return module;
}

Convolve::Convolve(sc_core::sc_module_name const& name, dataflow::SimpleCore& core)
    : SimpleModule(name, core), images_(images_of(core.numbers())) {
    for (std::vector<Pixel>& row : line_buffer_)
        row.resize(images_.cols);
}

void Convolve::work(std::size_t /*image*/) {
    clock_.advance(1);
    clock_.pipeline(
        "convolve", images_.pixels(), tokens_of(pixel_in, sum_out),
        [this](std::uint64_t i, Pixel pixel, Sum& sum) { sum = take(pixel, i / images_.cols, i % images_.cols); });
}

/// Moves the window one pixel to the right and adds it up.
Sum Convolve::take(Pixel newest, std::size_t row, std::size_t col) {
    Pixel const above = row >= 1 ? line_buffer_[(row + 1) % 2][col] : Pixel{0};
    Pixel const two_above = row >= 2 ? line_buffer_[row % 2][col] : Pixel{0};
    line_buffer_[row % 2][col] = newest;
    Pixel const column[3] = {two_above, above, newest};
    Sum sum = 0;
    for (std::size_t y = 0; y < 3; ++y) {
        window_[y][0] = col >= 2 ? window_[y][1] : Pixel{0};
        window_[y][1] = col >= 1 ? window_[y][2] : Pixel{0};
        window_[y][2] = column[y];
        for (std::size_t x = 0; x < 3; ++x)
            sum += weights[y][x] * window_[y][x];
    }
    return sum;
}

ModuleDescription Writer::describe() {
    ModuleDescription module("writer");
    module.reads_from("sum").taken("write", 0);
    module.loop("write").does("stores one sum per iteration").of_depth(2);
    return module;
}

void Writer::work(std::size_t image) {
    std::uint64_t total = 0;
    std::uint64_t wrong = 0;
    clock_.advance(1);
    clock_.pipeline("write", images_.pixels(), tokens_of(sum_in), [&](std::uint64_t i, Sum sum) {
        total += sum;
        if (sum != plain_sum(images_, image, i / images_.cols, i % images_.cols))
            ++wrong;
    });
    add_result({total, wrong});
}

}  // namespace convolution
