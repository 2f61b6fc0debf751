#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/json.hpp"

namespace dataflow::io {

/// A value of a JSON file that knows its place in it, for messages: "FILE: 12[3].cam_R_m2c = FOUND, expected EXPECTED".
/// Every function throws InputError if the value is not what is asked for. Keeps a reference to the value.
class JsonNode {
  public:
    JsonNode(std::filesystem::path const& file, Json const& value)
        : JsonNode(std::make_shared<std::string const>(file.string()), "", value) {}

    JsonNode at(std::string const& key) const;
    std::optional<JsonNode> find(std::string const& key) const;
    std::vector<JsonNode> items() const;                            ///< of an array
    std::vector<std::pair<std::string, JsonNode>> members() const;  ///< of an object
    std::vector<std::pair<int, JsonNode>> numbered() const;         ///< those whose keys are integers from 0

    Json const& value() const { return *value_; }
    int integer(int min) const;  ///< 2.0 is one, too
    std::uint64_t unsigned_integer(std::uint64_t min, std::uint64_t max) const;
    double number() const;
    double number_above_zero() const;
    std::vector<double> numbers(std::size_t count) const;  ///< an array of them, or of arrays of them: rows
    std::string text() const;

    [[noreturn]] void fail(std::string const& expected) const;

  private:
    using File = std::shared_ptr<std::string const>;  ///< of all nodes

    JsonNode(File file, std::string name, Json const& value);
    void require_object() const;
    JsonNode member(std::string const& key, Json const& value) const;
    [[noreturn]] void complain(std::string const& what, char const* after_name) const;

    File file_;
    std::string name_;
    Json const* value_;
};

}  // namespace dataflow::io
