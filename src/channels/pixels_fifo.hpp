#pragma once
#include <memory>
#include <string>

#include "channels/port_binding.hpp"

namespace dataflow {

/// An end of a FIFO whose tokens are pixels one by one, or groups of pixels of a row: a port for either, of which one
/// is bound, or none.
template <template <class> class Port, class Pixel, class Group> struct PixelsPort {
    explicit PixelsPort(std::string const& name) : pixels(name.c_str()), groups((name + "_groups").c_str()) {}
    /// Null if unbound, as of a port.
    FifoChannel* channel() {
        if (groups.size() > 0)
            return channel_of(groups);
        return channel_of(pixels);
    }

    Port<Pixel> pixels;
    Port<Group> groups;
};
template <class Pixel, class Group> using PixelsIn = PixelsPort<OptionalFifoIn, Pixel, Group>;
template <class Pixel, class Group> using PixelsOut = PixelsPort<OptionalFifoOut, Pixel, Group>;

/// Such a FIFO: one clocked FIFO of either token.
template <class Pixel, class Group> class PixelsFifo {
  public:
    PixelsFifo(char const* name, timing::FifoTiming& timing, bool in_groups) {
        if (in_groups)
            groups_ = std::make_unique<ClockedFifo<Group>>(name, timing);
        else
            pixels_ = std::make_unique<ClockedFifo<Pixel>>(name, timing);
    }

    void bind(PixelsOut<Pixel, Group>& out, PixelsIn<Pixel, Group>& in) {
        if (groups_ != nullptr) {
            out.groups(*groups_);
            in.groups(*groups_);
        } else {
            out.pixels(*pixels_);
            in.pixels(*pixels_);
        }
    }
    FifoChannel& channel() {
        if (groups_ != nullptr)
            return *groups_;
        return *pixels_;
    }

  private:
    std::unique_ptr<ClockedFifo<Pixel>> pixels_;
    std::unique_ptr<ClockedFifo<Group>> groups_;
};

}  // namespace dataflow
