#include "dataflow/tools/report/provenance.hpp"

#include <fmt/format.h>

#include "dataflow/base/markup_text.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/run/config/resolved_config.hpp"

namespace dataflow::report {

namespace {

Json text_or_null(std::string const& text) { return text.empty() ? Json() : Json(text); }

std::string shown(std::string const& text) { return markup_escaped(printable(text)); }

std::string command_of(MadeBy const& maker) {
    return maker.command.empty() ? "" : program_name() + " " + maker.command;
}

}  // namespace

Json made_by_json(std::vector<ResolvedKey> const& keys) {
    MadeBy const& maker = made_by();
    return {{"program", program_name()},
            {"version", text_or_null(maker.version)},
            {"commit", text_or_null(maker.commit)},
            {"commit_date", text_or_null(maker.commit_date)},
            {"command", text_or_null(command_of(maker))},
            {"configuration", configuration_hash(keys)}};
}

std::string made_by_html(std::string const& configuration_hash, MadeBy const& maker) {
    std::string line = shown("Made by " + program_name() + " " + maker.version);
    if (maker.commit.empty())
        line += ", commit not known";
    else
        line += shown(fmt::format(", commit {} of {}", maker.commit, maker.commit_date));
    if (!maker.command.empty())
        line += "<br><code>" + shown(command_of(maker)) + "</code>";
    if (!configuration_hash.empty())
        line += "<br>configuration " + shown(configuration_hash);
    return line;
}

}  // namespace dataflow::report
