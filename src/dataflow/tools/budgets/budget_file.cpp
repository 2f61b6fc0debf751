#include "dataflow/tools/budgets/budget_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <vector>
#include <yaml-cpp/yaml.h>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/entry_faults.hpp"
#include "dataflow/run/config/key_faults.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/plain_text.hpp"
#include "dataflow/run/config/value_reader.hpp"
#include "dataflow/tools/budgets/baseline_reader.hpp"
#include "dataflow/tools/budgets/budget.hpp"
#include "dataflow/tools/budgets/figure_pattern.hpp"
#include "dataflow/tools/budgets/figures.hpp"

namespace dataflow::budgets {

namespace {

constexpr double largest_count = 9007199254740991;  // 2^53 - 1, as in summary.json

std::string const unit_help = "a whole number up to 9007199254740991, a time like 1.5 ms or 200 us, or baseline";

bool is_plain(YAML::Node const& node) { return node.IsScalar() && (node.Tag().empty() || node.Tag() == "?"); }

/// summary.json has this beside total_cycles; it is the same figure in another unit.
bool is_in_milliseconds(std::string const& figure) { return figure == "milliseconds"; }

/// Reads the limit of one figure.
class LimitReader {
  public:
    LimitReader(MapEntry const& entry, KeyFaults& faults)
        : entry_(entry), name_("limits." + entry.name), faults_(faults) {
        limit_.figure = is_in_milliseconds(entry.name) ? "total_cycles" : entry.name;
        limit_.line = entry.line;
    }

    std::optional<Limit> read() {
        std::size_t const faults_before = faults_.size();
        names_ = possible_names(limit_.figure);
        if (names_.empty())
            reject(FigurePattern(limit_.figure).has_wildcard() ? "matches no figure" + did_you_mean_figure(entry_.name)
                                                               : "unknown figure" + did_you_mean_figure(entry_.name));
        else if (!entry_.value.IsMap() || entry_.value.size() == 0)
            reject_value(entry_.line, name_, entry_.value, "a map with max, min, exact or within");
        else
            read_bounds();
        if (faults_.size() == faults_before)
            check_sense();
        return faults_.size() == faults_before ? std::optional(limit_) : std::nullopt;
    }

  private:
    void reject(std::string const& problem) { faults_.push_back({entry_.line, name_, std::nullopt, problem}); }
    void reject_value(int line, std::string const& key, YAML::Node const& value, std::string const& expected) {
        faults_.push_back({line, key, shown(value), "expected " + expected});
    }

    void read_bounds() {
        for (MapEntry const& bound : read_entries(entry_.value, name_ + '.', faults_)) {
            if (bound.name == "max")
                limit_.max = quantity(bound);
            else if (bound.name == "min")
                limit_.min = quantity(bound);
            else if (bound.name == "exact")
                limit_.exact = quantity(bound);
            else if (bound.name == "within")
                read_within(bound);
            else if (bound.name == "slack")
                read_percent(bound, "slack", limit_.slack);
            else
                faults_.push_back({bound.line, name_ + '.' + bound.name, std::nullopt,
                                   "unknown limit, expected max, min, slack, exact or within"});
        }
    }

    void read_within(MapEntry const& within) {
        if (!within.value.IsMap())
            return reject_value(within.line, name_ + ".within", within.value, "a map {of, percent}");
        bool has_percent = false;
        for (MapEntry const& part : read_entries(within.value, name_ + ".within.", faults_)) {
            if (part.name == "of") {
                limit_.of = quantity(part);
            } else if (part.name == "percent") {
                has_percent = true;
                read_percent(part, "within.percent", limit_.percent);
            } else {
                faults_.push_back(
                    {part.line, name_ + ".within." + part.name, std::nullopt, "unknown key, expected of and percent"});
            }
        }
        if (!limit_.of || !has_percent)
            faults_.push_back({within.line, name_ + ".within", std::nullopt, "expected both of and percent"});
    }

    void read_percent(MapEntry const& part, std::string const& key, double& percent) {
        auto const value = is_plain(part.value) ? parse_number(part.value.Scalar()) : std::nullopt;
        if (!value || *value < 0 || *value > 100)
            return reject_value(part.line, name_ + '.' + key, part.value, "a number from 0 to 100");
        percent = *value;
    }

    std::optional<Quantity> quantity(MapEntry const& bound) {
        std::optional<Quantity> quantity;
        if (is_plain(bound.value))
            quantity = parse(bound.value.Scalar());
        if (!quantity)
            reject_value(bound.line, name_ + '.' + bound.name, bound.value,
                         is_in_milliseconds(entry_.name) ? "milliseconds, e.g. 1.5" : unit_help);
        else if (quantity->kind == Quantity::Kind::microseconds)
            require_cycles(bound);
        return quantity;
    }

    std::optional<Quantity> parse(std::string const& text) const {
        if (text == "baseline")
            return Quantity{Quantity::Kind::baseline, 0, text};
        if (is_in_milliseconds(entry_.name) && text.find(' ') == std::string::npos)
            return time(text + " ms");
        auto const count = parse_integer(text);
        if (count && *count >= 0 && static_cast<double>(*count) <= largest_count)
            return Quantity{Quantity::Kind::count, static_cast<double>(*count), text};
        return time(text);
    }

    static std::optional<Quantity> time(std::string const& text) {
        std::size_t const blank = text.find(' ');
        if (blank == std::string::npos)
            return std::nullopt;
        std::string const unit = text.substr(blank + 1);
        auto const number = parse_number(text.substr(0, blank));
        if (!number || *number < 0 || *number > largest_count || (unit != "ms" && unit != "us"))
            return std::nullopt;
        return Quantity{Quantity::Kind::microseconds, unit == "ms" ? *number * 1000 : *number, text};
    }

    void require_cycles(MapEntry const& bound) {
        auto const other = std::find_if_not(names_.begin(), names_.end(), is_in_cycles);
        if (other != names_.end())
            reject_value(bound.line, name_ + '.' + bound.name, bound.value,
                         fmt::format("a number without a unit of time ({} does not count cycles)", *other));
    }

    /// Limits that no figure can keep, as far as one entry tells.
    void check_sense() {
        int const kinds = (limit_.exact ? 1 : 0) + (limit_.of ? 1 : 0) + (limit_.min || limit_.max ? 1 : 0);
        if (kinds != 1)
            return reject("contradictory limits, expected exact, or within, or min and max");
        if (limit_.slack > 0 && !limit_.min && !limit_.max)
            return reject("slack is of min or max, expected one of them beside it");
        bool const comparable = limit_.min && limit_.max && limit_.min->kind == limit_.max->kind;
        if (comparable && limit_.min->value > limit_.max->value)
            reject(fmt::format("contradictory limits: min {} is above max {}", limit_.min->text, limit_.max->text));
    }

    MapEntry const& entry_;
    std::string name_;
    KeyFaults& faults_;
    Limit limit_;
    std::vector<std::string> names_;
};

/// The map `limits` of a budget file. What is wrong with an entry is added to `faults`, and the entry left out.
std::vector<Limit> read_limits(YAML::Node const& limits, KeyFaults& faults) {
    std::vector<Limit> read;
    for (MapEntry const& entry : read_entries(limits, "limits.", faults))
        if (auto limit = LimitReader(entry, faults).read())
            read.push_back(std::move(*limit));
    return read;
}

constexpr double longest_time_limit_s = 86400;

class BudgetReader {
  public:
    BudgetReader(std::filesystem::path const& file, BaselineNeed need) : need_(need) { budget_.file = file; }

    Budget read() {
        read_top(
            budget_.file, "a budget", "faster-budget",
            {{"configuration", [this](MapEntry const& entry) { read_path(entry, budget_.configuration); }},
             {"set", [this](MapEntry const& entry) { read_overrides(entry); }},
             {"trace", [this](MapEntry const& entry) { read_path(entry, budget_.trace); }},
             {"limits", [this](MapEntry const& entry) { read_all_limits(entry); }},
             {"time_limit_s", [this](MapEntry const& entry) { read_time_limit(entry); }},
             {"baseline",
              [this](MapEntry const& entry) { budget_.baseline = read_baseline(entry.value, entry.line, faults_); }}},
            {"configuration", "limits"}, faults_);
        check_references();
        throw_first_of(faults_, budget_.file.string());
        require_baseline();
        return budget_;
    }

  private:
    void read_path(MapEntry const& entry, std::string& path) {
        if (!entry.value.IsScalar() || entry.value.Scalar().empty())
            reject(faults_, entry, "a path, relative to the budget's folder");
        else
            path = entry.value.Scalar();
    }

    void read_time_limit(MapEntry const& entry) {
        auto const seconds = entry.value.IsScalar() ? parse_number(entry.value.Scalar()) : std::nullopt;
        if (!seconds || *seconds <= 0 || *seconds > longest_time_limit_s)
            reject(faults_, entry, fmt::format("seconds, above 0 and up to {:g}", longest_time_limit_s));
        else
            budget_.time_limit_s = *seconds;
    }

    void read_overrides(MapEntry const& set) {
        if (!set.value.IsMap())
            return reject(faults_, set, "a map of dotted keys, e.g. {" + example_key() + ": 1}");
        for (MapEntry const& entry : read_entries(set.value, "set.", faults_))
            read_override(entry);
    }

    /// Tried on a configuration of its own, for the sake of the line number; values may contradict the file's later on.
    void read_override(MapEntry const& entry) {
        std::string const setting = entry.name + "=" + override_text(entry.value);
        LoadedConfig scratch;
        std::string const place = "--set " + shortened(setting) + ": ";
        for (std::string complaint : apply_override(setting, scratch)) {
            if (complaint.rfind(place, 0) == 0)
                complaint.erase(0, place.size());
            faults_.push_back({entry.line, "set." + shortened(setting), std::nullopt, complaint});
        }
        budget_.overrides.push_back(setting);
    }

    static std::string override_text(YAML::Node const& value) {
        if (value.IsScalar())
            return value.Scalar();
        YAML::Emitter emitter;
        emitter.SetMapFormat(YAML::Flow);
        emitter.SetSeqFormat(YAML::Flow);
        emitter << value;
        return emitter.c_str();
    }

    void read_all_limits(MapEntry const& entry) {
        if (!entry.value.IsMap() || entry.value.size() == 0)
            return reject(faults_, entry, "a map from figures to limits, at least one");
        budget_.limits = read_limits(entry.value, faults_);
    }

    /// The last fault of all: --update, which writes it, is of use once the others are mended.
    void require_baseline() {
        if (need_ == BaselineNeed::required && !budget_.baseline)
            throw InputError(
                fmt::format("{0}:1: baseline: missing, expected one; {1} check {0} --update --reason TEXT writes it",
                            budget_.file.string(), program_name()));
    }

    /// A limit that refers to figures of one name needs just that figure in the baseline.
    void check_references() {
        if (need_ == BaselineNeed::optional || !budget_.baseline)
            return;
        for (Limit const& limit : budget_.limits)
            if (limit.needs_baseline() && !FigurePattern(limit.figure).matches_any(budget_.baseline->figures))
                faults_.push_back({limit.line, "limits." + limit.figure, std::nullopt,
                                   "no such figure in the baseline, expected one; --update --reason TEXT writes it"});
    }

    BaselineNeed need_;
    Budget budget_;
    KeyFaults faults_;
};

}  // namespace

Budget read_budget(std::filesystem::path const& file, BaselineNeed need) { return BudgetReader(file, need).read(); }

}  // namespace dataflow::budgets
