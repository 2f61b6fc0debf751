#pragma once
#include <chrono>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <sys/types.h>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/temp_folder.hpp"

namespace faster::test {

/// Chromium with a page that is used as a person would: by mouse and keyboard. Spoken to by its DevTools protocol over
/// a pipe.
class LiveBrowser {
  public:
    LiveBrowser(int width, int height);
    ~LiveBrowser();
    LiveBrowser(LiveBrowser const&) = delete;
    LiveBrowser& operator=(LiveBrowser const&) = delete;

    void open(std::string const& address);
    /// The value of an expression in the page; of a promise, what it comes to. Throws std::runtime_error if it throws.
    nlohmann::json value(std::string const& expression);
    /// Until an expression is true; false after some time, which is long, as the host may be busy with other things.
    bool becomes_true(std::string const& expression, std::chrono::seconds within = std::chrono::minutes(1));
    /// Where the middle of an element is; it is scrolled into view.
    struct Box {
        double left, top, width, height;
    };
    Box box_of(std::string const& selector);
    void click(std::string const& selector);
    /// Takes the thumb of a slider to a share of its length, in several moves of the mouse.
    void drag_slider(std::string const& selector, double share);
    /// To one share after the other; `moved` is called before the next.
    void drag_slider(std::string const& selector, std::vector<double> const& shares,
                     std::function<void()> const& moved);
    /// Turns the wheel over the middle of an element; away from the user is negative.
    void wheel(std::string const& selector, double by);
    void press_with_control(char letter);
    void press(std::string const& key);
    /// Exceptions and whatever was written to the console.
    nlohmann::json const& troubles() const { return troubles_; }

  private:
    nlohmann::json call(std::string const& method, nlohmann::json const& parameters);
    nlohmann::json read_message();
    struct Point {
        double x, y;
    };
    Point press_on(std::string const& selector, std::function<Point(Box const&)> const& place_in);
    void mouse(std::string const& type, double x, double y, int buttons);

    TempFolder profile_;
    pid_t process_ = -1;
    int to_browser_ = -1;
    int from_browser_ = -1;
    int last_id_ = 0;
    std::string session_;
    std::string unread_;
    nlohmann::json troubles_ = nlohmann::json::array();
};

}  // namespace faster::test
