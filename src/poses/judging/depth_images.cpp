#include "poses/judging/depth_images.hpp"

#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <map>

#include "faster/dataflow_names.hpp"
#include "poses/bop/read_dataset.hpp"

namespace faster::poses {

void DepthImages::tell_of_missing(std::vector<std::string>& warnings) const {
    std::size_t missing = 0;
    bop::DatasetImage const *first_missing = nullptr, *first = nullptr;
    for (bop::DatasetImage const* const image : images_) {
        std::error_code ignored;
        bool const is_there = std::filesystem::exists(image->depth, ignored);
        missing += is_there ? 0U : 1U;
        bop::DatasetImage const*& first_such = is_there ? first : first_missing;
        if (first_such == nullptr)
            first_such = image;
    }
    if (missing > 0)
        warnings.push_back(
            fmt::format("{}: no such file; {} of {} images have no depth image, so VSD and AR are not known",
                        first_missing->depth.string(), missing, images_.size()));
    if (first != nullptr)  // a camera's unit is that of all its images
        bop::tell_of_depths(bop::load_observation(*first), *first, warnings);
}

void DepthImages::tell_of_sizes(std::vector<std::string>& warnings) const {
    std::map<std::array<double, 4>, std::size_t> first_of;
    for (std::size_t i = 0; i < images_.size(); ++i) {
        if (sizes_[i].width == 0)
            continue;
        Camera const& camera = images_[i]->camera;
        std::size_t const first =
            first_of.try_emplace(std::array<double, 4>{camera.fx, camera.fy, camera.cx, camera.cy}, i).first->second;
        if (sizes_[i].width == sizes_[first].width && sizes_[i].height == sizes_[first].height)
            continue;
        warnings.push_back(fmt::format("{}: is {} x {} pixels, expected {} x {} as {} of the same camera",
                                       images_[i]->depth.string(), sizes_[i].width, sizes_[i].height,
                                       sizes_[first].width, sizes_[first].height, images_[first]->depth.string()));
        return;
    }
}

}  // namespace faster::poses
