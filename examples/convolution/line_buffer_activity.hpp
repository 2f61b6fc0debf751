#pragma once
#include "dataflow/tools/recording/memory_activity.hpp"
#include "image.hpp"

namespace convolution {

/// Which words of the line buffer an iteration accesses, for waveforms.
class LineBufferActivity : public dataflow::recording::MemoryActivity {
  public:
    LineBufferActivity(Images const& images, dataflow::Machine const& machine)
        : cols_(images.cols),
          line_buffer_(machine.memory("line_buffer")),
          loop_(machine.loop(machine.process("convolve"), "convolve")) {}

    void iterated(dataflow::recording::LoopIteration const& iteration,
                  dataflow::recording::MemoryPorts& ports) override {
        if (iteration.loop != loop_)
            return;
        auto const pixel = static_cast<std::uint64_t>(iteration.number);
        std::uint64_t const col = pixel % cols_;
        ports.read(line_buffer_, col);
        ports.read(line_buffer_, cols_ + col);
        ports.write(line_buffer_, (pixel / cols_ % 2) * cols_ + col);
    }

  private:
    std::uint64_t cols_;
    std::size_t line_buffer_;  // number of the memory
    std::size_t loop_;
};

}  // namespace convolution
