#include "dataflow/tools/explore/answers.hpp"

#include <fmt/format.h>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/tools/explore/page.hpp"
#include "dataflow/tools/report/html/fill_page.hpp"
#include "dataflow/tools/report/provenance.hpp"

namespace dataflow::explore {

namespace {

constexpr char const* json_type = "application/json";
constexpr std::size_t most_overrides = 1000;

[[noreturn]] void fail(char const* name, Json const& found, char const* expected) {
    throw InputError(fmt::format("{} = {}, expected {}", name, io::shown(found), expected));
}

std::string text_in(Json const& request, char const* name) {
    Json const value = request.value(name, Json());
    if (!value.is_string())
        fail(name, value, "a text");
    return value;
}

Overrides overrides_in(Json const& request) {
    Json const list = request.value("set", Json::array());
    if (!list.is_array() || list.size() > most_overrides)
        fail("set", list, "a list of at most 1000 settings");
    Overrides overrides;
    for (Json const& setting : list) {
        if (!setting.is_string())
            fail("set", setting, "KEY=VALUE");
        overrides.push_back(setting);
    }
    return overrides;
}

/// A whole number; 0 if it is not there.
std::uint64_t number_in(Json const& request, char const* name) {
    Json const value = request.value(name, Json(0));
    if (!value.is_number_unsigned() && !(value.is_number_integer() && value.get<std::int64_t>() >= 0))
        fail(name, value, "a whole number");
    return value;
}

double percent_in(Json const& request) {
    Json const value = request.value("within", Json());
    if (!value.is_number() || value.get<double>() < 0 || value.get<double>() > 1e6)
        fail("within", value, "a number from 0 to 1000000");
    return value;
}

Json parsed(std::string const& request) {
    try {
        Json object = io::parse_json(request);
        if (object.is_object())
            return object;
    } catch (Json::exception const&) {
    }
    throw InputError("a request that is no JSON object, expected one");
}

}  // namespace

Answer failure(std::exception_ptr const& error) {
    std::string what = "unexpected error";
    try {
        std::rethrow_exception(error);
    } catch (std::exception const& known) {
        what += std::string(": ") + known.what();
    } catch (...) {
    }
    return {500, json_type, io::text_of({{"error", what}})};
}

Answer Answers::page() const {
    return {200, "text/html; charset=utf-8",
            report::filled_page(explore_page, exploration_.title(), report::made_by_html(""),
                                io::text_of(exploration_.design()))};
}

Answer Answers::ask(std::string_view question, std::string const& request) {
    try {
        return {200, json_type, io::text_of(answer(question, parsed(request)))};
    } catch (InputError const& error) {
        return {400, json_type, io::text_of({{"error", error.what()}})};
    }
}

Json Answers::answer(std::string_view question, Json const& request) {
    if (question == "retime")
        return exploration_.retimed(overrides_in(request));
    if (question == "path")
        return exploration_.critical_path(overrides_in(request));
    if (question == "timeline")
        return exploration_.timeline(overrides_in(request), number_in(request, "sample"), number_in(request, "from"),
                                     number_in(request, "to"));
    if (question == "start")
        return start(request);
    if (question != "state" && question != "cancel")
        throw InputError(
            fmt::format("unknown question {}, expected one of retime, path, timeline, start, state, cancel", question));
    Numbered const asked = job(text_in(request, "job"));
    if (question == "cancel" && asked.job)
        asked.job->cancel();
    return state_of(asked);
}

Json Answers::state_of(Numbered const& job) {
    Json state = job.job ? job.job->state() : Json{{"state", "none"}};
    state["number"] = job.number;
    return state;
}

Answers::Numbered Answers::job(std::string const& name) {
    std::lock_guard<std::mutex> const lock(mutex_);
    auto const found = jobs_.find(name);
    return found == jobs_.end() ? Numbered{} : found->second;
}

Job::Work Answers::work_of(std::string const& job, Json const& request) const {
    if (job == "sensitivities")
        return exploration_.sensitivities(overrides_in(request));
    if (job == "sizing")
        return exploration_.sizing(overrides_in(request), percent_in(request));
    fail("job", job, "sensitivities or sizing");
}

/// The last one of that name is told to stop, and waited for by whoever lets go of it last.
Json Answers::start(Json const& request) {
    std::string const name = text_in(request, "job");
    auto next = std::make_shared<Job>(work_of(name, request));
    std::lock_guard<std::mutex> const lock(mutex_);
    Numbered& place = jobs_[name];
    if (place.job)
        place.job->cancel();
    place.job.swap(next);
    ++place.number;
    return state_of(place);
}

}  // namespace dataflow::explore
