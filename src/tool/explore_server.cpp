#include "tool/explore_server.hpp"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <fmt/format.h>
#include <httplib.h>
#include <poll.h>
#include <random>
#include <thread>

#include "kernel/base/input_error.hpp"
#include "kernel/base/signal_watch.hpp"

namespace faster {

namespace {

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

}  // namespace

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

}  // namespace faster
