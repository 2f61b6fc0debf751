#include "dataflow/base/files/yaml_document.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>
#include <yaml-cpp/eventhandler.h>

#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/json.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/utf8.hpp"

namespace dataflow {
namespace {

constexpr std::size_t most_yaml_bytes = std::size_t{4}
                                        << 20U;  ///< of a file; yaml-cpp takes a hundred times as much memory
constexpr std::size_t deepest = 32;              ///< of maps and lists in each other
constexpr std::size_t most_values = 1'000'000;   ///< aliases counted as what they stand for

/// Sees where a document starts, drops the rest, and gives up on one that is too deep or, with its aliases, too large.
class DocumentObserver : public YAML::EventHandler {
  public:
    YAML::Mark const& start() const { return start_; }
    /// Keys of the outermost map whose values have anchors.
    std::vector<std::string> const& anchored_keys() const { return anchored_keys_; }

    void OnDocumentStart(YAML::Mark const& mark) override { start_ = mark; }
    void OnDocumentEnd() override {}
    void OnNull(YAML::Mark const& mark, YAML::anchor_t anchor) override {
        see_outermost(anchor, "");
        add_value(mark, anchor, 1);
    }
    void OnScalar(YAML::Mark const& mark, std::string const&, YAML::anchor_t anchor,
                  std::string const& value) override {
        see_outermost(anchor, value);
        add_value(mark, anchor, 1);
    }
    void OnAlias(YAML::Mark const& mark, YAML::anchor_t anchor) override {
        auto const found = values_of_.find(anchor);
        if (found == values_of_.end())
            throw YAML::ParserException(mark, "an alias inside of what it stands for");
        see_outermost(0, "");
        add(mark, found->second);
    }
    void OnSequenceStart(YAML::Mark const& mark, std::string const&, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        open(mark, anchor);
    }
    void OnMapStart(YAML::Mark const& mark, std::string const&, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        open(mark, anchor);
    }
    void OnSequenceEnd() override { close(); }
    void OnMapEnd() override { close(); }

  private:
    struct Open {
        YAML::anchor_t anchor;
        std::size_t values_before;
    };

    void add(YAML::Mark const& mark, std::size_t values) {
        values_ += values;
        if (values_ > most_values)
            throw YAML::ParserException(
                mark, fmt::format("more than {} values, what aliases stand for included", most_values));
    }
    void add_value(YAML::Mark const& mark, YAML::anchor_t anchor, std::size_t values) {
        add(mark, values);
        values_of_[anchor] = values;
    }
    /// In the outermost map keys and values take turns.
    void see_outermost(YAML::anchor_t anchor, std::string const& scalar) {
        if (open_.size() != 1)
            return;
        if (outermost_seen_++ % 2 == 0)
            outermost_key_ = scalar;
        else if (anchor != 0)
            anchored_keys_.push_back(outermost_key_);
    }
    void open(YAML::Mark const& mark, YAML::anchor_t anchor) {
        see_outermost(anchor, "");
        if (open_.size() == deepest)
            throw YAML::ParserException(mark, fmt::format("maps and lists more than {} deep", deepest));
        open_.push_back({anchor, values_});
        add(mark, 1);
    }
    void close() {
        values_of_[open_.back().anchor] = values_ - open_.back().values_before;
        open_.pop_back();
    }

    YAML::Mark start_;
    std::size_t values_ = 0;
    std::vector<Open> open_;
    std::map<YAML::anchor_t, std::size_t> values_of_;  ///< by anchor; none is open any more
    std::size_t outermost_seen_ = 0;
    std::string outermost_key_;
    std::vector<std::string> anchored_keys_;
};

/// Not by YAML::LoadAll: on text that starts with a comma it makes empty documents for ever (yaml-cpp 0.7). YAML::Load
/// alone would silently ignore all after the first document.
std::vector<std::string> anchored_keys_of_one_document(std::string const& text) {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    DocumentObserver observer;
    if (!parser.HandleNextDocument(observer))
        return {};
    DocumentObserver second;
    if (parser.HandleNextDocument(second))
        throw YAML::ParserException(second.start(), "a second document");
    return observer.anchored_keys();
}

bool is_merge_key(YAML::Node const& key) {
    return key.IsScalar() && key.Scalar() == "<<" && (key.Tag() == "?" || key.Tag() == "tag:yaml.org,2002:merge");
}

using Entries = std::vector<std::pair<YAML::Node, YAML::Node>>;

bool has_key(Entries const& entries, YAML::Node const& key) {
    return key.IsScalar() && std::any_of(entries.begin(), entries.end(), [&](auto const& entry) {
               return entry.first.IsScalar() && entry.first.Scalar() == key.Scalar();
           });
}

void add_missing(YAML::Node const& map, YAML::Mark const& mark, Entries& entries) {
    if (!map.IsMap())
        throw YAML::ParserException(mark, "<< with something else than a map or a list of maps");
    Entries const before = entries;  // a key that stands twice in the map itself does so in what comes out, too
    for (auto const& entry : map)
        if (!has_key(before, entry.first))
            entries.emplace_back(entry.first, entry.second);
}

/// Own entries first, and of what is merged those that are missing.
Entries merged_entries(YAML::Node const& map) {
    Entries entries;
    std::vector<YAML::Node> merged;
    for (auto const& entry : map)
        if (is_merge_key(entry.first) && !merged.empty())
            throw YAML::ParserException(entry.first.Mark(), "a second << in a map, where one takes a list ([*a, *b])");
        else if (is_merge_key(entry.first))
            merged.push_back(entry.second);
        else
            entries.emplace_back(entry.first, entry.second);
    for (YAML::Node const& source : merged)
        if (source.IsSequence())
            for (auto const& one : source)
                add_missing(one, source.Mark(), entries);
        else
            add_missing(source, source.Mark(), entries);
    return entries;
}

/// What stands for a map with aliases is the map itself, so each is merged in its place; innermost ones first.
void merge_in_place(YAML::Node node) {
    if (node.IsSequence())
        for (YAML::Node item : node)
            merge_in_place(item);
    if (!node.IsMap())
        return;
    bool has_merge = false;
    for (auto const& entry : node) {
        merge_in_place(entry.second);
        has_merge = has_merge || is_merge_key(entry.first);
    }
    if (!has_merge)
        return;
    Entries const entries = merged_entries(node);
    while (node.size() > 0)
        node.remove(node.begin()->first);
    for (auto const& [key, value] : entries)
        node.force_insert(key, value);
}

bool begins_with(std::string const& text, std::string_view start) { return text.compare(0, start.size(), start) == 0; }

bool has(std::vector<std::string> const& list, std::string const& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

void leave_out_holders(YAML::Node root, std::vector<std::string> const& anchored,
                       std::vector<std::string> const& keys) {
    if (keys.empty() || !root.IsMap())
        return;
    std::vector<std::string> names;
    for (auto const& entry : root)
        if (entry.first.IsScalar())
            names.push_back(entry.first.Scalar());
    for (std::string const& name : names) {
        bool const holds = has(anchored, name) && did_you_mean(name, keys).empty();
        if (!has(keys, name) && (begins_with(name, "x-") || begins_with(name, ".") || holds))
            root.remove(name);
    }
}

[[noreturn]] void fail(std::filesystem::path const& path, std::ptrdiff_t line, std::string const& what) {
    throw InputError(fmt::format("{}:{}: {}", path.string(), line, what));
}

void require_text(std::filesystem::path const& path, std::string const& text) {
    if (auto const bad = first_bad_byte(text)) {
        auto const end = text.begin() + static_cast<std::ptrdiff_t>(*bad);
        auto const line = 1 + std::count(text.begin(), end, '\n');
        fail(path, line,
             fmt::format("byte 0x{:02X}, expected printable UTF-8 text", static_cast<unsigned char>(text[*bad])));
    }
}

/// Whether the document is a map with the one key `a`, whose value is the text.
bool is_same_value(std::string const& document, std::string const& text) {
    try {
        YAML::Node const root = parse_document(document);
        return root.IsMap() && root.size() == 1 && root["a"] && root["a"].IsScalar() && root["a"].Scalar() == text;
    } catch (YAML::Exception const&) {
        return false;
    }
}

}  // namespace

YAML::Node parse_document(std::string const& text) {
    anchored_keys_of_one_document(text);
    YAML::Node const root = YAML::Load(text);
    merge_in_place(root);
    return root;
}

std::string yaml_value(std::string const& text) {
    bool const will_do = is_same_value("a: " + text, text) && is_same_value("{a: " + text + "}", text);
    return will_do ? text : Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

YAML::Node load_document(std::filesystem::path const& path, std::string const& expected,
                         std::vector<std::string> const& keys) {
    std::string const text = io::read_file(path, expected, most_yaml_bytes);
    require_text(path, text);
    try {
        YAML::Node const root = parse_document(text);
        leave_out_holders(root, anchored_keys_of_one_document(text), keys);
        return root;
    } catch (YAML::Exception const& error) {
        fail(path, error.mark.line + 1, shortened(error.msg) + ", expected well-formed YAML, one document");
    }
}

}  // namespace dataflow
