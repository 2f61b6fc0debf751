#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "poses/bop/dataset.hpp"

namespace faster::poses {

/// The depth images of what is judged: which of them VSD and AR go without, and what looks like a mistake.
class DepthImages {
  public:
    explicit DepthImages(std::vector<bop::DatasetImage const*> const& images)
        : images_(images), sizes_(images.size()) {}

    /// Lines for images that are not there, and for the unit of the first that is.
    void tell_of_missing(std::vector<std::string>& warnings) const;

    /// An image has been read; may be called by several threads, once for each image.
    void set_size(std::size_t image, Camera const& size) { sizes_[image] = {size.width, size.height}; }

    /// A line if one camera took images of several sizes.
    void tell_of_sizes(std::vector<std::string>& warnings) const;

  private:
    struct Size {
        int width = 0, height = 0;  ///< 0: not read
    };

    std::vector<bop::DatasetImage const*> images_;
    std::vector<Size> sizes_;
};

}  // namespace faster::poses
