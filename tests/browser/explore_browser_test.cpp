#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <sstream>
#include <thread>

#include "faster/dataflow_names.hpp"
#include "support/browser.hpp"
#include "support/explore_process.hpp"
#include "support/live_browser.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace explore_browser_test {

using namespace faster::test;
using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// The page of a small run.
class Page {
  public:
    explicit Page(int width = 1280, std::string const& setting = "accelerator.raster_cores=2")
        : process_((require_done(workspace_.run({"--events", "events", "--set", setting})), FASTER_SIM_BINARY),
                   {"events"}, workspace_.folder().path()),
          browser_(width, 900) {
        open("");
    }

    LiveBrowser& browser() { return browser_; }
    TempFolder const& folder() const { return workspace_.folder(); }
    void open(std::string const& fragment) {
        browser_.open(process_.address() + fragment);
        REQUIRE(browser_.becomes_true(
            "document.readyState == 'complete' && Boolean(document.querySelector('#tried tbody tr'))"));
    }
    /// As the headline has it: digits only.
    std::string cycles() {
        return browser_.value("document.querySelector('#headline dd').firstChild.textContent.replace(/\\D/g, '')");
    }
    bool comes_to_show(std::string const& cycles) {
        return browser_.becomes_true(
            "document.querySelector('#headline dd').firstChild.textContent.replace(/\\D/g, '') == '" + cycles + "'");
    }
    std::string fragment() { return browser_.value("decodeURIComponent(location.hash)"); }
    static std::string slider(std::string const& key) { return "[data-key='" + key + "'] input[type=range]"; }
    /// Until the address has so many changes, which it has once figures are there.
    void await_changes(int number) {
        CHECK(browser_.becomes_true("(location.hash.match(/=/g) || []).length == " + std::to_string(number)));
    }
    void check_soundness() {
        CHECK(browser_.troubles() == Json::array());
        CHECK(browser_.value("document.getElementById('trouble').textContent") == "");
        CHECK(browser_.value("document.documentElement.scrollWidth <= innerWidth") == true);
        CHECK(browser_.value("[...document.querySelectorAll('#headline div, #actions button')].every((part) => "
                             "part.offsetWidth > 0 && part.getBoundingClientRect().right <= innerWidth)") == true);
        CHECK(browser_.value("innerWidth < 1366 || ((box) => box.scrollWidth <= box.clientWidth)"
                             "(document.getElementById('graph-box'))") == true);
    }
    /// What a command of the tool with the exported options says.
    std::string cycles_of_tool(Words words) {
        words.insert(words.end(), {"--out", "out"});
        require_done(run_command(FASTER_SIM_BINARY, words, folder().path()));
        return std::to_string(workspace_.summary("out")["total_cycles"].get<std::uint64_t>());
    }

  private:
    SmallWorkspace workspace_;
    ExploreProcess process_;
    LiveBrowser browser_;
};

Words words_of(std::string const& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

/// What the server does in the background gives way to everything else on the host.
constexpr std::chrono::seconds background{200};

std::string button(std::string const& text) {
    return "[...document.querySelectorAll('button')].find((b) => b.textContent == '" + text + "')";
}

/// Writes into the field of a number and leaves it.
std::string typed(std::string const& field, std::string const& text) {
    return "document.querySelector(\"" + field + "\").value = '" + text + "'; document.querySelector(\"" + field +
           "\").dispatchEvent(new Event('change')); 0";
}

/// Texts of the graph that are wider than their boxes.
constexpr char const* too_wide =
    "[...document.querySelectorAll('#graph-box text')].filter((text) => text.getBoundingClientRect().width > "
    "text.parentNode.querySelector('rect').getBoundingClientRect().width).map((text) => text.textContent)";

/// A phone, a laptop and a screen.
constexpr std::array<int, 3> widths{390, 1440, 1920};

TEST_CASE("Dragging three keys, undoing one and exporting gives what the tool says of the export", "[browser]") {
    if (browser_is_missing())
        return;
    int const width = GENERATE(from_range(widths));
    CAPTURE(width);
    Page page(width);
    std::string const recorded = page.cycles();
    CHECK(recorded == page.cycles_of_tool({"whatif", "events"}));
    page.browser().drag_slider(Page::slider("accelerator.fifos.edge_token.depth"), 0.5);
    page.await_changes(1);
    page.browser().drag_slider(Page::slider("accelerator.brams.depth_buffer.ports"), 0.9);
    page.await_changes(2);
    std::string const of_two = page.cycles(), fragment_of_two = page.fragment();
    page.browser().drag_slider(Page::slider("accelerator.raster_cores"), 0);
    page.await_changes(3);
    CHECK(page.cycles() != of_two);
    page.browser().press_with_control('z');
    page.await_changes(2);
    CHECK(page.comes_to_show(of_two));
    CHECK(page.fragment() == fragment_of_two);

    page.browser().value(button("copy --set") + ".click()");
    Words words = words_of(page.browser().value("document.getElementById('copied').value"));
    CHECK(words.size() == 4);
    words.insert(words.begin(), {"whatif", "events"});
    CHECK(page.cycles_of_tool(words) == of_two);
    page.browser().value(button("copy YAML") + ".click()");
    page.folder().write("exported.yaml", page.browser().value("document.getElementById('copied').value"));
    CHECK(page.cycles_of_tool({"run", "exported.yaml"}) == of_two);

    page.browser().click("#show-sample");  // one may be there already, which the new one replaces
    REQUIRE(page.browser().becomes_true("document.getElementById('timeline-note').textContent.startsWith('Sample')"));
    page.browser().wheel("#timeline-chart", -480);
    CHECK(page.browser().becomes_true("document.querySelector('#timeline-controls input[type=range]').value == 2"));
    page.browser().value(button("reset") + ".click()");
    CHECK(page.browser().becomes_true(
        "/^Sample((?! With ).)*$/.test(document.getElementById('timeline-note').textContent)"));

    page.open("");  // another address, so that the next is no mere change of the fragment
    page.browser().open("about:blank");
    page.open(fragment_of_two);
    CHECK(page.comes_to_show(of_two));
    page.check_soundness();
}

TEST_CASE("The page says what the tool would of a bad value, and shows who waits for whom in a deadlock", "[browser]") {
    if (browser_is_missing())
        return;
    Page page;
    std::string const before = page.cycles();
    std::string const box =
        "document.querySelector(\"[data-key='accelerator.fifos.fragment_depth.depth'] input[type=number]\")";
    page.browser().value(box + ".value = 0; " + box + ".dispatchEvent(new Event('change'))");
    CHECK(page.browser().becomes_true(
        "document.getElementById('complaint').textContent == '--set accelerator.fifos.fragment_depth.depth=0: expected "
        "an integer from 1 to 1048576'"));
    CHECK(page.cycles() == before);
    CHECK(page.browser().value(box + ".value") == "2");

    page.browser().value(
        "document.querySelector(\"[data-key='accelerator.fifos.fragment_depth.depth'] "
        "input[type=range]\").focus({preventScroll: true})");
    page.browser().press("ArrowLeft");
    CHECK(page.browser().becomes_true("document.querySelectorAll('#deadlock li').length > 1"));
    CHECK(page.browser().value("document.querySelectorAll('#graph-box .fifo.stuck').length > 1") == true);
    page.check_soundness();
}

TEST_CASE("A link with a key that there is not shows the recorded run, and says so", "[browser]") {
    if (browser_is_missing())
        return;
    Page page;
    std::string const recorded = page.cycles();
    page.browser().open("about:blank");
    page.open("#accelerator.fifos.vertx.depth=4");
    CHECK(
        page.browser().becomes_true("document.getElementById('complaint').textContent.includes('did you mean "
                                    "accelerator.fifos.vertex.depth?')"));
    CHECK(page.cycles() == recorded);

    for (char const* text : {"%E0%A4%A", "xxxx"}) {
        page.browser().open("about:blank");
        page.open("#" + std::string(text));
        CHECK(page.browser().becomes_true("document.getElementById('complaint').textContent.includes('--set " +
                                          std::string(text) + "')"));
    }
    page.check_soundness();
}

TEST_CASE("While an answer is worked out the headline says so, and a bad value takes no other change with it",
          "[browser]") {
    if (browser_is_missing())
        return;
    Page page(700);
    std::string const box = " input[type=number]", depth = "[data-key='accelerator.fifos.command.depth']" + box,
                      changed = "#accelerator.fifos.edge_token.depth=16";
    page.browser().value(
        "at_once = fetch; fetch = (what, how) => what == 'retime' ? new Promise((go) => { answer = go; }).then(() => "
        "at_once(what, how)) : at_once(what, how); 0");
    page.browser().value(typed(depth, "0"));
    page.browser().value(typed("[data-key='accelerator.fifos.edge_token.depth']" + box, "16"));
    std::string const is_waiting = "document.getElementById('headline').ariaBusy == 'true'";
    CHECK(page.browser().becomes_true(is_waiting));
    CHECK(page.browser().value("document.querySelector('#headline .change').textContent") == "working it out");
    page.browser().value("fetch = at_once; answer(); 0");
    page.await_changes(1);
    CHECK(page.fragment() == changed);
    CHECK(page.browser().value(is_waiting) == false);
    CHECK(page.browser().value("document.querySelector('#headline .change').textContent") != "working it out");
    CHECK(page.browser().value("document.querySelector(\"" + depth + "\").value") == "2");
    CHECK(page.browser().value("document.getElementById('complaint').textContent") ==
          "--set accelerator.fifos.command.depth=0: expected an integer from 1 to 1048576");
    CHECK(page.cycles() == page.cycles_of_tool({"whatif", "events", "--set", changed.substr(1)}));

    page.browser().click("nav a[href='#loops']");  // another place in the page, and no other configuration
    CHECK(page.browser().becomes_true("location.hash.includes('edge_token')"));
    CHECK(page.fragment() == changed);
    CHECK(page.browser().value(
              "((list) => list.scrollWidth <= list.clientWidth)(document.getElementById('key-list'))") == true);
    CHECK(page.browser().value(
              "[...document.querySelectorAll('.key > select ~ .back')].every((back) => back.offsetTop == "
              "back.parentNode.querySelector('select').offsetTop)") == true);
    CHECK(page.browser().value("((ticks) => new Set(ticks).size == ticks.length)(Chart.getChart(document.querySelector("
                               "'#tried-chart canvas')).scales.y.ticks.map((tick) => tick.label))") == true);
    page.check_soundness();
}

TEST_CASE("The page has a choice for what is true or false, and draws no memory that there is not", "[browser]") {
    if (browser_is_missing())
        return;
    Page page(1280, "accelerator.architecture=next_zcu102");
    std::string const choice = "[data-key='accelerator.memory.prefetch'] select";
    CHECK(page.browser().value("[...document.querySelectorAll(\"" + choice + " option\")].map((o) => o.value)") ==
          Json::array({"true", "false"}));
    CHECK(page.browser().value("document.querySelector(\"" + choice + "\").value") == "false");
    page.browser().value(typed(choice, "true"));
    page.await_changes(1);
    CHECK(page.fragment() == "#accelerator.memory.prefetch=true");
    CHECK(page.cycles() == page.cycles_of_tool({"whatif", "events", "--set", "accelerator.memory.prefetch=true"}));

    CHECK(page.browser().becomes_true("/banks of/.test(document.getElementById('graph-box').textContent)"));
    CHECK(page.browser().value(too_wide) == Json::array());
    CHECK(page.browser().value("[...document.querySelectorAll('#graph-box .bram')].map((bram) => bram.dataset.part)"
                               ".includes('bram:edge_map')") == false);
    CHECK(page.browser().value("[...document.querySelectorAll('#timeline .legend li')].map((li) => "
                               "li.textContent.trim()).includes('loop')") == false);
    page.browser().value(typed("#timeline-controls input[type=number]", ""));
    CHECK(page.browser().becomes_true(
        "document.getElementById('timeline-note').textContent == 'sample = \"\", expected a whole number'"));
    page.check_soundness();
}

TEST_CASE("The page sizes FIFOs, and fits phones and screens", "[browser]") {
    if (browser_is_missing())
        return;
    int const width = GENERATE(widths.front(), widths.back());
    CAPTURE(width);
    Page page(width);
    page.browser().value(button("size FIFOs") + ".click()");
    REQUIRE(page.browser().becomes_true("Boolean(document.getElementById('take-sizing'))", background));
    page.browser().click("#take-sizing");
    REQUIRE(page.browser().becomes_true("location.hash.includes('depth')"));
    page.browser().value(button("copy --set") + ".click()");
    Words words = words_of(page.browser().value("document.getElementById('copied').value"));
    words.insert(words.begin(), {"whatif", "events"});
    CHECK(page.cycles() == page.cycles_of_tool(words));
    CHECK(page.browser().becomes_true("document.querySelectorAll('#tried tbody tr').length > 3"));
    CHECK(page.browser().becomes_true(
        "[...document.querySelectorAll('.step')].some((b) => /[1-9]/.test(b.textContent))", background));
    page.browser().click("#graph-box .fifo");  // shows its keys alone
    CHECK(page.browser().becomes_true("document.querySelectorAll('#key-list .key').length <= 4"));
    CHECK(page.browser().value("document.querySelectorAll('#graph .source').length") == 2);  // of writer and reader
    CHECK(page.browser().becomes_true(
        "/described in .*src.modules.*cpp:[0-9]+/.test(document.querySelector('#graph .source').textContent)"));
    page.check_soundness();
}

TEST_CASE("A step's button says what whatif says from what is on the screen, and does it", "[browser]") {
    if (browser_is_missing())
        return;
    int const width = GENERATE(widths.front(), widths.back());
    CAPTURE(width);
    Page page(width);
    std::string const changed = "accelerator.brams.depth_buffer.ports=4";
    page.open("#" + changed);
    std::string const step =
        "document.querySelector('[data-key=\"accelerator.brams.depth_buffer.ports\"] .step:nth-of-type(2)')";
    REQUIRE(page.browser().becomes_true(step + ".textContent.match(/[0-9]{2}/) !== null", background));
    std::string const promised = page.browser().value(step + ".textContent");
    std::uint64_t const before = std::stoull(page.cycles());
    page.browser().value(step + ".click()");
    REQUIRE(page.browser().becomes_true("location.hash.includes('ports=5')"));
    std::uint64_t const after =
        std::stoull(page.cycles_of_tool({"whatif", "events", "--set", "accelerator.brams.depth_buffer.ports=5"}));
    CHECK(page.comes_to_show(std::to_string(after)));
    std::string digits;
    for (char const letter : promised)
        if (letter >= '0' && letter <= '9')
            digits += letter;
    CHECK(std::stoull(digits) == (after > before ? after - before : before - after));
    CHECK(page.browser().value("document.getElementById('keys').getBoundingClientRect().right < "
                               "document.getElementById('graph').getBoundingClientRect().left") == (width > 1200));
    page.check_soundness();
}

TEST_CASE("Behind an external memory the page shows a sample's timeline, and says what it thinks of FIFO sizes",
          "[browser]") {
    if (browser_is_missing())
        return;
    Page page(1280, "accelerator.memory.model=axi");
    page.browser().click("#show-sample");  // one may be there already, which the new one replaces
    REQUIRE(page.browser().becomes_true("document.getElementById('timeline-note').textContent.startsWith('Sample')"));
    std::string const chart = "Chart.getChart(document.querySelector('#timeline-chart canvas'))";
    CHECK(page.browser().value(chart + ".data.datasets.find((set) => set.label == 'memory stall').data.length > 0") ==
          true);
    std::string const whole = page.browser().value("String(" + chart + ".scales.x.max)");
    page.browser().wheel("#timeline-chart", -480);
    CHECK(page.browser().becomes_true(chart + ".scales.x.max < " + whole));
    page.browser().value(button("size FIFOs") + ".click()");
    CHECK(page.browser().becomes_true(
        "document.getElementById('sizing-note').textContent.includes('so depths are not searched') || "
        "Boolean(document.getElementById('take-sizing'))",
        background));
    page.check_soundness();
}

// faster_browser_tests "[latency]": a measurement, and no test, as it depends on the host and on what else it does.
TEST_CASE("How long the new total of the main job takes from the mouse to the screen", "[.latency]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    require_done(run_command(FASTER_SIM_BINARY,
                             {"run", FASTER_SOURCE_DIR "/configs/faster_zcu102.yaml", "--events", "events"},
                             folder.path()));
    ExploreProcess const process(FASTER_SIM_BINARY, {"events"}, folder.path());
    LiveBrowser browser(1280, 900);
    browser.open(process.address());
    REQUIRE(browser.becomes_true("[...document.querySelectorAll('.step')].some((b) => /[1-9]/.test(b.textContent))",
                                 background));
    // From the mouse's event to the frame in which the headline is new.
    browser.value(
        "delays = []; asked = 0; addEventListener('input', (event) => { moved_at = event.timeStamp; }, true);"
        "ask = fetch; fetch = (what, how) => { asked += what == 'retime' ? 1 : 0; return ask(what, how); };"
        "headline = document.getElementById('headline');"
        "new MutationObserver(() => { const since = moved_at; requestAnimationFrame(() => setTimeout(() => "
        "delays.push([performance.now() - since, Number(headline.dataset.milliseconds)]))); })"
        ".observe(headline, { childList: true }); 0");
    std::vector<double> shares;
    for (int i = 1; i <= 20; ++i)
        shares.push_back(i / 20.0);
    for (char const* key : {"accelerator.fifos.edge_token.depth", "accelerator.fifos.command.depth",
                            "accelerator.loops.rasterizer.setup.depth"})
        browser.drag_slider(Page::slider(key), shares, [&] {
            REQUIRE(browser.becomes_true("delays.length == asked"));
            std::this_thread::sleep_for(std::chrono::milliseconds(300));  // the rest of the page is drawn meanwhile
        });
    REQUIRE(browser.value("asked") >= 30);
    for (int column : {0, 1}) {
        std::vector<double> delays;
        for (Json const& row : browser.value("delays"))
            delays.push_back(row[static_cast<std::size_t>(column)]);
        std::sort(delays.begin(), delays.end());
        WARN((column == 0 ? "mouse to screen: " : "question to answer: ")
             << delays.size() << " changes, median " << delays[delays.size() / 2] << " ms, nine tenths below "
             << delays[delays.size() * 9 / 10] << " ms, most " << delays.back() << " ms");
    }
}

}  // namespace explore_browser_test
