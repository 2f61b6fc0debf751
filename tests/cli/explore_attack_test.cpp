// The server of explore under attack, by who knows its token and by who does not: memory stays bounded, others are
// served meanwhile, and the program ends when it is told to.
#include <arpa/inet.h>
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <httplib.h>
#include <netinet/in.h>
#include <optional>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/explore_process.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace explore_attack_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// A connection on which anything may be sent.
class Socket {
  public:
    explicit Socket(int port) : descriptor_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_port = htons(static_cast<std::uint16_t>(port));
        inet_pton(AF_INET, "127.0.0.1", &place.sin_addr);
        REQUIRE(connect(descriptor_, reinterpret_cast<sockaddr const*>(&place), sizeof place) == 0);
    }
    ~Socket() { close(descriptor_); }
    Socket(Socket&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
    Socket& operator=(Socket&&) = delete;

    /// False if the other end has closed, or takes nothing for 5 s.
    bool send(std::string const& text) const {
        for (std::size_t sent = 0; sent < text.size();) {
            pollfd ready{descriptor_, POLLOUT, 0};
            if (poll(&ready, 1, 5000) <= 0)
                return false;
            ssize_t const count = ::send(descriptor_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
            if (count <= 0)
                return false;
            sent += static_cast<std::size_t>(count);
        }
        return true;
    }
    /// Until the other end closes, or says nothing for so long.
    std::string received(int silence_ms = 5000) const {
        std::string text;
        std::array<char, 1 << 16> buffer{};
        pollfd ready{descriptor_, POLLIN, 0};
        while (poll(&ready, 1, silence_ms) > 0) {
            ssize_t const count = recv(descriptor_, buffer.data(), buffer.size(), 0);
            if (count <= 0)
                break;
            text.append(buffer.data(), static_cast<std::size_t>(count));
        }
        return text;
    }

  private:
    int descriptor_;
};

class Attacked {
  public:
    Attacked() {
        require_done(workspace_.run({"--events", "events"}));
        process_.emplace(FASTER_SIM_BINARY, std::vector<std::string>{"events"}, workspace_.folder().path());
        get_page();
        megabytes_before_ = peak_megabytes();
    }

    ExploreProcess& process() { return *process_; }
    int port() { return process_->port(); }
    std::string page_head() { return "GET " + process_->home() + " HTTP/1.1\r\nHost: x\r\n"; }
    std::string question_head() { return "POST " + process_->home() + "retime HTTP/1.1\r\nHost: x\r\n"; }

    /// By a client that does as it should, within 5 s.
    std::string get_page() {
        httplib::Client client("127.0.0.1", port());
        client.set_read_timeout(5);
        auto const page = client.Get(process_->home());
        REQUIRE(page);
        CHECK(page->status == 200);
        return page->body;
    }
    void check_others_are_served() {
        get_page();
        httplib::Client client("127.0.0.1", port());
        client.set_read_timeout(10);
        auto const answer = client.Post(process_->home() + "retime", "{}", "application/json");
        REQUIRE(answer);
        CHECK(answer->status == 200);
    }
    /// More than before the attack.
    double more_megabytes() const { return peak_megabytes() - megabytes_before_; }
    void check_ends_at_once() {
        auto const start = Clock::now();
        CHECK(process_->interrupt() == 0);
        CHECK(seconds_since(start) < 2);
    }

  private:
    double peak_megabytes() const {
        std::ifstream status("/proc/" + std::to_string(process_->number()) + "/status");
        double kilobytes = 0;
        for (std::string line; std::getline(status, line);)
            if (line.rfind("VmHWM:", 0) == 0)
                kilobytes = std::stod(line.substr(6));
        return kilobytes / 1024;
    }

    SmallWorkspace workspace_;
    std::optional<ExploreProcess> process_;
    double megabytes_before_ = 0;
};

TEST_CASE("Connections that say little or nothing keep neither others from the page nor the program from its end") {
    Attacked attacked;
    std::vector<Socket> sockets;
    for (int i = 0; i < 200; ++i) {
        sockets.emplace_back(attacked.port());
        if (i % 2 == 0)
            sockets.back().send("GET / HTTP/1.1\r\nX: ");
    }
    for (int i = 0; i < 10; ++i) {
        for (Socket const& socket : sockets)
            socket.send("d");
        attacked.check_others_are_served();
    }
    CHECK(attacked.more_megabytes() < 32);
    attacked.check_ends_at_once();
}

TEST_CASE("Headers without end are refused before they take memory") {
    Attacked attacked;
    std::string const line = "X-Header: " + std::string(1000, 'x') + "\r\n";
    for (std::string const& start : {std::string("GET / HTTP/1.1\r\n"), attacked.page_head()}) {
        Socket const lines(attacked.port()), one_line(attacked.port());
        lines.send(start);
        one_line.send(start + "X: ");
        std::size_t sent = 0;
        while (sent < (std::size_t{64} << 20U) && lines.send(line) && one_line.send(line.substr(0, 1000)))
            sent += line.size();
        CHECK(sent < (std::size_t{16} << 20U));
        attacked.check_others_are_served();
    }
    Socket const socket(attacked.port());
    socket.send(attacked.page_head() + "X: " + std::string(20000, 'x'));
    CHECK_THAT(socket.received(), Contains("HTTP/1.1 431 "));
    CHECK(attacked.more_megabytes() < 32);
    attacked.check_ends_at_once();
}

TEST_CASE("A body is bounded, however its length is told") {
    Attacked attacked;
    std::string const chunk = "10000\r\n" + std::string(0x10000, ' ') + "\r\n";
    std::vector<std::string> const bodies{
        "Content-Length: 4000000000\r\n\r\n", "Content-Length: 131073\r\n\r\n",
        "Transfer-Encoding: chunked\r\n\r\n" + chunk + chunk + chunk,
        "Content-Length: 4\r\nTransfer-Encoding: chunked\r\n\r\n" + chunk + chunk + chunk,
        "Content-Type: multipart/form-data; boundary=x\r\nTransfer-Encoding: chunked\r\n\r\n" + chunk + chunk + chunk};
    for (std::string const& body : bodies) {
        CAPTURE(body.substr(0, 80));
        Socket const socket(attacked.port());
        socket.send(attacked.question_head() + body);
        std::string const answer = socket.received();
        bool const is_refused = answer.find(" 413 ") != std::string::npos || answer.find(" 400 ") != std::string::npos;
        CHECK(is_refused);
    }
    Socket const endless(attacked.port());  // neither length nor chunks: what follows is no request
    endless.send(attacked.question_head() + "\r\n");
    std::size_t sent = 0;
    while (sent < (std::size_t{64} << 20U) && endless.send(chunk))
        sent += chunk.size();
    CHECK(sent < (std::size_t{16} << 20U));
    CHECK(attacked.more_megabytes() < 32);
    attacked.check_others_are_served();
    attacked.check_ends_at_once();
}

TEST_CASE("A chunked question within the bounds is answered") {
    Attacked attacked;
    Socket const socket(attacked.port());
    socket.send(attacked.question_head() +
                "Connection: close\r\nTransfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n");
    CHECK_THAT(socket.received(), Contains("HTTP/1.1 200 ") && Contains("\"total_cycles\""));
}

TEST_CASE("Ranges make no more of a page than there is") {
    Attacked attacked;
    std::string ranges = "Range: bytes=0-";
    for (int i = 0; i < 2000; ++i)
        ranges += ",0-";
    Socket const socket(attacked.port());
    socket.send(attacked.page_head() + "Connection: close\r\n" + ranges + "\r\n\r\n");
    std::string const answer = socket.received();
    CHECK_THAT(answer.substr(0, 100), Contains("HTTP/1.1 200 "));
    CHECK(answer.size() < attacked.get_page().size() + 2000);
    CHECK(attacked.more_megabytes() < 32);
}

TEST_CASE("Whatever is no request is told so, and many requests on one connection are answered in order") {
    Attacked attacked;
    for (std::string const& text :
         {std::string("nonsense\r\n\r\n"), std::string("GET\r\n\r\n"), std::string(3, '\0') + "\r\n",
          std::string("\x16\x03\x01\x02\r\n\r\n"), std::string("GET / HTTP/9.9\r\n\r\n")}) {
        CAPTURE(text);
        Socket const socket(attacked.port());
        socket.send(text);
        CHECK_THAT(socket.received(), Contains("HTTP/1.1 400 "));
    }
    Socket const socket(attacked.port());
    std::string const question = attacked.question_head() + "Content-Length: 2\r\n\r\n{}";
    socket.send(question + question + attacked.question_head() + "Connection: close\r\nContent-Length: 2\r\n\r\n[]");
    std::string const answers = socket.received();
    std::size_t const first = answers.find(" 200 "), second = answers.find(" 200 ", first + 1);
    CHECK(first < second);
    CHECK(second < answers.find(" 400 "));
    attacked.check_ends_at_once();
}

TEST_CASE("Who asks much and reads nothing does not keep the program from its end") {
    Attacked attacked;
    std::vector<Socket> sockets;
    std::string const question = attacked.question_head() + "Content-Length: 2\r\n\r\n{}";
    for (int i = 0; i < 100; ++i) {
        sockets.emplace_back(attacked.port());
        sockets.back().send(question + question + question);
    }
    attacked.check_ends_at_once();
}

}  // namespace explore_attack_test
