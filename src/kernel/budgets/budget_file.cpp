#include "kernel/budgets/budget_file.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "kernel/base/files/yaml_document.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/base/nearest_name.hpp"
#include "kernel/base/printable.hpp"
#include "kernel/base/program_name.hpp"
#include "kernel/budgets/baseline_reader.hpp"
#include "kernel/budgets/figure_pattern.hpp"
#include "kernel/budgets/limit_reader.hpp"
#include "kernel/config/config_sources.hpp"
#include "kernel/config/key_faults.hpp"
#include "kernel/config/keys.hpp"
#include "kernel/config/plain_text.hpp"
#include "kernel/config/value_reader.hpp"

namespace faster::budgets {

namespace {

constexpr std::array<char const*, 8> budget_keys{"format", "version", "configuration", "set",
                                                 "trace",  "limits",  "time_limit_s",  "baseline"};
constexpr double longest_time_limit_s = 86400;

class BudgetReader {
  public:
    BudgetReader(std::filesystem::path const& file, BaselineNeed need) : need_(need) { budget_.file = file; }

    Budget read(YAML::Node const& root) {
        if (!root.IsMap())
            fail(1, "", root, "a budget: a map with " + fmt::format("{}", fmt::join(budget_keys, ", ")));
        for (MapEntry const& entry : read_entries(root, "", faults_))
            read_entry(entry);
        check_completeness();
        check_references();
        std::stable_sort(faults_.begin(), faults_.end(),
                         [](KeyFault const& a, KeyFault const& b) { return a.line < b.line; });
        std::vector<std::string> messages;
        for (KeyFault const& fault : faults_)
            messages.push_back(fmt::format("{}:{}: {}", budget_.file.string(), fault.line, fault.text()));
        throw_first(messages);
        return budget_;
    }

  private:
    [[noreturn]] void fail(int line, std::string const& key, YAML::Node const& found, std::string const& expected) {
        throw InputError(fmt::format("{}:{}: {}{}, expected {}", budget_.file.string(), line,
                                     key.empty() ? "" : key + " = ", shown(found), expected));
    }
    void reject(MapEntry const& entry, std::string const& expected) {
        faults_.push_back({entry.line, entry.name, shown(entry.value), "expected " + expected});
    }

    void read_entry(MapEntry const& entry) {
        given_.push_back(entry.name);
        if (entry.name == "format")
            require_word(entry, "faster-budget");
        else if (entry.name == "version")
            require_word(entry, "1");
        else if (entry.name == "configuration")
            read_path(entry, budget_.configuration);
        else if (entry.name == "trace")
            read_path(entry, budget_.trace);
        else if (entry.name == "set")
            read_overrides(entry);
        else if (entry.name == "time_limit_s")
            read_time_limit(entry);
        else if (entry.name == "limits")
            read_all_limits(entry);
        else if (entry.name == "baseline")
            budget_.baseline = read_baseline(entry.value, entry.line, faults_);
        else
            faults_.push_back({entry.line, shortened(entry.name), std::nullopt,
                               fmt::format("unknown key, expected one of {}{}", fmt::join(budget_keys, ", "),
                                           did_you_mean(entry.name, budget_keys))});
    }

    void require_word(MapEntry const& entry, std::string const& word) {
        if (!entry.value.IsScalar() || entry.value.Scalar() != word)
            reject(entry, word);
    }

    void read_path(MapEntry const& entry, std::string& path) {
        if (!entry.value.IsScalar() || entry.value.Scalar().empty())
            reject(entry, "a path, relative to the budget's folder");
        else
            path = entry.value.Scalar();
    }

    void read_time_limit(MapEntry const& entry) {
        auto const seconds = entry.value.IsScalar() ? parse_number(entry.value.Scalar()) : std::nullopt;
        if (!seconds || *seconds <= 0 || *seconds > longest_time_limit_s)
            reject(entry, fmt::format("seconds, above 0 and up to {:g}", longest_time_limit_s));
        else
            budget_.time_limit_s = *seconds;
    }

    void read_overrides(MapEntry const& set) {
        if (!set.value.IsMap())
            return reject(set, "a map of dotted keys, e.g. {" + example_key() + ": 1}");
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
            return reject(entry, "a map from figures to limits, at least one");
        budget_.limits = read_limits(entry.value, faults_);
    }

    bool is_given(char const* key) const { return std::find(given_.begin(), given_.end(), key) != given_.end(); }

    void check_completeness() {
        for (char const* const required : {"format", "version", "configuration", "limits"})
            if (!is_given(required))
                faults_.push_back({1, required, std::nullopt, "missing, expected one"});
        if (need_ == BaselineNeed::required && !is_given("baseline"))
            faults_.push_back({1, "baseline", std::nullopt,
                               fmt::format("missing, expected one; {} check {} --update --reason TEXT writes it",
                                           program_name(), budget_.file.string())});
    }

    /// A limit that refers to figures of one name needs just that figure in the baseline.
    void check_references() {
        if (need_ == BaselineNeed::optional || !budget_.baseline)
            return;
        for (Limit const& limit : budget_.limits) {
            FigurePattern const pattern(limit.figure);
            auto const& all = budget_.baseline->figures.all();
            bool const found =
                std::any_of(all.begin(), all.end(), [&](Figure const& figure) { return pattern.matches(figure.name); });
            if (limit.needs_baseline() && !found)
                faults_.push_back({limit.line, "limits." + limit.figure, std::nullopt,
                                   "no such figure in the baseline, expected one; --update --reason TEXT writes it"});
        }
    }

    BaselineNeed need_;
    Budget budget_;
    KeyFaults faults_;
    std::vector<std::string> given_;
};

}  // namespace

Budget read_budget(std::filesystem::path const& file, BaselineNeed need) {
    return BudgetReader(file, need).read(load_document(file, "a budget file"));
}

}  // namespace faster::budgets
