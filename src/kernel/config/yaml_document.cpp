#include "kernel/config/yaml_document.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <sstream>
#include <yaml-cpp/eventhandler.h>

#include "kernel/base/input_error.hpp"
#include "kernel/config/plain_text.hpp"

namespace faster {
namespace {

/// Sees where a document starts, and drops the rest.
class StartObserver : public YAML::EventHandler {
  public:
    YAML::Mark const& start() const { return start_; }

    void OnDocumentStart(YAML::Mark const& mark) override { start_ = mark; }
    void OnDocumentEnd() override {}
    void OnNull(YAML::Mark const&, YAML::anchor_t) override {}
    void OnAlias(YAML::Mark const&, YAML::anchor_t) override {}
    void OnScalar(YAML::Mark const&, std::string const&, YAML::anchor_t, std::string const&) override {}
    void OnSequenceStart(YAML::Mark const&, std::string const&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
    void OnSequenceEnd() override {}
    void OnMapStart(YAML::Mark const&, std::string const&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
    void OnMapEnd() override {}

  private:
    YAML::Mark start_;
};

/// Not by YAML::LoadAll: on text that starts with a comma it makes empty documents for ever (yaml-cpp 0.7). YAML::Load
/// alone would silently ignore all after the first document.
void require_one_document(std::string const& text) {
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    StartObserver observer;
    if (parser.HandleNextDocument(observer) && parser.HandleNextDocument(observer)) {
        throw YAML::ParserException(observer.start(), "a second document");
    }
}

[[noreturn]] void fail(std::filesystem::path const& path, std::string const& what) {
    throw InputError(path.string() + ": " + what);
}

[[noreturn]] void fail(std::filesystem::path const& path, std::ptrdiff_t line, std::string const& what) {
    throw InputError(fmt::format("{}:{}: {}", path.string(), line, what));
}

std::string read_text(std::filesystem::path const& path) {
    std::error_code ignored;
    auto const status = std::filesystem::status(path, ignored);
    if (!std::filesystem::exists(status)) {
        fail(path, "no such file, expected a configuration file");
    }
    if (std::filesystem::is_directory(status)) {
        fail(path, "is a folder, expected a configuration file");
    }
    std::ifstream stream(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream) {
        fail(path, "cannot be read, expected a readable file");
    }
    return text;
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

YAML::Node load_document(std::filesystem::path const& path) {
    std::string const text = read_text(path);
    require_text(path, text);
    try {
        return parse_document(text);
    } catch (YAML::Exception const& error) {
        fail(path, error.mark.line + 1, shortened(error.msg) + ", expected well-formed YAML, one document");
    }
}

}  // namespace faster
