#pragma once
#include <array>
#include <vector>

#include "dataflow/commands/simple_tool.hpp"
#include "image.hpp"

namespace convolution {

inline Images images_of(dataflow::Numbers const& numbers) {
    return {numbers["workload.rows"], numbers["workload.cols"]};
}

/// Sends the pixels of an image, row by row.
class Reader : public dataflow::SimpleModule {
  public:
    sc_core::sc_fifo_out<Pixel> pixel_out{"pixel_out"};

    static dataflow::ModuleDescription describe();
    Reader(sc_core::sc_module_name const& name, dataflow::SimpleCore& core)
        : SimpleModule(name, core), images_(images_of(core.numbers())) {}

  private:
    void work(std::size_t image) override;

    Images images_;
};

/// Adds up the 3 x 3 pixels that end at each pixel. The two rows above come from the line buffer, a block RAM of two
/// rows: row y of the image lies in its row y mod 2, so that the newest pixel takes the place of the oldest.
class Convolve : public dataflow::SimpleModule {
  public:
    sc_core::sc_fifo_in<Pixel> pixel_in{"pixel_in"};
    sc_core::sc_fifo_out<Sum> sum_out{"sum_out"};

    static dataflow::ModuleDescription describe(Images const& images);
    Convolve(sc_core::sc_module_name const& name, dataflow::SimpleCore& core);

  private:
    void work(std::size_t image) override;
    Sum take(Pixel newest, std::size_t row, std::size_t col);

    Images images_;
    std::array<std::vector<Pixel>, 2> line_buffer_;
    Pixel window_[3][3] = {};
};

/// Counts the sums that are not those of the plain loop.
class Writer : public dataflow::SimpleModule {
  public:
    sc_core::sc_fifo_in<Sum> sum_in{"sum_in"};

    static dataflow::ModuleDescription describe();
    Writer(sc_core::sc_module_name const& name, dataflow::SimpleCore& core)
        : SimpleModule(name, core), images_(images_of(core.numbers())) {}

  private:
    void work(std::size_t image) override;

    Images images_;
};

}  // namespace convolution
