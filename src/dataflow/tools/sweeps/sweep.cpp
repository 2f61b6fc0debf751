#include "dataflow/tools/sweeps/sweep.hpp"

#include <fmt/format.h>

#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/load_config.hpp"

namespace dataflow::sweeps {

std::size_t Sweep::points() const {
    std::size_t count = 1;
    for (Dimension const& dimension : dimensions)
        count *= dimension.rows.size();
    return count;
}

std::vector<std::string> Sweep::columns() const {
    std::vector<std::string> all;
    for (Dimension const& dimension : dimensions)
        all.insert(all.end(), dimension.columns.begin(), dimension.columns.end());
    return all;
}

std::vector<Cell> Sweep::cells(std::size_t point) const {
    std::vector<Cell> all;
    std::size_t below = points();
    for (Dimension const& dimension : dimensions) {
        below /= dimension.rows.size();
        std::vector<Cell> const& row = dimension.rows[point / below % dimension.rows.size()];
        all.insert(all.end(), row.begin(), row.end());
    }
    return all;
}

std::vector<std::string> Sweep::values(std::size_t point) const {
    std::vector<std::string> texts;
    for (Cell const& cell : cells(point))
        texts.push_back(cell.text);
    return texts;
}

LoadedConfig Sweep::configuration(std::size_t point) const {
    std::vector<std::filesystem::path> files;
    if (!base.empty())
        files.push_back(base);
    std::vector<std::string> overrides = settings;
    for (Cell const& cell : cells(point)) {
        if (cell.setting.empty())
            files.push_back(cell.file);
        else
            overrides.push_back(cell.setting);
    }
    try {
        return layered_config(files, overrides);
    } catch (HostError const&) {
        throw;
    } catch (InputError const& error) {
        throw error_of(point, error);
    }
}

InputError Sweep::error_of(std::size_t point, InputError const& error) const {
    return InputError(fmt::format("{}: {}: {}", file, name_of_point(point, columns(), values(point)), error.what()));
}

std::string name_of_point(std::size_t point, std::vector<std::string> const& columns,
                          std::vector<std::string> const& values) {
    std::string text;
    for (std::size_t i = 0; i < columns.size(); ++i)
        text += fmt::format("{}{}={}", i == 0 ? "" : " ", columns[i], values[i]);
    return fmt::format("point {} ({})", point, text);
}

}  // namespace dataflow::sweeps
