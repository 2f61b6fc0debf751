#pragma once
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "dataflow/tools/explore/exploration.hpp"

namespace dataflow::explore {

/// What is sent back for a request, as HTTP has it.
struct Answer {
    int status = 200;
    std::string type;
    std::string body;
};

/// For a request whose answer threw something unexpected.
Answer failure(std::exception_ptr const& error);

/// Answers what the page of an exploration asks, whatever brings the requests. May be asked by several threads at once.
class Answers {
  public:
    /// Which must outlive this.
    explicit Answers(Exploration& exploration) : exploration_(exploration) {}

    /// The page itself.
    Answer page() const;
    /// A question, a JSON object with `set`, a list of overrides, and what else the question takes. What is wrong with
    /// it is an answer of status 400 with the line that the tool would print as `error`.
    ///
    ///     retime         the figures
    ///     path           the critical path
    ///     timeline       of a `sample`, from cycle `from` to `to`; or all of it
    ///     start          begins a `job`: "sensitivities", or "sizing" `within` so many per cent; ends its last one
    ///     state, cancel  of a `job`, whose `number` tells it from others of its name
    Answer ask(std::string_view question, std::string const& request);

  private:
    struct Numbered {
        std::uint64_t number = 0;  ///< so that nobody takes another's for the one that was started
        std::shared_ptr<Job> job;
    };
    Json answer(std::string_view question, Json const& request);
    Json start(Json const& request);
    Job::Work work_of(std::string const& job, Json const& request) const;
    static Json state_of(Numbered const& job);
    Numbered job(std::string const& name);

    Exploration& exploration_;
    std::mutex mutex_;
    std::map<std::string, Numbered> jobs_;
};

}  // namespace dataflow::explore
