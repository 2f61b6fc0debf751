#include "dataflow/tools/budgets/baseline_reader.hpp"

#include <algorithm>
#include <ctime>
#include <fmt/chrono.h>
#include <iomanip>
#include <sstream>
#include <string_view>

#include "dataflow/run/config/plain_text.hpp"
#include "dataflow/run/config/value_reader.hpp"

namespace dataflow::budgets {

namespace {

constexpr char const* expected_keys = "expected date, reason, configuration, accelerator and figures";

/// A day of the calendar.
bool is_date(std::string const& text) {
    std::tm day{};
    std::istringstream(text) >> std::get_time(&day, "%Y-%m-%d");
    return fmt::format("{:%Y-%m-%d}", fmt::gmtime(timegm(&day))) == text;
}

bool is_hash(std::string_view text) {
    constexpr std::string_view begin = "fnv1a64:";
    return text.size() == begin.size() + 16 && text.substr(0, begin.size()) == begin &&
           text.find_first_not_of("0123456789abcdef", begin.size()) == text.npos;
}

class BaselineReader {
  public:
    explicit BaselineReader(KeyFaults& faults) : faults_(faults) {}

    Baseline read(YAML::Node const& node, int line) {
        if (!node.IsMap()) {
            faults_.push_back({line, "baseline", shown(node), expected_keys});
            return baseline_;
        }
        std::vector<std::string> given;
        for (MapEntry const& entry : read_entries(node, "baseline.", faults_)) {
            read_entry(entry);
            given.push_back(entry.name);
        }
        for (char const* const required : {"date", "reason", "configuration", "figures"})
            if (std::find(given.begin(), given.end(), required) == given.end())
                faults_.push_back(
                    {line, "baseline", std::nullopt, std::string("no key ") + required + ", expected one"});
        return baseline_;
    }

  private:
    void read_entry(MapEntry const& entry) {
        if (entry.name == "date")
            read_text(entry, baseline_.date, "a date, YYYY-MM-DD", is_date);
        else if (entry.name == "reason")
            read_text(entry, baseline_.reason, "text", [](auto const& text) { return !text.empty(); });
        else if (entry.name == "configuration")
            read_text(entry, baseline_.configuration, "fnv1a64: and 16 hexadecimal digits", is_hash);
        else if (entry.name == "accelerator")
            read_settings(entry);
        else if (entry.name == "figures")
            read_figures(entry);
        else
            faults_.push_back(
                {entry.line, "baseline." + entry.name, std::nullopt, std::string("unknown key, ") + expected_keys});
    }

    template <class Is>
    void read_text(MapEntry const& entry, std::string& text, std::string const& expected, Is const& is_sound) {
        if (!entry.value.IsScalar() || !is_sound(entry.value.Scalar()))
            faults_.push_back({entry.line, "baseline." + entry.name, shown(entry.value), "expected " + expected});
        else
            text = entry.value.Scalar();
    }

    void read_settings(MapEntry const& entry) {
        for (MapEntry const& setting : read_entries(entry.value, "baseline.accelerator.", faults_))
            if (setting.value.IsScalar())
                baseline_.accelerator.push_back({setting.name, setting.value.Scalar()});
            else
                faults_.push_back(
                    {setting.line, "baseline.accelerator." + setting.name, shown(setting.value), "expected a value"});
    }

    void read_figures(MapEntry const& entry) {
        if (!entry.value.IsMap()) {
            faults_.push_back({entry.line, "baseline.figures", shown(entry.value), "expected a map of figures"});
            return;
        }
        for (MapEntry const& row : read_entries(entry.value, "baseline.figures.", faults_)) {
            if (!row.value.IsMap()) {
                read_figure(row, row.name);
                continue;
            }
            for (MapEntry const& figure : read_entries(row.value, "baseline.figures." + row.name + ".", faults_))
                read_figure(figure, row.name + "." + figure.name);
        }
    }

    void read_figure(MapEntry const& entry, std::string const& name) {
        auto const value = entry.value.IsScalar() ? parse_integer(entry.value.Scalar()) : std::nullopt;
        if (!value || *value < 0)
            faults_.push_back({entry.line, "baseline.figures." + name, shown(entry.value), "expected a whole number"});
        else if (baseline_.figures.find(name))
            faults_.push_back({entry.line, "baseline.figures." + name, std::nullopt, "stands twice, expected once"});
        else
            baseline_.figures.set(name, static_cast<std::uint64_t>(*value));
    }

    KeyFaults& faults_;
    Baseline baseline_;
};

}  // namespace

Baseline read_baseline(YAML::Node const& node, int line, KeyFaults& faults) {
    return BaselineReader(faults).read(node, line);
}

}  // namespace dataflow::budgets
