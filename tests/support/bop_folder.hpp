#pragma once
#include <filesystem>
#include <string>

#include "faster/data/camera.hpp"
#include "faster/data/mesh.hpp"
#include "faster/dataflow_names.hpp"
#include "support/temp_folder.hpp"

namespace faster::test {

/// A small dataset in the format of BOP, made here from nothing: scenes 1 and 2 with images 0 and 3 each, in which a
/// box (object 1, turned into itself by half a turn about z) and a cylinder (object 5, by any turn about z) stand side
/// by side; depth images of 64 x 48 pixels at 0.1 mm per count; the box is half hidden in image 3. The files are
/// written digit by digit here, and share nothing with what reads them.
class BopFolder {
  public:
    BopFolder();

    std::filesystem::path const& path() const { return folder_.path(); }
    std::filesystem::path operator/(std::string const& name) const { return folder_.path() / name; }

    /// Replaces `from` in a file of the dataset, which must hold it.
    void replace(std::string const& file, std::string const& from, std::string const& to) const;
    void write(std::string const& file, std::string const& content) const;
    /// Annotates another cylinder in image 0 of scene 1, before all others, 0.3 m left of the one that is there.
    void add_cylinder(double visible_share) const;

    static constexpr int box = 1;
    static constexpr int cylinder = 5;
    static constexpr double depth_unit_m = 1e-4;
    static Camera camera() { return {64, 48, 60, 61, 31.5, 23.5}; }
    static Mesh mesh_of(int obj_id);             ///< [m]
    static Pose pose_of(int obj_id, int im_id);  ///< the same in both scenes [m]

  private:
    TempFolder folder_;
};

}  // namespace faster::test
