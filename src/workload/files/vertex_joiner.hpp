#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <unordered_map>
#include <vector>

#include "common/mesh.hpp"

namespace faster::io {

/// Gives equal points equal indices, in order of first appearance. Only exactly equal points are joined: any tolerance
/// would collapse meshes of small scale.
class VertexJoiner {
  public:
    /// Appends each new point to `vertices`, which must be empty and outlive the joiner.
    explicit VertexJoiner(std::vector<Eigen::Vector3d>& vertices) : vertices_(vertices) {}

    std::uint32_t index_of(Eigen::Vector3d const& point) {
        Eigen::Vector3d const key = point + Eigen::Vector3d::Zero();  // -0 becomes 0: equal, but of other bits
        auto const [entry, is_new] = indices_.try_emplace(key, static_cast<std::uint32_t>(vertices_.size()));
        if (is_new) {
            vertices_.push_back(point);
        }
        return entry->second;
    }

  private:
    struct Hash {
        std::size_t operator()(Eigen::Vector3d const& point) const {
            std::uint64_t hash = 0;
            for (double const coordinate : {point.x(), point.y(), point.z()}) {
                std::uint64_t bits = 0;
                std::memcpy(&bits, &coordinate, sizeof bits);
                hash = (hash ^ bits) * 0x9E3779B97F4A7C15U;
                hash ^= hash >> 32;
            }
            return static_cast<std::size_t>(hash);
        }
    };

    std::vector<Eigen::Vector3d>& vertices_;
    std::unordered_map<Eigen::Vector3d, std::uint32_t, Hash> indices_;
};

}  // namespace faster::io
