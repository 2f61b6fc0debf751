#pragma once
#include "faster/data/camera.hpp"
#include "faster/data/image.hpp"
#include "faster/data/mesh.hpp"
#include "poses/grip/edge_features.hpp"

namespace faster::grip {

/// An object as a depth camera would see it alone: the part of the image that its box covers.
struct RenderedObject {
    int first_row = 0;  ///< of the image
    int first_col = 0;
    Image<double> depth;  ///< z [m]; 0 where it is not seen
};

/// Renders the triangles of a mesh from either side, as a graphics card does: where a pixel's centre lies in a
/// triangle, its ray meets the triangle's plane. The nearest counts. Triangles with a corner nearer than `nearest_m`,
/// and pixels outside the image, are left out.
RenderedObject render(Mesh const& mesh, Pose const& pose, Camera const& camera, double nearest_m = 0.1);

/// Eq. 2.2 for an object that stands alone before a plane at depth `background` [m], which makes up for the neighbours
/// that it does not cover. The same as Curvature of the whole cloud, by sums that slide over the image.
Image<Feature> features(RenderedObject const& object, Camera const& camera, int neighbourhood, double threshold,
                        double background);

}  // namespace faster::grip
