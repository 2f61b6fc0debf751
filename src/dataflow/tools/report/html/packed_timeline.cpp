#include "dataflow/tools/report/html/packed_timeline.hpp"

#include <map>
#include <stdexcept>
#include <tuple>
#include <vector>
#include <zlib.h>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/tools/report/html/html_text.hpp"
#include "dataflow/tools/report/html/timeline_data.hpp"

namespace dataflow::report {

namespace {

constexpr Cycles finer = 8;  // a level than the one before

struct Level {
    Cycles resolution = 0;
    std::vector<MergedSpan> bars;
};

/// A level is left out where the next has not twice as many bars.
std::vector<Level> levels_of(SampleTimeline const& timeline, std::size_t most_bars) {
    std::vector<Level> levels;
    for (Cycles resolution = coarse_resolution(timeline);; resolution /= finer) {
        Level level{resolution, merged_spans(timeline.spans, resolution)};
        if (!levels.empty() && level.bars.size() > most_bars)
            break;
        if (!levels.empty() && level.bars.size() < 2 * levels.back().bars.size())
            levels.pop_back();
        levels.push_back(std::move(level));
        if (resolution == 0)
            break;
    }
    return levels;
}

/// Numbers things in the order in which they occur.
class Items {
  public:
    explicit Items(Machine const& machine) : machine_(machine) {}

    std::size_t number_of(TimelineSpan const& span) {
        auto const [at, is_new] = numbers_.try_emplace({span.module, span.kind, span.item}, numbers_.size());
        if (is_new)
            names_.push_back(span_item(machine_, span));
        return at->second;
    }
    Json const& names() const { return names_; }

  private:
    Machine const& machine_;
    std::map<std::tuple<std::size_t, TimelineSpan::Kind, std::size_t>, std::size_t> numbers_;
    Json names_ = Json::array();
};

Json columns_of(Level const& level, Cycles begin, Items& items) {
    Json columns{{"resolution", level.resolution}};
    for (MergedSpan const& bar : level.bars) {
        Cycles const length = bar.extent.end - bar.extent.begin;
        columns["item"].push_back(items.number_of(bar.extent));
        columns["begin"].push_back(bar.extent.begin - begin);
        columns["length"].push_back(length);
        columns["gaps"].push_back(length - bar.cycles);
        columns["iterations"].push_back(iterations_of(bar));
        columns["spans"].push_back(bar.spans);
        begin = bar.extent.begin;
    }
    return columns;
}

std::string deflated(std::string const& text) {
    std::vector<Bytef> bytes(compressBound(text.size()));
    uLongf length = bytes.size();
    if (compress2(bytes.data(), &length, reinterpret_cast<Bytef const*>(text.data()),  // NOLINT: bytes as zlib has them
                  text.size(), Z_BEST_COMPRESSION) != Z_OK)
        throw std::runtime_error("zlib cannot compress a timeline");
    return {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)};
}

}  // namespace

PackedTimeline packed_timeline(Machine const& machine, SampleTimeline const& timeline, std::size_t most_bars) {
    Items items(machine);
    Json levels = Json::array();
    for (Level const& level : levels_of(timeline, most_bars))
        levels.push_back(columns_of(level, timeline.begin, items));
    Json const data{{"items", items.names()}, {"levels", levels}, {"occupancy", occupancy_data(machine, timeline)}};
    return {timeline.core, timeline.sample, timeline.begin, timeline.end, base64(deflated(io::text_of(data)))};
}

Json packed_timeline_json(PackedTimeline const& timeline, std::vector<std::string> const& is) {
    return {{"sample", timeline.sample},
            {"core", timeline.core},
            {"begin", timeline.begin},
            {"end", timeline.end},
            {"is", is},
            {"packed", timeline.packed}};
}

}  // namespace dataflow::report
