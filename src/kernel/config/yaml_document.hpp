#pragma once
#include <filesystem>
#include <string>
#include <yaml-cpp/yaml.h>

namespace faster {

/// The only YAML document of `text`; a null node if there is none. Throws YAML::Exception, also for a second document.
YAML::Node parse_document(std::string const& text);

/// The one document of a YAML file; a null node if the file is empty. Throws InputError for what is no readable file of
/// UTF-8 text, no YAML, or several documents.
YAML::Node load_document(std::filesystem::path const& path);

}  // namespace faster
