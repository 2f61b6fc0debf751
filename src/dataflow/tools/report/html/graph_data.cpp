#include "dataflow/tools/report/html/graph_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <iterator>
#include <sstream>
#include <string_view>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/program_output.hpp"

namespace dataflow::report {

namespace {

/// A node or edge of the drawing, by the name that the page knows it by.
struct Part {
    std::string id;
    std::string name;
};

/// What dot is asked to place. Names of a design never stand in it, only how much room they take.
class DotGraph {
  public:
    explicit DotGraph(char const* direction) {
        text_ = fmt::format(
            "digraph{{rankdir={};nodesep=0.25;ranksep=0.3;node[shape=box,fixedsize=true];edge[fontsize=14,"
            "fontname=\"Courier\",arrowsize=0.7];\n",
            direction);
    }
    /// `below`: the longest text below the name.
    void add_node(std::string const& id, std::string const& kind, std::string const& name, double height_inch,
                  std::string_view below = "") {
        constexpr double letter_inch = 0.1, small_letter_inch = 0.09, least_inch = 1.1;
        double const width = std::max({least_inch, letter_inch * static_cast<double>(name.size() + 2),
                                       small_letter_inch * static_cast<double>(below.size())});
        fmt::format_to(std::back_inserter(text_), "{}[width={:.2f},height={:.2f}];\n", id, width, height_inch);
        nodes_.push_back({id, kind + ":" + name});
    }
    /// `label`: how many letters it takes. dot's are larger: a line of them is as high as a gauge of the page, so that
    /// FIFOs between the same two processes do not cover one another's.
    void add_edge(std::string const& from, std::string const& to, std::string const& name, std::size_t label,
                  char const* more = "") {
        constexpr std::size_t letter = 11, letter_of_dot = 14;
        std::size_t const letters_of_dot = (label * letter + letter_of_dot - 1) / letter_of_dot;
        fmt::format_to(std::back_inserter(text_), "{}->{}[id=e{},label=\"{}\"{}];\n", from, to, edges_.size(),
                       std::string(letters_of_dot, 'x'), more);
        edges_.push_back({fmt::format("e{}", edges_.size()), name});
    }
    std::string text() const { return text_ + "}\n"; }
    std::vector<Part> const& nodes() const { return nodes_; }
    std::vector<Part> const& edges() const { return edges_; }

  private:
    std::string text_;
    std::vector<Part> nodes_;
    std::vector<Part> edges_;
};

std::string id(char kind, std::size_t number) { return kind + std::to_string(number); }

std::string stream_edge(MachineStream const& stream) { return "memory:" + stream.name; }
std::string owner_edge(MachineMemory const& memory) { return "bram:" + memory.name; }

/// Without those that the configuration has not.
std::vector<std::size_t> drawn_brams_of(Machine const& machine) {
    std::vector<std::size_t> brams = brams_of(machine);
    auto const is_nothing = [&machine](std::size_t i) { return machine.memories[i].shape.words == 0; };
    brams.erase(std::remove_if(brams.begin(), brams.end(), is_nothing), brams.end());
    return brams;
}

/// As long as the one that the page makes.
std::string ports_text(MachineMemory const& memory) {
    std::uint64_t const banks = memory.partition.banks();
    return (banks > 1 ? fmt::format("{} banks of ", banks) : "") + fmt::format("{} ports", memory.ports);
}

DotGraph graph_of(Machine const& machine, char const* direction) {
    DotGraph graph(direction);
    for (std::size_t const i : modules_of(machine))
        graph.add_node(id('p', i), "process", machine.processes[i].name, 0.55, "100.0 % of path");
    for (std::size_t const i : drawn_brams_of(machine))
        graph.add_node(id('m', i), "bram", machine.memories[i].name, 0.45, ports_text(machine.memories[i]));
    std::vector<std::size_t> const streams = machine.external_memory ? streams_of(machine) : std::vector<std::size_t>{};
    if (!streams.empty())
        graph.add_node("x0", "memory", "external memory", 0.45);
    for (std::size_t const i : fifos_of(machine)) {
        MachineFifo const& fifo = machine.fifos[i];
        graph.add_edge(id('p', fifo.writer), id('p', fifo.reader), "fifo:" + fifo.name, fifo.name.size() + 2);
    }
    for (std::size_t const i : drawn_brams_of(machine)) {
        MachineMemory const& memory = machine.memories[i];
        graph.add_edge(id('m', i), id('p', memory.owner), owner_edge(memory), 0, ",dir=none");
        if (memory.reader != memory.owner && machine.processes[memory.reader].is_present)
            graph.add_edge(id('m', i), id('p', memory.reader), owner_edge(memory) + ":reader", 0, ",dir=none");
    }
    for (std::size_t const i : streams) {
        MachineStream const& stream = machine.streams[i];
        std::string const process = id('p', stream.process);
        graph.add_edge(stream.writes ? process : "x0", stream.writes ? "x0" : process, stream_edge(stream), 0,
                       stream.writes ? ",constraint=false" : "");
    }
    return graph;
}

/// dot counts from the bottom up.
struct Frame {
    double height = 0;

    double number(double value) const { return std::round(value * 10) / 10; }
    Json point(std::string const& text) const {
        double x = 0, y = 0;
        char comma = 0;
        std::istringstream(text) >> x >> comma >> y;
        return {number(x), number(height - y)};
    }
};

/// "e,x,y x,y x,y ..." as the points of a curve: the first, and three for each further piece; the arrow's tip last.
Json curve(std::string const& text, Frame const& frame) {
    std::istringstream words(text);
    Json points = Json::array(), tip;
    for (std::string word; words >> word;)
        if (word.front() == 'e')
            tip = frame.point(word.substr(2));
        else
            points.push_back(frame.point(word));
    return {{"points", points}, {"tip", tip}};
}

double as_number(Json const& text) { return std::stod(text.get<std::string>()); }

Json placed_nodes(Json const& objects, std::vector<Part> const& nodes, Frame const& frame) {
    constexpr double points_per_inch = 72;
    Json placed = Json::object();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        Json const& object = objects.at(i);
        placed[nodes[i].name] = {{"at", frame.point(object.at("pos"))},
                                 {"width", as_number(object.at("width")) * points_per_inch},
                                 {"height", as_number(object.at("height")) * points_per_inch}};
    }
    return placed;
}

Json placed_edges(Json const& edges, std::vector<Part> const& names, Frame const& frame) {
    Json placed = Json::object();
    for (Json const& edge : edges)
        for (Part const& part : names)
            if (edge.at("id") == part.id) {
                placed[part.name] = curve(edge.at("pos"), frame);
                if (edge.contains("lp"))
                    placed[part.name]["label"] = frame.point(edge.at("lp"));
            }
    return placed;
}

/// Null without dot. Errors: HostError if it fails, or ends well and says nothing or half of it: some of its own errors
/// it does not look at.
Json layout(Machine const& machine, char const* direction) {
    DotGraph const graph = graph_of(machine, direction);
    std::optional<std::string> const output = program_output({"dot", "-Tjson0"}, graph.text());
    if (!output)
        return nullptr;
    try {
        Json const drawing = io::parse_json(*output);
        std::istringstream box(drawing.at("bb").get<std::string>());
        double left = 0, bottom = 0, width = 0, height = 0;
        char comma = 0;
        box >> left >> comma >> bottom >> comma >> width >> comma >> height;
        Frame const frame{height};
        return {{"width", width},
                {"height", height},
                {"nodes", placed_nodes(drawing.at("objects"), graph.nodes(), frame)},
                {"edges", placed_edges(drawing.value("edges", Json::array()), graph.edges(), frame)}};
    } catch (std::exception const&) {
        throw HostError(fmt::format("dot: wrote {} of the graph, expected a Graphviz that works",
                                    output->empty() ? "nothing" : "no more than a part"));
    }
}

Json fifo_edges(Machine const& machine) {
    Json rows = Json::array();
    for (std::size_t const i : fifos_of(machine))
        rows.push_back({{"fifo", machine.fifos[i].name},
                        {"writer", machine.processes[machine.fifos[i].writer].name},
                        {"reader", machine.processes[machine.fifos[i].reader].name}});
    return rows;
}

void put_for(std::string& text, std::string_view place, std::string const& value) {
    if (std::size_t const at = text.find(place); at != std::string::npos)
        text.replace(at, place.size(), value);
}

/// $FASTER_SOURCE_LINK, which tells where sources can be looked at: the address of a line. Empty: nowhere.
std::string source_link() {
    constexpr std::array schemes{"https://", "http://", "file://", "vscode://"};
    char const* const set = std::getenv("FASTER_SOURCE_LINK");
    std::string link = set == nullptr ? "" : set;
    bool const is_address = std::any_of(schemes.begin(), schemes.end(),
                                        [&link](std::string_view scheme) { return link.rfind(scheme, 0) == 0; });
    if (!link.empty() && !(is_address && link.find("{file}") != std::string::npos))
        throw InputError(
            fmt::format("FASTER_SOURCE_LINK: '{}', expected an address that begins with {} and has {{file}} "
                        "in it, and {{line}} if wanted",
                        printable(link), fmt::join(schemes, ", ")));
    return link;
}

/// Where each module is described: file and line, and the address of it if one is known.
Json source_data(Machine const& machine) {
    Json sources = Json::object();
    std::string const link = source_link();
    for (std::size_t const i : modules_of(machine)) {
        SourceSite const& site = machine.processes[i].described_at;
        if (*site.file == '\0')
            continue;
        Json& source = sources[machine.processes[i].name] = {{"file", site.file}, {"line", site.line}};
        if (link.empty())
            continue;
        std::string address = link;
        put_for(address, "{file}", site.file);
        put_for(address, "{line}", std::to_string(site.line));
        source["link"] = address;
    }
    return sources;
}

}  // namespace

Json memory_data(Machine const& machine) {
    Json rows = Json::array();
    for (std::size_t const i : brams_of(machine)) {
        MachineMemory const& memory = machine.memories[i];
        rows.push_back({{"bram", memory.name},
                        {"owner", machine.processes[memory.owner].name},
                        {"ports", memory.ports},
                        {"banks", memory.partition.banks()}});
    }
    return rows;
}

Json graph_data(Machine const& machine) {
    Json processes = Json::array();
    for (std::size_t const i : modules_of(machine))
        processes.push_back(machine.processes[i].name);
    return {{"processes", processes},           {"sources", source_data(machine)}, {"fifos", fifo_edges(machine)},
            {"memories", memory_data(machine)}, {"wide", layout(machine, "LR")},   {"tall", layout(machine, "TB")}};
}

}  // namespace dataflow::report
