#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "dataflow/base/files/hold.hpp"
#include "dataflow/base/held_signals.hpp"

namespace dataflow::io {

/// A hidden file or folder beside `target`, in which something is written until it is whole. Folders that `target`
/// lacks are made. The destructor removes what then has the hidden name, and the folders that were made if they are
/// empty. Until then signals that would end the program are held back. If there is a target already, who may read and
/// write it may do so here, and nobody else.
///
/// What processes that were killed have left of the same target is removed as well; what is of a living one is not.
class Scratch {
  public:
    enum class Kind { file, folder };

    /// `target`: absolute. Throws std::filesystem::filesystem_error if it cannot be made.
    Scratch(std::filesystem::path const& target, Kind kind);
    ~Scratch() { remove(); }
    Scratch(Scratch const&) = delete;
    Scratch& operator=(Scratch const&) = delete;

    std::filesystem::path const& path() const { return path_; }
    std::filesystem::path const& target() const { return target_; }
    /// A file that is written, and closed, becomes the target. Throws std::filesystem::filesystem_error.
    void replace_target() const;

  private:
    void make(Kind kind);
    void make_parents(std::filesystem::path const& folder);
    void hold();
    void remove();

    processes::HeldSignals held_;  // first, so that they come through last
    std::filesystem::path target_;
    std::vector<std::filesystem::path> made_parents_;
    std::filesystem::path path_;
    std::optional<Hold> hold_;
};

}  // namespace dataflow::io
