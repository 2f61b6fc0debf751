#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "common/stimulus.hpp"

namespace faster {

/// What samples.csv says about one sample.
struct SampleFigures {
    std::int64_t core = 0;
    std::int64_t latency_cycles = 0;
    std::int64_t inlier = 0;
    std::int64_t valid_edge = 0;
    std::int64_t edge_inlier = 0;
};

/// The results of an older run, as `faster-sim run --out DIR --images K` left them. All functions throw InputError: on
/// what is missing, with the command that would make it.
class RunFolder {
  public:
    /// Requires the folder and pictures in it.
    explicit RunFolder(std::filesystem::path folder);

    SampleMaps maps(std::size_t sample) const;
    SampleFigures figures(std::size_t sample) const;
    /// Fractional bits of the depth buffer's codes.
    int depth_fraction_bits() const;

  private:
    std::size_t samples() const;
    std::size_t pictured_samples() const;
    void require_pictures_of(std::size_t sample) const;
    std::filesystem::path picture(std::size_t sample, std::string const& content) const;
    std::string how_to_make(std::size_t images) const;

    std::filesystem::path folder_;
    std::filesystem::path images_;
};

}  // namespace faster
