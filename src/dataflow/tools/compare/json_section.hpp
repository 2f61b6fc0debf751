#pragma once
#include <cstdint>
#include <string>

#include "dataflow/base/json.hpp"

namespace dataflow::runs {

/// The largest figure a run may have: 2^53 - 1, which every JSON reader keeps exactly. A sum over the at most 1024
/// cores fits into 63 bits, so sums and differences do not overflow.
constexpr std::uint64_t largest_figure = (std::uint64_t{1} << 53U) - 1;

/// One object of a JSON file: hands out its values, and knows how to complain about them (InputError). Keeps a
/// reference to the object.
class JsonSection {
  public:
    /// `name` is how messages call the object, e.g. "modules[3]"; empty for the whole file.
    JsonSection(std::string file, std::string name, Json const& object);

    Json const& at(std::string const& key) const;
    Json const& array_at(std::string const& key) const;
    JsonSection section(std::string const& key) const { return {file_, path_of(key), at(key)}; }
    /// The i-th row of a table, `rows` being array_at(key).
    JsonSection row(std::string const& key, Json const& rows, std::size_t i) const;
    std::uint64_t integer(std::string const& key, std::uint64_t min = 0, std::uint64_t max = largest_figure) const;
    double number(std::string const& key) const;
    std::string text(std::string const& key) const;
    Json const& object() const { return object_; }

    /// "FILE: NAME.KEY = FOUND, expected EXPECTED".
    [[noreturn]] void fail(std::string const& key, std::string const& expected) const;

  private:
    std::string path_of(std::string const& key) const { return name_.empty() ? key : name_ + "." + key; }

    std::string file_;
    std::string name_;
    Json const& object_;
};

}  // namespace dataflow::runs
