#include "support/live_browser.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/browser.hpp"

namespace faster::test {

using Message = nlohmann::json;

namespace {

/// Never returns. The browser reads from descriptor 3 and writes to 4.
[[noreturn]] void become_browser(std::string const& profile, int requests, int answers) {
    constexpr unsigned longest_life_s = 280;
    alarm(longest_life_s);
    int const quiet = open("/dev/null", O_RDWR);
    dup2(quiet, STDOUT_FILENO);
    dup2(quiet, STDERR_FILENO);
    int const from = fcntl(requests, F_DUPFD, 10);  // out of the way of 3 and 4
    int const to = fcntl(answers, F_DUPFD, 10);
    dup2(from, 3);
    dup2(to, 4);
    std::string const its_profile = "--user-data-dir=" + profile;
    execlp(chromium, chromium, "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--remote-debugging-pipe",
           its_profile.c_str(), static_cast<char*>(nullptr));
    _exit(127);
}

std::string quoted(std::string const& text) { return Message(text).dump(); }

/// Where the thumb of a slider is, as an expression.
std::string share_of(std::string const& selector) {
    return "(() => { const e = document.querySelector(" + quoted(selector) +
           "); return (e.value - e.min) / (e.max - e.min); })()";
}

}  // namespace

LiveBrowser::LiveBrowser(int width, int height) {
    std::array<int, 2> requests{}, answers{};
    if (pipe2(requests.data(), O_CLOEXEC) != 0 || pipe2(answers.data(), O_CLOEXEC) != 0)
        throw std::runtime_error("no pipe to the browser");
    process_ = fork();
    if (process_ == 0)
        become_browser(profile_.path(), requests[0], answers[1]);
    close(requests[0]);
    close(answers[1]);
    to_browser_ = requests[1];
    from_browser_ = answers[0];
    std::string const target = call("Target.createTarget", {{"url", "about:blank"}})["targetId"];
    session_ = call("Target.attachToTarget", {{"targetId", target}, {"flatten", true}})["sessionId"];
    for (char const* domain : {"Runtime.enable", "Page.enable"})
        call(domain, Message::object());
    call("Emulation.setDeviceMetricsOverride",
         {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
}

LiveBrowser::~LiveBrowser() {
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
    close(to_browser_);
    close(from_browser_);
}

Message LiveBrowser::call(std::string const& method, Message const& parameters) {
    Message request{{"id", ++last_id_}, {"method", method}, {"params", parameters}};
    if (!session_.empty())
        request["sessionId"] = session_;
    std::string const text = request.dump();
    if (write(to_browser_, text.c_str(), text.size() + 1) != static_cast<ssize_t>(text.size() + 1))  // with its NUL
        throw std::runtime_error("the browser does not listen");
    for (;;) {
        Message const message = read_message();
        if (message.value("id", 0) == last_id_) {
            if (message.contains("error"))
                throw std::runtime_error(method + ": " + message["error"].dump());
            return message["result"];
        }
        std::string const event = message.value("method", "");
        if (event == "Runtime.exceptionThrown" || event == "Runtime.consoleAPICalled")
            troubles_.push_back(message["params"]);
    }
}

Message LiveBrowser::read_message() {
    std::size_t end = 0;
    while ((end = unread_.find('\0')) == std::string::npos) {
        std::array<char, 65536> buffer{};
        ssize_t const read_now = read(from_browser_, buffer.data(), buffer.size());
        if (read_now <= 0)
            throw std::runtime_error("the browser has ended");
        unread_.append(buffer.data(), static_cast<std::size_t>(read_now));
    }
    Message message = Message::parse(unread_.substr(0, end));
    unread_.erase(0, end + 1);
    return message;
}

void LiveBrowser::open(std::string const& address) { call("Page.navigate", {{"url", address}}); }

Message LiveBrowser::value(std::string const& expression) {
    Message const answer =
        call("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
    if (answer.contains("exceptionDetails"))
        throw std::runtime_error(expression + ": " + answer["exceptionDetails"].dump());
    return answer["result"].value("value", Message());
}

bool LiveBrowser::becomes_true(std::string const& expression, std::chrono::seconds within) {
    using Clock = std::chrono::steady_clock;
    for (Clock::time_point const end = Clock::now() + within; Clock::now() < end;) {
        if (value(expression) == true)
            return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
}

LiveBrowser::Box LiveBrowser::box_of(std::string const& selector) {
    Message const box = value("(() => { const e = document.querySelector(" + quoted(selector) +
                              "); e.scrollIntoView({block: 'center', behavior: 'instant'}); const r = "
                              "e.getBoundingClientRect(); return [r.left, r.top, "
                              "r.width, r.height]; })()");
    return {box[0], box[1], box[2], box[3]};
}

void LiveBrowser::mouse(std::string const& type, double x, double y, int buttons) {
    call("Input.dispatchMouseEvent",
         {{"type", type}, {"x", x}, {"y", y}, {"button", "left"}, {"buttons", buttons}, {"clickCount", 1}});
}

/// Presses at a place in an element's box that `place_in` chooses, and again if something pushed it away meanwhile: a
/// busy page is still being laid out.
LiveBrowser::Point LiveBrowser::press_on(std::string const& selector,
                                         std::function<Point(Box const&)> const& place_in) {
    constexpr int most_tries = 50;
    for (int tries = 0; tries < most_tries; ++tries) {
        value("mouse_has_hit = false; document.querySelector(" + quoted(selector) +
              ").addEventListener('mousedown', () => { mouse_has_hit = true; }, { capture: true, once: true }); 0");
        Point const at = place_in(box_of(selector));
        mouse("mousePressed", at.x, at.y, 1);
        if (value("mouse_has_hit") == true)
            return at;
        mouse("mouseReleased", at.x, at.y, 0);
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    Point const at = place_in(box_of(selector));
    Message const there = value("(document.elementFromPoint(" + std::to_string(at.x) + ", " + std::to_string(at.y) +
                                ") || { outerHTML: 'nothing' }).outerHTML.slice(0, 200)");
    throw std::runtime_error(selector + ": the mouse does not hit it, but " + there.dump());
}

void LiveBrowser::click(std::string const& selector) {
    Point const at = press_on(selector, [](Box const& box) {
        return Point{box.left + box.width / 2, box.top + box.height / 2};
    });
    mouse("mouseReleased", at.x, at.y, 0);
}

void LiveBrowser::drag_slider(std::string const& selector, double share) {
    constexpr int moves = 8;
    double const from = value(share_of(selector));
    std::vector<double> shares;
    for (int i = 1; i <= moves; ++i)
        shares.push_back(from + (share - from) * i / moves);
    drag_slider(selector, shares, [] {});
}

void LiveBrowser::drag_slider(std::string const& selector, std::vector<double> const& shares,
                              std::function<void()> const& moved) {
    constexpr double half_thumb = 8;  // pixels
    double const from = value(share_of(selector));
    Box box{};
    auto const at_share = [&box](double share) {
        return Point{box.left + half_thumb + (box.width - 2 * half_thumb) * share, box.top + box.height / 2};
    };
    Point at = press_on(selector, [&](Box const& now) {
        box = now;
        return at_share(from);
    });
    for (double const share : shares) {
        at = at_share(share);
        mouse("mouseMoved", at.x, at.y, 1);
        moved();
    }
    mouse("mouseReleased", at.x, at.y, 0);
}

void LiveBrowser::wheel(std::string const& selector, double by) {
    Box const box = box_of(selector);
    call("Input.dispatchMouseEvent", {{"type", "mouseWheel"},
                                      {"x", box.left + box.width / 2},
                                      {"y", box.top + box.height / 2},
                                      {"deltaX", 0},
                                      {"deltaY", by}});
}

void LiveBrowser::press_with_control(char letter) {
    constexpr int control = 2;
    std::string const key(1, letter);
    for (char const* type : {"keyDown", "keyUp"})
        call("Input.dispatchKeyEvent", {{"type", type}, {"modifiers", control}, {"key", key}});
}

void LiveBrowser::press(std::string const& key) {
    for (char const* type : {"keyDown", "keyUp"})
        call("Input.dispatchKeyEvent", {{"type", type},
                                        {"key", key},
                                        {"code", key},
                                        {"windowsVirtualKeyCode", key == "ArrowRight" ? 39
                                                                  : key == "Enter"    ? 13
                                                                                      : 37},
                                        {"text", key == "Enter" ? "\r" : ""}});
}

}  // namespace faster::test
