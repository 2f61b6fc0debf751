#include "dataflow/tools/resources/unit_keys.hpp"

#include <sstream>
#include <stdexcept>

namespace dataflow {

std::map<std::string, std::string> unit_keys(std::string const& configuration) {
    std::map<std::string, std::string> keys;
    std::istringstream words(configuration == "default" ? "" : configuration);
    for (std::string word; words >> word;) {
        std::size_t const equals = word.find('=');
        if (equals == std::string::npos)
            throw std::invalid_argument("table of units: no KEY=VALUE: " + word);
        keys[word.substr(0, equals)] = word.substr(equals + 1);
    }
    return keys;
}

std::vector<std::string> csv_cells(std::string const& line) {
    std::istringstream rest(line);
    std::vector<std::string> cells;
    for (std::string cell; std::getline(rest, cell, ',');)
        cells.push_back(cell);
    return cells;
}

}  // namespace dataflow
