#pragma once
#include <catch2/catch.hpp>
#include <httplib.h>
#include <nlohmann/json.hpp>
#include <string>

#include "support/explore_process.hpp"

namespace faster::test {

/// What the process answers to that body, sent as the page sends it; empty where it does not answer.
inline httplib::Result post_to(ExploreProcess const& process, std::string const& path, std::string const& body) {
    return httplib::Client("127.0.0.1", process.port()).Post(path, body, "application/json");
}

/// The answer to one question of the page, which must come with that status.
inline nlohmann::ordered_json ask(ExploreProcess const& process, std::string const& question,
                                  nlohmann::ordered_json const& request, int status = 200) {
    httplib::Result const result = post_to(process, process.home() + question, request.dump());
    REQUIRE(result);
    CAPTURE(result->body);
    CHECK(result->status == status);
    return nlohmann::ordered_json::parse(result->body);
}

}  // namespace faster::test
