#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"
#include "support/vcd_reader.hpp"

namespace faster::test {

using Words = std::vector<std::string>;

/// Runs of the tool on a trace, in a folder of their own, and what they wrote there.
class Waves {
  public:
    using Row = std::map<std::string, std::string>;

    /// `config`: a file of configs/.
    explicit Waves(std::string const& config = "faster_zcu102.yaml") : config_(sources() / "configs" / config) {}

    /// With two cores, unless `more` says otherwise.
    CommandResult run(std::string const& trace, Words const& more) const {
        Words arguments{"run",     config_.string(),
                        "--trace", (sources() / "traces" / trace).string(),
                        "--set",   "accelerator.raster_cores=2"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run_command(FASTER_SIM_BINARY, arguments, folder_.path());
    }
    std::vector<Row> table(std::string const& file) const {
        std::vector<std::string> const lines = lines_of(content_of(folder_ / file));
        Words const names = split(lines.at(0));
        std::vector<Row> rows;
        for (std::size_t i = 1; i < lines.size(); ++i) {
            Words const cells = split(lines[i]);
            rows.emplace_back();
            for (std::size_t k = 0; k < names.size(); ++k)
                rows.back()[names[k]] = cells.at(k);
        }
        return rows;
    }
    std::string text(std::string const& file) const { return content_of(folder_ / file); }
    Vcd vcd(std::string const& file) const { return read_vcd(folder_ / file, 5); }
    bool has(std::string const& file) const { return std::filesystem::exists(folder_ / file); }
    std::filesystem::path path() const { return folder_.path(); }

  private:
    static std::filesystem::path sources() { return FASTER_SOURCE_DIR; }
    static Words split(std::string const& line) {
        Words cells{""};
        for (char const letter : line)
            letter == ',' ? cells.emplace_back() : cells.back() += std::string(1, letter);
        return cells;
    }

    std::filesystem::path config_;
    TempFolder folder_;
};

}  // namespace faster::test
