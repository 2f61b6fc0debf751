#pragma once
#include <filesystem>
#include <map>
#include <string>

#include "dataflow/run/config/key.hpp"

namespace dataflow::sweeps {

/// Hashes (FNV-1a, 16 hexadecimal digits) by which points are known, wherever and whenever they are worked out.
struct PointIdentity {
    /// Of everything that decides about its result.
    std::string point;
    /// Of everything that is not is_retimable(): points that share it do the same in another time.
    std::string function;
};

/// Works identities out. Files and folders that keys name count by their content, not by their name; each is read
/// once. What decides no figure does not count.
class Identifier {
  public:
    /// Throws InputError for a file that is not there.
    PointIdentity identity(RunConfig const& config);

  private:
    std::string text_of(Key const& key, RunConfig const& config);
    std::string object(std::string const& name);
    std::string const& content(std::filesystem::path const& path);

    std::map<std::filesystem::path, std::string> contents_;
};

}  // namespace dataflow::sweeps
