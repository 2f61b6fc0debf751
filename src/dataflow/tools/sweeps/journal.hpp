#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/files/append_file.hpp"
#include "dataflow/tools/sweeps/point_result.hpp"

namespace dataflow::sweeps {

/// Results by the hash of their point (PointIdentity::point).
using Results = std::map<std::string, PointResult>;

/// What a journal's file holds.
struct JournalContent {
    Results results;
    std::size_t damaged = 0;  ///< rows whose checksum is wrong, or that are cut off: as if they had never been written
};

/// Of a file that is not there: nothing.
JournalContent read_journal(std::filesystem::path const& path);

/// The journal as text, a row per result, ordered by hash.
std::string journal_text(Results const& results);

/// The results of a sweep as they come: a row each, with a checksum. A row that append() has taken is on the disk.
class Journal {
  public:
    /// Damaged rows, and those of `unwanted` results, are taken out of the file. Throws InputError if it cannot be
    /// written.
    explicit Journal(
        std::filesystem::path const& path,
        bool (*unwanted)(PointResult const&) = [](PointResult const&) { return false; });

    Results const& results() const { return content_.results; }
    std::size_t damaged() const { return content_.damaged; }
    /// Points that have no row yet. All rows or none, unless the system fails in between.
    void append(std::vector<std::pair<std::string, PointResult>> const& rows);

    /// Results that hold for now only: a repeat of the sweep asks again.
    void note(std::vector<std::pair<std::string, PointResult>> const& rows);

  private:
    JournalContent content_;
    io::AppendFile file_;
};

}  // namespace dataflow::sweeps
