#pragma once
#include <filesystem>
#include <string>
#include <yaml-cpp/yaml.h>

namespace dataflow {

/// The only YAML document of `text`; a null node if there is none. Throws YAML::Exception, also for a second document,
/// and for one that is nested or repeated by aliases beyond any use.
YAML::Node parse_document(std::string const& text);

/// The one document of a YAML file; a null node if the file is empty. Throws InputError for what is no readable file of
/// UTF-8 text, too large, no YAML, or several documents; `expected` says what
/// it should have been.
YAML::Node load_document(std::filesystem::path const& path, std::string const& expected = "a configuration file");

}  // namespace dataflow
