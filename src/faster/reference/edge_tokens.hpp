#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "faster/reference/rasterize.hpp"

namespace faster::reference {

/// Which pixels of a scan become edge tokens. Each class has
///   begin(pixel, weights)                 the scan of a triangle starts there
///   visit(pixel, weights, inside, sink)   it looks at a pixel; tells `sink` object(Pixel) and edge(Pixel)

/// Thesis 5.2 and A.1: covered pixels are objects; a pixel outside just before or just behind one is an edge. The one
/// before is sent by the next visit, so it is lost if the triangle ends.
class TransitionTokens {
  public:
    void begin(Pixel pixel, PixelWeights const& weights) {
        // Neither is reset at a new line: the zig-zag goes on where it is.
        previous_ = pixel;
        previous_inside_ = weights.inside();
        edge_pending_ = false;
    }

    template <class Sink> void visit(Pixel pixel, PixelWeights const& /*weights*/, bool inside, Sink& sink) {
        if (edge_pending_) {  // A.1 spends an iteration on this
            sink.edge(pending_edge_);
            edge_pending_ = false;
        }
        if (inside) {
            sink.object(pixel);
            edge_pending_ = !previous_inside_;
            pending_edge_ = previous_;
        } else if (previous_inside_) {
            sink.edge(pixel);
        }
        previous_ = pixel;
        previous_inside_ = inside;
    }

  private:
    Pixel previous_;
    bool previous_inside_ = false;
    bool edge_pending_ = false;
    Pixel pending_edge_;
};

/// None: nothing but fragments.
class NoTokens {
  public:
    void begin(Pixel /*pixel*/, PixelWeights const& /*weights*/) {}
    template <class Sink>
    void visit(Pixel /*pixel*/, PixelWeights const& /*weights*/, bool /*inside*/, Sink& /*sink*/) {}
};

/// Thesis 5.1: a pixel is an edge if one of its weights is close to zero and none further below.
class NearEdgeTokens {
  public:
    /// `thresholds`: of w0, w1, w2 [px^2]
    NearEdgeTokens(std::array<double, 3> const& thresholds, int xy_fraction_bits) {
        for (std::size_t i = 0; i < limits_.size(); ++i) {
            limits_[i] = std::ldexp(thresholds[i], 2 * xy_fraction_bits);
        }
    }

    void begin(Pixel /*pixel*/, PixelWeights const& /*weights*/) {}

    template <class Sink> void visit(Pixel pixel, PixelWeights const& weights, bool /*inside*/, Sink& sink) {
        bool is_close = false;
        for (std::size_t i = 0; i < limits_.size(); ++i) {
            auto const value = static_cast<double>(weights.value(i));  // exact: below 2^53
            if (value < -limits_[i]) {
                return;
            }
            is_close = is_close || std::abs(value) <= limits_[i];
        }
        if (is_close) {
            sink.edge(pixel);
        }
    }

  private:
    std::array<double, 3> limits_{};
};

}  // namespace faster::reference
