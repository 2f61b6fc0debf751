#include "dataflow/tools/sweeps/journal.hpp"

#include "dataflow/base/files/durable_file.hpp"
#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/tools/sweeps/journal_rows.hpp"

namespace dataflow::sweeps {

namespace {

std::string row_of(std::string const& id, PointResult const& result) {
    return journal_row({{"point", id}, {"result", to_json(result)}});
}

JournalContent without(JournalContent content, bool (*unwanted)(PointResult const&)) {
    for (auto row = content.results.begin(); row != content.results.end();)
        row = unwanted(row->second) ? content.results.erase(row) : std::next(row);
    return content;
}

JournalContent cleaned(std::filesystem::path const& path, bool (*unwanted)(PointResult const&)) {
    JournalContent const content = read_journal(path);
    JournalContent wanted = without(content, unwanted);
    if (content.damaged > 0 || wanted.results.size() != content.results.size())
        io::write_file_durably(path, journal_text(wanted.results));
    return wanted;
}

}  // namespace

JournalContent read_journal(std::filesystem::path const& path) {
    JournalContent content;
    if (!std::filesystem::exists(path))
        return content;
    content.damaged = read_journal_rows(io::read_file(path), [&](Json const& row) {
        content.results[row.at("point").get<std::string>()] = result_from_json(row.at("result"));
    });
    return content;
}

std::string journal_text(Results const& results) {
    std::string text;
    for (auto const& [id, result] : results)
        text += row_of(id, result);
    return text;
}

Journal::Journal(std::filesystem::path const& path, bool (*unwanted)(PointResult const&))
    : content_(cleaned(path, unwanted)), file_(path) {}

void Journal::append(std::vector<std::pair<std::string, PointResult>> const& rows) {
    std::string text;
    for (auto const& [id, result] : rows)
        text += row_of(id, result);
    file_.append(text);
    note(rows);
}

void Journal::note(std::vector<std::pair<std::string, PointResult>> const& rows) {
    for (auto const& [id, result] : rows)
        content_.results[id] = result;
}

}  // namespace dataflow::sweeps
