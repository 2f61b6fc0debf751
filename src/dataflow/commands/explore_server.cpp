#include "dataflow/commands/explore_server.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <fmt/format.h>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <unistd.h>
#include <utility>

#include "dataflow/base/host_clock.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/signal_watch.hpp"

namespace dataflow {

namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;
using boost::system::error_code;

constexpr char const* this_host = "127.0.0.1";
constexpr std::uint32_t most_bytes_of_header = 1U << 14U;
constexpr std::uint64_t most_bytes_of_body = 1U << 17U;
constexpr std::size_t most_bytes_of_buffer = 1U << 16U;  ///< read and not yet looked at
constexpr std::size_t most_bytes_drained = 1U << 20U;    ///< of a request that was refused before it was read
constexpr std::size_t most_connections = 64;             // a browser opens six
constexpr std::size_t most_answers_at_work = 8;
constexpr std::chrono::seconds time_of_request{20};
constexpr std::chrono::seconds time_of_response{120};  // a page of megabytes through a slow line
constexpr std::chrono::seconds time_of_drain{2};
constexpr std::chrono::milliseconds time_of_end{500};

/// 128 bits that nobody can guess.
std::string random_token() {
    std::random_device device;
    std::string token;
    for (int i = 0; i < 4; ++i)
        token += fmt::format("{:08x}", device());
    return token;
}

using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;

Response response_of(explore::Answer const& answer, unsigned version, bool keep_alive) {
    Response response(static_cast<http::status>(answer.status), version);
    response.set(http::field::content_type, answer.type);
    response.set(http::field::cache_control, "no-store");
    response.set("Referrer-Policy", "no-referrer");  // the address has the token
    response.set("X-Content-Type-Options", "nosniff");
    response.keep_alive(keep_alive);
    response.body() = answer.body;
    response.prepare_payload();
    return response;
}

explore::Answer refusal(int status, char const* text) { return {status, "text/plain", text}; }

/// What a request that is none is told; nothing if nobody waits for an answer.
std::optional<explore::Answer> complaint_of(error_code const& error) {
    if (error == http::error::body_limit)
        return refusal(413, "expected a request of at most 128 KiB\n");
    if (error == http::error::header_limit || error == http::error::buffer_overflow)
        return refusal(431, "expected at most 16 KiB of headers\n");
    bool const is_no_request = error.category() == make_error_code(http::error::bad_method).category() &&
                               error != http::error::end_of_stream && error != http::error::partial_message;
    return is_no_request ? std::optional(refusal(400, "expected an HTTP request\n")) : std::nullopt;
}

class Connections;

/// One client: a request, its answer, and so on. All but the answering is done by one thread.
class Connection : public std::enable_shared_from_this<Connection> {
  public:
    Connection(tcp::socket socket, Connections& all) : stream_(std::move(socket)), all_(all) {}

    void read() {
        waits_since_ = HostClock::now();
        parser_.emplace();
        parser_->header_limit(most_bytes_of_header);
        parser_->body_limit(most_bytes_of_body);
        stream_.expires_after(time_of_request);
        http::async_read(stream_, buffer_, *parser_,
                         [self = shared_from_this()](error_code const& error, std::size_t) { self->has_read(error); });
    }
    /// What is read or written ends with an error, and nothing holds the connection any more.
    void close() {
        error_code ignored;
        stream_.socket().close(ignored);
    }
    /// Since when a whole request has been waited for; nothing while one is answered.
    std::optional<HostClock::time_point> waits_since() const { return waits_since_; }

  private:
    void has_read(error_code const& error);
    void write(explore::Answer const& answer, unsigned version, bool keep_alive);
    void has_written(error_code const& error);
    void drain(std::size_t bytes_left);
    void end();

    beast::tcp_stream stream_;
    Connections& all_;
    beast::flat_buffer buffer_{most_bytes_of_buffer};
    std::optional<http::request_parser<http::string_body>> parser_;
    std::optional<Response> response_;
    std::optional<HostClock::time_point> waits_since_;
    std::array<char, 4096> drained_{};
};

/// Those that are open, and the threads that work out their answers.
class Connections {
  public:
    using Take = std::function<void(explore::Answer const&)>;

    Connections(asio::io_context& io, explore::Answers& answers, std::string home)
        : io_(io), answers_(answers), home_(std::move(home)) {}

    void add(tcp::socket socket) {
        if (open_.size() >= most_connections && !makes_room())
            return;
        error_code ignored;
        socket.set_option(tcp::no_delay(true), ignored);
        auto const connection = std::make_shared<Connection>(std::move(socket), *this);
        open_.insert(connection);
        connection->read();
    }
    void remove(std::shared_ptr<Connection> const& connection) { open_.erase(connection); }
    /// `take` gets the answer, in the thread that reads and writes.
    void work_out(Request request, Take take) {
        ++at_work_;
        asio::post(workers_, [this, request = std::move(request), take = std::move(take)] {
            explore::Answer answer;
            try {
                answer = answer_to(request);
            } catch (...) {
                answer = explore::failure(std::current_exception());
            }
            asio::post(io_, [take, answer = std::move(answer)] { take(answer); });
            --at_work_;
        });
    }
    bool is_at_work() const { return at_work_ > 0; }

  private:
    /// By the one that has been waited for longest. False if all are being answered.
    bool makes_room() {
        auto const waits_longer = [](auto const& one, auto const& other) {
            return one->waits_since() && (!other->waits_since() || *one->waits_since() < *other->waits_since());
        };
        std::shared_ptr<Connection> const oldest = *std::min_element(open_.begin(), open_.end(), waits_longer);
        if (!oldest->waits_since())
            return false;
        oldest->close();
        open_.erase(oldest);
        return true;
    }

    explore::Answer answer_to(Request const& request) {
        std::string const target(request.target().data(), request.target().size());
        std::string const path = target.substr(0, target.find('?'));
        if (path.compare(0, home_.size(), home_) != 0)
            return refusal(403, "expected the address that was printed, with its token\n");
        std::string const question = path.substr(home_.size());
        if (request.method() == http::verb::get && question.empty())
            return answers_.page();
        bool const is_word =
            std::all_of(question.begin(), question.end(), [](char letter) { return letter >= 'a' && letter <= 'z'; });
        if (request.method() != http::verb::post || question.empty() || !is_word)
            return refusal(404, "expected GET of the page, or POST of a question\n");
        return answers_.ask(question, request.body());
    }

    asio::io_context& io_;
    explore::Answers& answers_;
    std::string const home_;
    std::set<std::shared_ptr<Connection>> open_;
    std::atomic<int> at_work_{0};
    asio::thread_pool workers_{most_answers_at_work};  // last: they are waited for before anything else goes
};

void Connection::has_read(error_code const& error) {
    waits_since_.reset();
    if (error) {
        auto const complaint = complaint_of(error);
        return complaint ? write(*complaint, 11, false) : end();
    }
    Request request = parser_->release();
    unsigned const version = request.version();
    bool const keep_alive = request.keep_alive();
    all_.work_out(std::move(request), [self = shared_from_this(), version, keep_alive](explore::Answer const& answer) {
        self->write(answer, version, keep_alive);
    });
}

void Connection::write(explore::Answer const& answer, unsigned version, bool keep_alive) {
    response_.emplace(response_of(answer, version, keep_alive));
    stream_.expires_after(time_of_response);
    http::async_write(stream_, *response_,
                      [self = shared_from_this()](error_code const& error, std::size_t) { self->has_written(error); });
}

void Connection::has_written(error_code const& error) {
    bool const goes_on = response_->keep_alive();
    response_.reset();
    if (error)
        return end();
    if (goes_on)
        return read();
    error_code ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    stream_.expires_after(time_of_drain);
    drain(most_bytes_drained);
}

/// A socket that is closed while something comes would take the answer back that its client has not read yet.
void Connection::drain(std::size_t bytes_left) {
    stream_.async_read_some(asio::buffer(drained_),
                            [self = shared_from_this(), bytes_left](error_code const& error, std::size_t bytes) {
                                if (error || bytes >= bytes_left)
                                    return self->end();
                                self->drain(bytes_left - bytes);
                            });
}

void Connection::end() {
    close();
    all_.remove(shared_from_this());
}

}  // namespace

class ExploreServer::Http {
  public:
    Http(explore::Answers& answers, int port)
        : home_("/" + random_token() + "/"), acceptor_(io_), connections_(io_, answers, home_) {
        error_code error;
        tcp::endpoint const place(asio::ip::make_address(this_host), static_cast<unsigned short>(port));
        acceptor_.open(place.protocol(), error);
        if (!error)
            acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
        if (!error)
            acceptor_.bind(place, error);
        if (!error)
            acceptor_.listen(asio::socket_base::max_listen_connections, error);
        if (error)
            throw InputError(fmt::format("--port {}: cannot be listened on, expected a free port; 0 takes any", port));
    }

    int port() const { return acceptor_.local_endpoint().port(); }
    std::string const& home() const { return home_; }

    void serve(std::function<void()> const& tell_of_end) {
        processes::SignalWatch const watch;
        asio::posix::stream_descriptor signals(io_, dup(watch.descriptor()));
        signals.async_wait(asio::posix::stream_descriptor::wait_read, [this](error_code const&) { io_.stop(); });
        accept();
        io_.run();
        watch.take();
        error_code ignored;
        acceptor_.close(ignored);
        tell_of_end();
        leave_answers_alone();
    }

  private:
    void accept() {
        acceptor_.async_accept([this](error_code const& error, tcp::socket socket) {
            if (error)
                return try_again_later();
            connections_.add(std::move(socket));
            accept();
        });
    }

    /// When there is no descriptor left, there may be one as soon as a client has gone.
    void try_again_later() {
        later_.expires_after(std::chrono::milliseconds(100));
        later_.async_wait([this](error_code const&) { accept(); });
    }

    /// One that takes long is for nobody any more, and this program has nothing of it half-written.
    void leave_answers_alone() const {
        auto const end = HostClock::now() + time_of_end;
        while (connections_.is_at_work() && HostClock::now() < end)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        if (connections_.is_at_work())
            _exit(EXIT_SUCCESS);
    }

    asio::io_context io_;
    std::string const home_;
    tcp::acceptor acceptor_;
    asio::steady_timer later_{io_};
    Connections connections_;
};

ExploreServer::ExploreServer(explore::Answers& answers, int port) : http_(std::make_unique<Http>(answers, port)) {}
ExploreServer::~ExploreServer() = default;

int ExploreServer::port() const { return http_->port(); }
std::string ExploreServer::address() const {
    return fmt::format("http://{}:{}{}", this_host, http_->port(), http_->home());
}
void ExploreServer::serve(std::function<void()> const& tell_of_end) { http_->serve(tell_of_end); }

}  // namespace dataflow
