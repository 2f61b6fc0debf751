#include "kernel/sweeps/journal.hpp"

#include <fmt/format.h>
#include <string_view>

#include "kernel/base/files/durable_file.hpp"
#include "kernel/base/files/json_file.hpp"
#include "kernel/base/files/text_file.hpp"
#include "kernel/base/fnv1a.hpp"
#include "kernel/base/json.hpp"

namespace faster::sweeps {

namespace {

constexpr std::size_t checksum_letters = 16;

std::string checksum_of(std::string_view text) {
    Fnv1a hash;
    hash.add(text);
    return fmt::format("{:016x}", hash.value());
}

std::string row_of(std::string const& id, PointResult const& result) {
    Json const json{{"point", id}, {"result", to_json(result)}};
    std::string const text = io::text_of(json);
    return checksum_of(text) + " " + text + "\n";
}

bool is_whole(std::string_view row) {
    return row.size() > checksum_letters && row[checksum_letters] == ' ' &&
           row.substr(0, checksum_letters) == checksum_of(row.substr(checksum_letters + 1));
}

/// A row without its line end.
void read_row(std::string_view row, JournalContent& content) {
    try {
        if (is_whole(row)) {
            Json const json = io::parse_json(row.substr(checksum_letters + 1));
            content.results[json.at("point").get<std::string>()] = result_from_json(json.at("result"));
            return;
        }
    } catch (Json::exception const&) {  // of another version, as its checksum is right
    }
    ++content.damaged;
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
    std::string const text = io::read_file(path);
    std::string_view rest = text;
    while (!rest.empty()) {
        std::size_t const end = rest.find('\n');
        if (end == std::string_view::npos)
            ++content.damaged;
        else
            read_row(rest.substr(0, end), content);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
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
    for (auto const& [id, result] : rows)
        content_.results[id] = result;
}

}  // namespace faster::sweeps
