#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace dataflow::sweeps {

/// What a sweep is: sweep.json in its folder (docs/formats.md). Says which points there are, so that results can be put
/// together without the sweep file.
struct Manifest {
    struct Point {
        std::string id;                   ///< PointIdentity::point; points that are the same have the same
        std::vector<std::string> values;  ///< by column
    };
    std::string sweep;    ///< name of the sweep file, without its folder
    std::string version;  ///< of faster-sim: another may find other results
    std::vector<std::string> columns;
    std::vector<Point> points;

    std::string name(std::size_t point) const;
};

std::string to_text(Manifest const& manifest);
/// `file` is for messages. Throws InputError for what is no manifest.
Manifest manifest_from_text(std::string const& text, std::string const& file);

/// Whether `larger` has all points of `smaller`, and comes from the same faster-sim. Empty if so, else why not, for
/// people: "3 of its 12 points are not in grid.yaml, the first is point 4 (...)".
std::string why_no_part_of(Manifest const& smaller, Manifest const& larger);

}  // namespace dataflow::sweeps
