#include "dataflow/base/files/yaml_document.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <sstream>
#include <vector>
#include <yaml-cpp/eventhandler.h>

#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
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

    void OnDocumentStart(YAML::Mark const& mark) override { start_ = mark; }
    void OnDocumentEnd() override {}
    void OnNull(YAML::Mark const& mark, YAML::anchor_t anchor) override { add_value(mark, anchor, 1); }
    void OnScalar(YAML::Mark const& mark, std::string const&, YAML::anchor_t anchor, std::string const&) override {
        add_value(mark, anchor, 1);
    }
    void OnAlias(YAML::Mark const& mark, YAML::anchor_t anchor) override {
        auto const found = values_of_.find(anchor);
        if (found == values_of_.end())
            throw YAML::ParserException(mark, "an alias inside of what it stands for");
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
    void open(YAML::Mark const& mark, YAML::anchor_t anchor) {
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
};

/// Not by YAML::LoadAll: on text that starts with a comma it makes empty documents for ever (yaml-cpp 0.7). YAML::Load
/// alone would silently ignore all after the first document.
void require_one_document(std::string const& text) {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    DocumentObserver observer;
    if (parser.HandleNextDocument(observer) && parser.HandleNextDocument(observer)) {
        throw YAML::ParserException(observer.start(), "a second document");
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

}  // namespace

YAML::Node parse_document(std::string const& text) {
    require_one_document(text);
    return YAML::Load(text);
}

YAML::Node load_document(std::filesystem::path const& path, std::string const& expected) {
    std::string const text = io::read_file(path, expected, most_yaml_bytes);
    require_text(path, text);
    try {
        return parse_document(text);
    } catch (YAML::Exception const& error) {
        fail(path, error.mark.line + 1, shortened(error.msg) + ", expected well-formed YAML, one document");
    }
}

}  // namespace dataflow
