#include "line_buffer_activity.hpp"
#include "modules.hpp"

using namespace dataflow;

namespace convolution {
namespace {

/// A reader, the convolution and a writer, in a row.
class ConvolutionCore : public SimpleCore {
  public:
    static CoreDescription describe(Numbers const& numbers) {
        return core_of({Reader::describe(), Convolve::describe(images_of(numbers)), Writer::describe()});
    }
    explicit ConvolutionCore(SimpleCoreParts const& parts) : SimpleCore(parts) {
        reader_.pixel_out(pixel_);
        convolve_.pixel_in(pixel_);
        convolve_.sum_out(sum_);
        writer_.sum_in(sum_);
    }

    std::unique_ptr<recording::MemoryActivity> memory_activity() const override {
        return std::make_unique<LineBufferActivity>(images_of(numbers()), machine());
    }

  private:
    ClockedFifo<Pixel> pixel_{"pixel", fifo_timing("pixel")};
    ClockedFifo<Sum> sum_{"sum", fifo_timing("sum")};
    Reader reader_{"reader", *this};
    Convolve convolve_{"convolve", *this};
    Writer writer_{"writer", *this};
};

SimpleSimulation<ConvolutionCore> const& the_design() {
    static SimpleSimulation<ConvolutionCore> const one(
        {"convolution",
         {{"workload.rows", 16, "Height of an image [px].", {1, 4096}},
          {"workload.cols", 16, "Width of an image [px].", {1, 4096}}},
         {{"sum", "-", Tells::result, "of all sums of the image"},
          {"wrong", "px", Tells::result, "sums that differ from those of a plain loop"}}});
    return one;
}

}  // namespace
}  // namespace convolution

Design const& dataflow::design() { return convolution::the_design(); }
SimulatedDesign const& dataflow::simulated_design() { return convolution::the_design(); }

int sc_main(int argc, char** argv) {
    return run_tool({"convolution", "A 3 x 3 convolution with a line buffer whose ports decide the pace", "1.0"},
                    standard_commands(), argc, argv);
}
