#include <CLI/CLI.hpp>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <httplib.h>
#include <memory>
#include <poll.h>
#include <random>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/signal_watch.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/simulated_run.hpp"
#include "dataflow/commands/standard_commands.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/events/event_file_format.hpp"
#include "dataflow/tools/explore/answers.hpp"
#include "dataflow/tools/explore/exploration.hpp"
#include "dataflow/tools/report/text_report.hpp"

namespace dataflow {

namespace {

/// `explore`.
struct ExploreRequest {
    std::string input;                   ///< event file, or a configuration to be run first
    std::vector<std::string> overrides;  ///< KEY=VALUE, of that run
    int port = 0;                        ///< 0: any
    bool force = false;                  ///< however long the run takes, whatever memory there is
};

/// The page of an exploration over HTTP, for this host only and for who knows the token in its address.
class ExploreServer {
  public:
    /// Port 0: any that is free. Throws InputError if it cannot be had. The answers must outlive this.
    ExploreServer(explore::Answers& answers, int port);
    ~ExploreServer();
    ExploreServer(ExploreServer const&) = delete;
    ExploreServer& operator=(ExploreServer const&) = delete;

    int port() const;
    /// Where the page is.
    std::string address() const;
    /// Answers until SIGINT, SIGTERM or SIGHUP comes.
    void serve();

  private:
    class Http;
    std::unique_ptr<Http> http_;
};

constexpr char const* this_host = "127.0.0.1";
constexpr std::size_t most_bytes_of_request = std::size_t{1} << 17;
constexpr std::size_t connections = 16;  // a browser opens six

/// 128 bits that nobody can guess.
std::string random_token() {
    std::random_device device;
    std::string token;
    for (int i = 0; i < 4; ++i)
        token += fmt::format("{:08x}", device());
    return token;
}

void put(explore::Answer const& answer, httplib::Response& response) {
    response.status = answer.status;
    response.set_content(answer.body, answer.type);
}

void wait_for_signal(processes::SignalWatch& watch) {
    pollfd descriptor{watch.descriptor(), POLLIN, 0};
    while (poll(&descriptor, 1, -1) < 0 && errno == EINTR) {
    }
    watch.take();
}

class ExploreServer::Http {
  public:
    Http(explore::Answers& answers, int port) : answers_(answers), home_("/" + random_token() + "/") {
        server_.new_task_queue = [] { return new httplib::ThreadPool(connections); };
        server_.set_payload_max_length(most_bytes_of_request);
        server_.set_keep_alive_max_count(1000);
        server_.set_keep_alive_timeout(1);  // seconds: as long as an end has to wait for a connection
        server_.set_tcp_nodelay(true);
        server_.set_default_headers({{"Cache-Control", "no-store"},
                                     {"Referrer-Policy", "no-referrer"},  // the address has the token
                                     {"X-Content-Type-Options", "nosniff"}});
        // The library would share a port with others that do.
        server_.set_socket_options([](socket_t socket) {
            int const yes = 1;
            setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
        });
        server_.set_exception_handler([](httplib::Request const&, httplib::Response& response,
                                         std::exception_ptr const& error) { put(explore::failure(error), response); });
        server_.set_pre_routing_handler([this](httplib::Request const& request, httplib::Response& response) {
            if (request.path.compare(0, home_.size(), home_) == 0)
                return httplib::Server::HandlerResponse::Unhandled;
            put({403, "text/plain", "expected the address that was printed, with its token\n"}, response);
            return httplib::Server::HandlerResponse::Handled;
        });
        server_.Get(home_,
                    [this](httplib::Request const&, httplib::Response& response) { put(answers_.page(), response); });
        server_.Post(home_ + "([a-z]+)", [this](httplib::Request const& request, httplib::Response& response) {
            put(answers_.ask(request.matches[1].str(), request.body), response);
        });
        port_ = port == 0 ? server_.bind_to_any_port(this_host) : server_.bind_to_port(this_host, port) ? port : -1;
        if (port_ < 0)
            throw InputError(fmt::format("--port {}: cannot be listened on, expected a free port; 0 takes any", port));
    }

    int port() const { return port_; }
    std::string const& home() const { return home_; }

    void serve() {
        processes::SignalWatch watch;  // before the threads, which are not to get the signals
        std::atomic<bool> is_over{false};
        std::thread listener([&] {
            server_.listen_after_bind();
            is_over = true;
        });
        wait_for_signal(watch);
        while (!is_over) {  // stop() does nothing before the listener has begun
            server_.stop();
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        listener.join();
    }

  private:
    explore::Answers& answers_;
    std::string const home_;
    httplib::Server server_;
    int port_ = 0;
};

ExploreServer::ExploreServer(explore::Answers& answers, int port) : http_(std::make_unique<Http>(answers, port)) {}
ExploreServer::~ExploreServer() = default;

int ExploreServer::port() const { return http_->port(); }
std::string ExploreServer::address() const {
    return fmt::format("http://{}:{}{}", this_host, http_->port(), http_->home());
}
void ExploreServer::serve() { http_->serve(); }

struct Recorded {
    LoadedConfig loaded;
    replay::RecordedRun run;
};

bool is_event_file(std::string const& path) {
    std::string mark(events::opening_mark.size(), '\0');
    std::ifstream file(path, std::ios::binary);
    return file.read(mark.data(), static_cast<std::streamsize>(mark.size())) && mark == events::opening_mark;
}

Recorded read_recorded(ExploreRequest const& request) {
    if (!request.overrides.empty())
        throw InputError(request.input + ": --set " + request.overrides.front() +
                         ": expected no --set with an event file; the page has a control for each key");
    events::EventFile file = events::read_event_file(request.input);
    return {std::move(file.loaded), std::move(file.run)};
}

/// Nothing if it deadlocks, which has been said then.
std::unique_ptr<Recorded> record(ExploreRequest const& request) {
    auto recorded = std::make_unique<Recorded>();
    recorded->loaded = load_config(request.input, request.overrides);
    auto const workload = simulated_design().load_workload(recorded->loaded);
    announce(size_of_run(recorded->loaded.config, machine_of(recorded->loaded.config), *workload), request.force);
    ProgressLine progress("samples");
    SimulationOptions options;
    options.recorded = &recorded->run;
    options.at_any_size = request.force;
    options.progress = [&](std::uint64_t done) { progress.show(done, workload->samples()); };
    RunStatistics const run = simulate(recorded->loaded.config, *workload, options);
    if (!run.deadlocked())
        return recorded;
    warn("{}", report::deadlock_report(run));
    return nullptr;
}

explore::Exploration::Require require_room(ExploreRequest const& request) {
    if (request.force)
        return {};
    return [](replay::RecordedRun const& run, Machine const& machine) {
        require_memory(size_of_retimings("explore", run, machine, 1));
    };
}

std::string host_name() {
    char name[256] = "this host";
    gethostname(name, sizeof name - 1);
    return name;
}

/// Returns the exit code: exit_deadlock if the configuration deadlocks. Throws InputError on bad input.
int explore_run(ExploreRequest const& request) {
    std::unique_ptr<Recorded> recorded =
        is_event_file(request.input) ? std::make_unique<Recorded>(read_recorded(request)) : record(request);
    if (!recorded)
        return exit_deadlock;
    explore::Exploration exploration(std::filesystem::path(request.input).filename().string(),
                                     std::move(recorded->loaded), std::move(recorded->run), require_room(request));
    explore::Answers answers(exploration);
    ExploreServer server(answers, request.port);
    say("{}\n\nOn another machine, open the same address after\n  ssh -N -L {}:127.0.0.1:{} {}\n\nCtrl-C ends it.\n",
        server.address(), server.port(), server.port(), host_name());
    finish_saying();
    server.serve();
    return exit_done;
}

}  // namespace

Subcommand explore_command() {
    return {"explore", "Show a recorded run as a page whose timing can be changed, with what that changes",
            [](CLI::App& command) {
                auto const request = std::make_shared<ExploreRequest>();
                command
                    .add_option("input", request->input,
                                "Event file of run --events, or a configuration file to be run first")
                    ->required()
                    ->type_name("EVENTS|CONFIG");
                command.add_option("--port", request->port, "Port of 127.0.0.1; 0: any that is free")
                    ->type_name("PORT")
                    ->capture_default_str()
                    ->check(CLI::Range(0, 65535));
                add_force(command, request->force);
                add_overrides(command, request->overrides);
                return [request] { return explore_run(*request); };
            }};
}

}  // namespace dataflow
