#include "dataflow/base/files/hidden_name.hpp"

#include <algorithm>
#include <cctype>
#include <random>

namespace dataflow::io {
namespace {

bool is_number(std::string const& text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](unsigned char letter) { return std::isdigit(letter) != 0; });
}

std::string without_hiding(std::string const& name) {
    std::size_t const number = name.rfind('-');
    std::size_t const purpose = name.rfind(".partial-");
    bool const is_hidden =
        name.front() == '.' && purpose != std::string::npos && purpose > 1 && is_number(name.substr(number + 1));
    return is_hidden ? name.substr(1, purpose - 1) : name;
}

}  // namespace

std::filesystem::path hidden_name(std::filesystem::path const& file, std::string const& purpose) {
    std::random_device random;
    return file.parent_path() / ("." + file.filename().string() + "." + purpose + "-" + std::to_string(random()));
}

std::vector<std::filesystem::path> all_hidden_in(std::filesystem::path const& folder, std::string const& purpose) {
    std::vector<std::filesystem::path> found;
    std::error_code error;
    std::filesystem::directory_iterator entry(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        std::string const name = entry->path().filename().string();
        std::size_t const number = name.rfind("." + purpose + "-");
        if (name.front() == '.' && number != std::string::npos && is_number(name.substr(number + purpose.size() + 2)))
            found.push_back(entry->path());
    }
    return found;
}

std::vector<std::filesystem::path> all_hidden_beside(std::filesystem::path const& file, std::string const& purpose) {
    std::string const begin = "." + file.filename().string() + "." + purpose + "-";
    std::vector<std::filesystem::path> found;
    for (std::filesystem::path const& hidden : all_hidden_in(file.parent_path(), purpose)) {
        std::string const name = hidden.filename().string();
        if (name.rfind(begin, 0) == 0 && is_number(name.substr(begin.size())))
            found.push_back(hidden);
    }
    return found;
}

std::filesystem::path without_hidden_names(std::filesystem::path const& path) {
    std::filesystem::path known;
    for (std::filesystem::path const& part : path)
        known /= part.empty() ? part : std::filesystem::path(without_hiding(part.string()));
    return known;
}

}  // namespace dataflow::io
