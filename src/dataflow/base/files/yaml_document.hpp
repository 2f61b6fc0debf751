#pragma once
#include <filesystem>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

namespace dataflow {

/// The only YAML document of `text`; a null node if there is none. Where a map has a key `<<`, it has the entries of
/// the map that stands there, or of a list of maps, instead: of two with one name the map's own counts, then that of
/// the first in the list. Throws YAML::Exception, also for a second document, and for one that is nested or repeated by
/// aliases beyond any use.
YAML::Node parse_document(std::string const& text);

/// The one document of a YAML file; a null node if the file is empty. Throws InputError for what is no readable file of
/// UTF-8 text, too large, no YAML, or several documents; `expected` says what
/// it should have been.
///
/// If its `keys` are told, those that only hold something for aliases are left out: keys that begin with `x-` or `.`,
/// and others whose value has an anchor, unless they look like one of `keys` with a slip.
YAML::Node load_document(std::filesystem::path const& path, std::string const& expected = "a configuration file",
                         std::vector<std::string> const& keys = {});

/// The text as a value of a map that is read back as the same text: as it stands if that will do on a line of its own
/// and in a map in braces, else in quotes.
std::string yaml_value(std::string const& text);

}  // namespace dataflow
