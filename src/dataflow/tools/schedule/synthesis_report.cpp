#include "dataflow/tools/schedule/synthesis_report.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <pugixml.hpp>
#include <tuple>

#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/text_lines.hpp"

namespace dataflow::schedule {

namespace {

constexpr std::uint64_t most_report_bytes = 256U << 20U;
constexpr unsigned deepest_loop = 100;

class ReportReader {
  public:
    ReportReader(std::string const& name, std::string_view text) : name_(name), text_(text) {}

    SynthesisReport read() {
        pugi::xml_parse_result const parsed = document_.load_buffer(text_.data(), text_.size());
        if (!parsed)
            fail(line_of(parsed.offset), std::string("no XML: ") + parsed.description(), "a csynth.xml");
        pugi::xml_node const profile = document_.child("profile");
        if (!profile)
            fail(1, "root element " + std::string(document_.document_element().name()), "profile");
        report_.version = profile.child("ReportVersion").child_value("Version");
        read_loops(profile.child("UserAssignments").child_value("TopModelName"), profile);
        for (pugi::xml_node const module : profile.child("ModuleInformation").children("Module"))
            read_loops(module.child_value("Name"), module);
        read_fifos(profile);
        return std::move(report_);
    }

  private:
    [[noreturn]] void fail(std::size_t line, std::string const& found, std::string const& expected) const {
        throw InputError(place(line) + ": " + found + ", expected " + expected);
    }
    std::string place(std::size_t line) const { return name_ + ":" + std::to_string(line); }
    std::string place_of(pugi::xml_node const& node) const { return place(line_of(node.offset_debug())); }
    /// Counts on from where it was asked last: a report may have many loops.
    std::size_t line_of(std::ptrdiff_t offset) const {
        auto const end = std::min(text_.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, offset)));
        if (end < counted_to_) {
            counted_to_ = 0;
            line_ = 1;
        }
        line_ += static_cast<std::size_t>(std::count(text_.data() + counted_to_, text_.data() + end, '\n'));
        counted_to_ = end;
        return line_;
    }
    std::uint64_t whole_number(pugi::xml_node const& at, std::string const& what, std::string_view digits) const {
        std::uint64_t value = 0;
        auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc() || end != digits.data() + digits.size() || value > 1'000'000'000'000)
            fail(line_of(at.offset_debug()), what + " = " + std::string(digits), "a whole number of at most 10^12");
        return value;
    }

    /// A number, the end of a range, or what a tool writes where it does not know.
    std::optional<std::uint64_t> number(pugi::xml_node const& loop, char const* element) const {
        pugi::xml_node at = loop.child(element);
        for (char const* const inner : {"range", "max"})
            if (at.child(inner))
                at = at.child(inner);
        std::string const text(trimmed(at.child_value()));
        if (text.empty() || text == "undef" || text == "-" || text == "?")
            return std::nullopt;
        return whole_number(at, std::string(element) + " of " + loop.name(), text);
    }

    void read_loops(std::string const& module, pugi::xml_node const& of) {
        pugi::xml_node const loops = of.child("PerformanceEstimates").child("SummaryOfLoopLatency");
        for (pugi::xml_node const loop : loops.children())
            if (is_loop(loop))
                read_loop(module, loop, 0);
    }
    static bool is_loop(pugi::xml_node const& node) {
        constexpr std::array figures{"TripCount", "Latency", "IterationLatency", "PipelineII", "PipelineDepth"};
        return std::any_of(figures.begin(), figures.end(), [&](char const* figure) { return node.child(figure); });
    }

    void read_loop(std::string const& module, pugi::xml_node const& node, unsigned level) {
        if (level > deepest_loop)
            fail(line_of(node.offset_debug()), "a loop in more than 100 others", "fewer");
        ReportLoop loop;
        loop.module = module;
        loop.place = place_of(node);
        loop.name = node.child("Name") ? trimmed(node.child_value("Name")) : node.name();
        loop.ii = number(node, "PipelineII");
        loop.depth = number(node, "PipelineDepth");
        loop.iteration_latency = number(node, "IterationLatency");
        for (pugi::xml_node const inner : node.children())
            loop.is_around_others = loop.is_around_others || is_loop(inner);
        report_.loops.push_back(loop);
        for (pugi::xml_node const inner : node.children())
            if (is_loop(inner))
                read_loop(module, inner, level + 1);
    }

    /// Vitis HLS tells them as bound nodes; those that have a depth.
    void read_fifos(pugi::xml_node const& profile) {
        for (pugi::xpath_node const& found : profile.select_nodes(".//BindNode[@OPTYPE='fifo'][@DEPTH]")) {
            pugi::xml_node const node = found.node();
            std::string const depth(trimmed(node.attribute("DEPTH").value()));
            if (!depth.empty())
                report_.fifos.push_back({node.attribute("VARIABLE").value(),
                                         whole_number(node, "DEPTH of a BindNode", depth), place_of(node)});
        }
    }

    std::string const& name_;
    std::string_view text_;
    pugi::xml_document document_;
    SynthesisReport report_;
    mutable std::size_t counted_to_ = 0;  ///< in the text
    mutable std::size_t line_ = 1;        ///< there
};

auto figures_of(ReportLoop const& loop) {
    return std::tie(loop.module, loop.name, loop.ii, loop.depth, loop.iteration_latency, loop.is_around_others);
}
auto figures_of(ReportFifo const& fifo) { return std::tie(fifo.name, fifo.depth); }

template <class Part> void add_new(std::vector<Part>& all, std::vector<Part> const& more) {
    for (Part const& one : more)
        if (std::none_of(all.begin(), all.end(),
                         [&](Part const& other) { return figures_of(one) == figures_of(other); }))
            all.push_back(one);
}

}  // namespace

SynthesisReport parse_synthesis_report(std::string const& name, std::string_view text) {
    return ReportReader(name, text).read();
}

SynthesisReport read_synthesis_reports(std::vector<std::string> const& files) {
    SynthesisReport all;
    for (std::string const& file : files) {
        SynthesisReport const one =
            parse_synthesis_report(file, io::read_file(file, "a synthesis report", most_report_bytes));
        all.version = one.version;
        add_new(all.loops, one.loops);
        add_new(all.fifos, one.fifos);
    }
    if (all.loops.empty())
        throw InputError(files.front() +
                         ": no loop, expected SummaryOfLoopLatency with one; some tools write a report " +
                         "for each process, PROCESS_csynth.xml");
    return all;
}

}  // namespace dataflow::schedule
