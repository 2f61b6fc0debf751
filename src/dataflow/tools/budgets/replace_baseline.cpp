#include "dataflow/tools/budgets/replace_baseline.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "dataflow/base/files/yaml_document.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/text_lines.hpp"
#include "dataflow/tools/budgets/baseline_reader.hpp"
#include "dataflow/tools/budgets/baseline_text.hpp"

namespace dataflow::budgets {

namespace {

using Lines = std::vector<std::string>;

bool has_return(std::string const& line) { return !line.empty() && line.back() == '\r'; }

/// Without line feeds, but with carriage returns before them; a last line that ends is followed by no empty one, one
/// that does not ends like the first.
Lines lines_of(std::string const& text) {
    Lines lines;
    for (std::size_t start = 0; start < text.size();) {
        std::size_t const end = std::min(text.find('\n', start), text.size());
        lines.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    if (!lines.empty() && text.back() != '\n' && has_return(lines.front()) && !has_return(lines.back()))
        lines.back() += '\r';
    return lines;
}

/// With carriage returns at the ends of all lines, or of none.
Lines with_returns(Lines lines, bool has_returns) {
    for (std::string& line : lines) {
        if (has_return(line))
            line.pop_back();
        line += has_returns ? "\r" : "";
    }
    return lines;
}

/// Where the comment of a line starts, quoted text skipped; npos if it has none.
std::size_t comment_start(std::string const& line) {
    char quote = '\0';
    for (std::size_t i = 0; i < line.size(); ++i) {
        char const letter = line[i];
        if (quote == '"' && letter == '\\')
            ++i;
        else if (quote != '\0')
            quote = letter == quote ? '\0' : quote;
        else if (letter == '"' || letter == '\'')
            quote = letter;
        else if (letter == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t'))
            return i;
    }
    return std::string::npos;
}

std::string key_of(std::string const& line) {
    std::string const text(trimmed(line));
    std::size_t const colon = std::min(text.find(": "), text.size());
    std::string const key = text.substr(0, colon);
    return !key.empty() && key.back() == ':' ? key.substr(0, key.size() - 1) : key;
}

/// Lines of the old block that are not ours.
class Comments {
  public:
    explicit Comments(Lines const& block) {
        Lines pending;
        for (std::string const& line : block) {
            std::size_t const start = comment_start(line);
            if (start != std::string::npos && trimmed(line.substr(0, start)).empty()) {
                pending.push_back(line);
            } else if (!trimmed(line).empty()) {
                if (start != std::string::npos)
                    beside_[key_of(line.substr(0, start))] = line.substr(start);
                above_[key_of(line)] = pending;
                pending.clear();
            }
        }
        last_ = pending;
    }

    /// The new block with the comments in their places; those whose place is gone come last.
    Lines merged_into(Lines const& block) {
        Lines merged;
        for (std::string const& line : block) {
            std::string const key = key_of(line);
            take(above_, key, merged);
            auto const beside = beside_.find(key);
            merged.push_back(beside == beside_.end() ? line : line + "  " + beside->second);
            if (beside != beside_.end())
                beside_.erase(beside);
        }
        for (auto const& [key, lines] : above_)
            merged.insert(merged.end(), lines.begin(), lines.end());
        for (auto const& [key, comment] : beside_)
            merged.push_back("  " + comment);
        merged.insert(merged.end(), last_.begin(), last_.end());
        return merged;
    }

  private:
    static void take(std::map<std::string, Lines>& from, std::string const& key, Lines& to) {
        auto const found = from.find(key);
        if (found == from.end())
            return;
        to.insert(to.end(), found->second.begin(), found->second.end());
        from.erase(found);
    }

    std::map<std::string, Lines> above_;
    std::map<std::string, std::string> beside_;
    Lines last_;
};

/// Lines [first, last) of the old block; both the number of lines if there is none.
struct Block {
    std::size_t first = 0;
    std::size_t last = 0;
};

/// What follows the last figure, up to the next key, belongs to that key.
bool is_after_block(std::string const& line) {
    return trimmed(line).empty() || line.front() == '#' || line.rfind("...", 0) == 0;
}

Block block_in(Lines const& lines, YAML::Node const& root) {
    Block block{lines.size(), lines.size()};
    bool found = false;
    for (auto const& pair : root) {
        auto const line = static_cast<std::size_t>(pair.first.Mark().line);
        if (pair.first.Scalar() == "baseline") {
            block.first = line;
            found = true;
        } else if (found) {
            block.last = std::min(block.last, line);
        }
    }
    while (found && block.last > block.first + 1 && is_after_block(lines[block.last - 1]))
        --block.last;
    return block;
}

std::string joined(Lines const& lines) {
    std::string text;
    for (std::string const& line : lines)
        text += line + "\n";
    return text;
}

/// The document without its baseline, as text to compare.
std::string all_but_baseline(YAML::Node const& root) {
    std::string text;
    for (auto const& pair : root)
        if (pair.first.Scalar() != "baseline")
            text += pair.first.Scalar() + ": " + YAML::Dump(pair.second) + "\n";
    return text;
}

bool holds(YAML::Node const& root, Baseline const& baseline) {
    KeyFaults faults;
    Baseline const read = read_baseline(root["baseline"], 0, faults);
    return faults.empty() && is_same_run(read, baseline) && read.reason == baseline.reason &&
           read.date == baseline.date;
}

[[noreturn]] void refuse(std::string const& file, int line) {
    throw InputError(
        fmt::format("{}:{}: the baseline cannot be replaced without touching something else, expected "
                    "the block `baseline:` at the begin of a line, and its figures indented below it",
                    file, line));
}

}  // namespace

std::string replace_baseline(std::string const& text, Baseline const& baseline, std::string const& file) {
    YAML::Node const before = parse_document(text);
    Lines lines = lines_of(text);
    Block const block = block_in(lines, before);
    auto const first = lines.begin() + static_cast<std::ptrdiff_t>(block.first);
    auto const last = lines.begin() + static_cast<std::ptrdiff_t>(block.last);
    bool const is_new = block.first == lines.size();
    bool const has_returns = !lines.empty() && has_return(is_new ? lines.front() : *first);
    Comments comments(with_returns(Lines(first, last), false));
    Lines merged = with_returns(comments.merged_into(lines_of(baseline_block(baseline))), has_returns);
    if (is_new)
        merged.insert(merged.begin(), has_returns ? "\r" : "");
    lines.insert(lines.erase(first, last), merged.begin(), merged.end());
    std::string changed = joined(lines);
    try {
        YAML::Node const after = parse_document(changed);
        if (all_but_baseline(after) == all_but_baseline(before) && holds(after, baseline))
            return changed;
    } catch (YAML::Exception const&) {
        refuse(file, static_cast<int>(block.first) + 1);
    }
    refuse(file, static_cast<int>(block.first) + 1);
}

}  // namespace dataflow::budgets
