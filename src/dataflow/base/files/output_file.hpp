#pragma once
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <string>
#include <string_view>

namespace dataflow::io {

/// Something like a pipe, which is written to at once.
bool is_device(std::filesystem::path const& file);

/// A file that appears complete or not at all: it is written under a hidden name beside it, which is then renamed. The
/// constructor finds out whether it can be written, before the work whose output would be lost, and leaves nothing
/// behind; commit() writes it.
///
/// The target may be missing (parents are made by commit()) or a regular file, which is replaced. Anything else, and a
/// place that cannot be written, is an InputError.
class OutputFile {
  public:
    explicit OutputFile(std::filesystem::path const& target);
    void commit(std::string_view content) const;
    /// Commits content that is too long to be held: `write` puts it, bit by bit. The stream throws what stops it.
    void commit(std::function<void(std::ostream&)> const& write) const;

  private:
    std::filesystem::path target_;       // as given
    std::filesystem::path destination_;  // absolute, symbolic links resolved
};

/// For an option that need not be given: null if it is empty.
inline std::unique_ptr<OutputFile> optional_output_file(std::string const& target) {
    return target.empty() ? nullptr : std::make_unique<OutputFile>(target);
}

inline void write_file_atomically(std::filesystem::path const& path, std::string_view content) {
    OutputFile(path).commit(content);
}

}  // namespace dataflow::io
