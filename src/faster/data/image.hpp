#pragma once
#include <cstddef>
#include <vector>

namespace faster {

/// A dense picture, row-major: `at(row, column)`, row 0 on top. No bounds checks: callers clip.
template <class Pixel> class Image {
  public:
    Image() = default;
    Image(int height, int width, Pixel fill = Pixel{})
        : height_(height),
          width_(width),
          pixels_(static_cast<std::size_t>(height) * static_cast<std::size_t>(width), fill) {}

    int height() const { return height_; }
    int width() const { return width_; }
    bool empty() const { return pixels_.empty(); }
    bool contains(int row, int column) const { return row >= 0 && row < height_ && column >= 0 && column < width_; }

    Pixel& at(int row, int column) { return pixels_[index(row, column)]; }
    Pixel const& at(int row, int column) const { return pixels_[index(row, column)]; }
    Pixel* row(int row_index) { return pixels_.data() + index(row_index, 0); }
    Pixel const* row(int row_index) const { return pixels_.data() + index(row_index, 0); }
    std::vector<Pixel>& pixels() { return pixels_; }
    std::vector<Pixel> const& pixels() const { return pixels_; }

    friend bool operator==(Image const& a, Image const& b) {
        return a.height_ == b.height_ && a.width_ == b.width_ && a.pixels_ == b.pixels_;
    }

  private:
    std::size_t index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
    }

    int height_ = 0;
    int width_ = 0;
    std::vector<Pixel> pixels_;
};

}  // namespace faster
