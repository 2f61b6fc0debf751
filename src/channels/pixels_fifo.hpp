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

    /// Binds an end that takes either token, or one that takes pixels.
    template <template <class> class Port> void bind(PixelsPort<Port, Pixel, Group>& end) {
        if (groups_ != nullptr)
            end.groups(*groups_);
        else
            end.pixels(*pixels_);
    }
    void bind(sc_core::sc_fifo_in<Pixel>& in) { in(*pixels_); }
    void bind(sc_core::sc_fifo_out<Pixel>& out) { out(*pixels_); }
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
