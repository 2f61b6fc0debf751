#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "faster/data/mesh.hpp"

namespace faster::files {

/// Vertices and polygons as they stand in a mesh file, from which a mesh is made.
class MeshBuilder {
  public:
    /// Where in the file something stands, for messages.
    using SayWhere = std::function<std::string()>;

    /// A vertex, kept in single precision. Throws InputError if a coordinate is not finite there.
    void add_vertex(Eigen::Vector3d const& vertex, SayWhere const& place);

    std::size_t vertices() const { return vertices_.size(); }
    std::size_t polygons() const { return ends_.size(); }

    /// Adds a polygon of corners that are or will be vertices. One of less than three has no area and is left out.
    void add_polygon(std::vector<std::uint32_t> const& corners);

    /// The triangles of all polygons in their order. Vertices of equal position are joined, those of no triangle
    /// dropped. Triangles begin with the corner that the file has first; of a polygon of more than four corners none
    /// begins where the one before begins.
    Mesh mesh() const;

  private:
    std::vector<Eigen::Vector3f> vertices_;
    std::vector<std::uint32_t> corners_;  ///< of all polygons
    std::vector<std::size_t> ends_;       ///< of each polygon in corners_
};

}  // namespace faster::files
