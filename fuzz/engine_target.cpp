#include "fuzz/engine_target.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/zstd_frame.hpp"
#include "dataflow/base/fnv1a.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/events/event_file_format.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "faster/dataflow_names.hpp"
#include "support/random_stimulus.hpp"
#include "support/raster_machine.hpp"
#include "support/run_cells.hpp"
#include "support/temp_folder.hpp"
#include "support/test_run.hpp"

namespace faster::fuzz {

namespace {

using namespace faster::testing;

constexpr std::size_t most_content = std::size_t{1} << 26U;

Stimulus small_stimulus(std::uint64_t seed) {
    RandomStimulusOptions options;
    options.width = options.height = {24, 40};
    options.window = {8, 20};
    options.samples = {0, 5};
    options.triangles = {0, 8};
    return random_stimulus(seed, options);
}

AcceleratorConfig any_config(std::uint64_t seed, Stimulus const& stimulus, bool is_deadlock_free) {
    RandomConfigOptions options;
    options.cores = {1, 4};
    options.any_scan = options.any_clearing = options.any_buffers = options.any_region = true;
    options.is_deadlock_free = is_deadlock_free;
    AcceleratorConfig config = random_config(seed, options);
    adopt(stimulus, config);
    return config;
}

void require_same(RunStatistics const& a, RunStatistics const& b, char const* what) {
    if (a.deadlocked() != b.deadlocked())
        throw std::logic_error(std::string(what) + ": one deadlocks");
    std::string const difference = first_difference(all_cells(a), all_cells(b));
    if (!difference.empty())
        throw std::logic_error(std::string(what) + ": " + difference);
}

/// `config` with the depths, latencies, intervals and ports of another.
AcceleratorConfig with_timing_of(AcceleratorConfig const& other, AcceleratorConfig config) {
    config.fifos = other.fifos;
    config.loops = other.loops;
    config.cores = other.cores;
    return config;
}

/// The contents of an event file without seals.
struct Unsealed {
    std::string header;
    Json index;
    std::vector<std::string> samples;
};

std::string content_at(std::string const& file, std::uint64_t at, std::uint64_t bytes) {
    auto content = io::content_of_zstd_frame(std::string_view(file).substr(at, bytes), most_content);
    if (!content)
        throw std::logic_error("a sound event file has a damaged frame");
    return *content;
}

Unsealed unsealed(std::string const& file) {
    std::string_view const closing = std::string_view(file).substr(file.size() - events::closing_bytes);
    auto const index_at = events::from_little_endian<std::uint64_t>(closing);
    auto const header_bytes = events::from_little_endian<std::uint32_t>(std::string_view(file).substr(12));
    Unsealed parts;
    parts.header = content_at(file, events::opening_bytes, header_bytes);
    parts.index = Json::parse(content_at(file, index_at, file.size() - events::closing_bytes - index_at));
    std::uint64_t at = events::opening_bytes + header_bytes;
    for (Json const& row : parts.index.at("samples")) {
        parts.samples.push_back(content_at(file, at, row.at(0)));
        at += row.at(0).get<std::uint64_t>();
    }
    return parts;
}

/// An event file of these contents, whose checksums and lengths are right.
std::string sealed(Unsealed const& parts, std::string const& index_text) {
    io::ZstdPress press;
    std::string const header = press.frame(parts.header);
    std::string file = std::string(events::opening_mark) + events::little_endian(events::format_version) +
                       events::little_endian(static_cast<std::uint32_t>(header.size())) + header;
    Json index = Json::parse(index_text, nullptr, false);
    if (index.is_object() && index.contains("samples") && index["samples"].is_array()) {
        index["header_checksum"] = io::checksum_of_zstd_frame(header);
        for (std::size_t i = 0; i < std::min(parts.samples.size(), index["samples"].size()); ++i) {
            std::string const frame = press.frame(parts.samples[i]);
            Json& row = index["samples"][i];
            if (row.is_array() && row.size() > 2) {
                row[0] = frame.size();
                row[1] = parts.samples[i].size();
                row[2] = io::checksum_of_zstd_frame(frame);
            }
            file += frame;
        }
    }
    std::string const frame = press.frame(index.is_discarded() ? index_text : io::text_of(index));
    std::uint64_t const at = file.size();
    return file + frame + events::little_endian(at) + events::little_endian(std::uint64_t{frame.size()}) +
           std::string(events::closing_mark);
}

std::string bytes_of(std::filesystem::path const& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

Unsealed recorded_parts() {
    test::TempFolder const folder;
    Stimulus const stimulus = small_stimulus(7);
    AcceleratorConfig config;
    config.cores = 2;
    adopt(stimulus, config);
    TestRunOptions options;
    options.events = folder / "a.events";
    test_run(config, stimulus, Engine::decoupled, options);
    return unsealed(bytes_of(options.events));
}

void change(std::string& text, std::string_view& bytes) {
    auto const number = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
    std::size_t const place = text.empty() ? 0 : (number(1) + 256 * number(2)) % (text.size() + 1);
    std::size_t const gone = number(3);
    std::size_t const comes = std::min(number(4), bytes.size() - 5);
    text.replace(place, gone, bytes.substr(5, comes));
    bytes.remove_prefix(5 + comes);
}

}  // namespace

void run_engine(std::string_view bytes) {
    Fnv1a hash;
    hash.add(bytes.substr(0, 8));
    std::uint64_t const seed = hash.value();
    Stimulus const stimulus = small_stimulus(seed);
    AcceleratorConfig const config = any_config(seed, stimulus, seed % 3 != 0);
    test::TempFolder const folder;
    TestRunOptions recording;
    recording.events = folder / "a.events";
    RunStatistics const decoupled = test_run(config, stimulus, Engine::decoupled, recording).statistics;
    require_same(decoupled, test_run(config, stimulus, Engine::lockstep).statistics, "engines");
    if (decoupled.deadlocked())
        return;
    AcceleratorConfig const other = with_timing_of(any_config(seed + 1, stimulus, seed % 5 != 0), config);
    events::EventFile const recorded = events::read_event_file(recording.events);
    require_same(replay::retime(recorded.run, raster_machine(other)),
                 test_run(other, stimulus, Engine::decoupled).statistics, "whatif");
}

void run_events(std::string_view bytes) {
    static Unsealed const original = recorded_parts();
    Unsealed parts = original;
    std::string index = io::text_of(parts.index);
    while (bytes.size() >= 5) {
        std::size_t const part = static_cast<unsigned char>(bytes[0]) % (2 + parts.samples.size());
        change(part == 0 ? parts.header : part == 1 ? index : parts.samples[part - 2], bytes);
    }
    test::TempFolder const folder;
    auto const file = folder.write("a.events", sealed(parts, index));
    events::EventFile const read = events::read_event_file(file);
    replay::retime(read.run, machine_of(read.loaded.config));
}

}  // namespace faster::fuzz
