#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/files/append_file.hpp"
#include "dataflow/base/files/durable_file.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/tools/sweeps/journal_rows.hpp"

namespace dataflow::sweeps {

// A result is of a point, an estimate, ...: a row of a journal has that one's hash under `Result::journal_key`, and the
// result as its to_json() and from_json() have it.

/// What a journal's file holds.
template <class Result> struct JournalContent {
    std::map<std::string, Result> results;  ///< by hash
    std::size_t damaged = 0;  ///< rows whose checksum is wrong, or that are cut off: as if they had never been written
};

/// Of a file that is not there: nothing.
template <class Result> JournalContent<Result> read_journal(std::filesystem::path const& path) {
    JournalContent<Result> content;
    if (!std::filesystem::exists(path))
        return content;
    content.damaged = read_journal_rows(io::read_file(path), [&](Json const& row) {
        content.results[row.at(Result::journal_key).template get<std::string>()] =
            row.at("result").template get<Result>();
    });
    return content;
}

/// Of pairs of hash and result, a row each.
template <class Pairs> std::string journal_text(Pairs const& results) {
    std::string text;
    for (auto const& [id, result] : results)
        text += journal_row({{Pairs::value_type::second_type::journal_key, id}, {"result", to_json(result)}});
    return text;
}

/// Results as they come: a row each, with a checksum. A row that append() has taken is on the disk.
template <class Result> class Journal {
  public:
    using Rows = std::vector<std::pair<std::string, Result>>;

    /// Damaged rows, and those of `unwanted` results, are taken out of the file. Throws InputError if it cannot be
    /// written.
    explicit Journal(
        std::filesystem::path const& path, bool (*unwanted)(Result const&) = [](Result const&) { return false; })
        : content_(cleaned(path, unwanted)), file_(path) {}

    std::map<std::string, Result> const& results() const { return content_.results; }
    /// Null if there is none.
    Result const* find(std::string const& id) const {
        auto const found = content_.results.find(id);
        return found == content_.results.end() ? nullptr : &found->second;
    }
    std::size_t damaged() const { return content_.damaged; }

    /// Results that have no row yet. All rows or none, unless the system fails in between.
    void append(Rows const& rows) {
        file_.append(journal_text(rows));
        note(rows);
    }

    /// Results that hold for now only: a repeat of the command asks again.
    void note(Rows const& rows) {
        for (auto const& [id, result] : rows)
            content_.results[id] = result;
    }

  private:
    static JournalContent<Result> cleaned(std::filesystem::path const& path, bool (*unwanted)(Result const&)) {
        JournalContent<Result> content = read_journal<Result>(path);
        std::size_t const rows = content.results.size();
        for (auto row = content.results.begin(); row != content.results.end();)
            row = unwanted(row->second) ? content.results.erase(row) : std::next(row);
        if (content.damaged > 0 || content.results.size() != rows)
            io::write_file_durably(path, journal_text(content.results));
        return content;
    }

    JournalContent<Result> content_;
    io::AppendFile file_;
};

}  // namespace dataflow::sweeps
