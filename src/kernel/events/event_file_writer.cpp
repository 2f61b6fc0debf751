#include <ostream>

#include "kernel/base/files/json_file.hpp"
#include "kernel/base/files/zstd_frame.hpp"
#include "kernel/config/keys.hpp"
#include "kernel/config/resolved_config.hpp"
#include "kernel/events/event_file.hpp"
#include "kernel/events/event_file_format.hpp"
#include "kernel/events/machine_json.hpp"
#include "kernel/events/memory_json.hpp"

namespace faster::events {

namespace {

Json configuration_json(RunConfig const& config) {
    Json keys = Json::object();
    for (ResolvedKey const& key : resolved_keys(config))
        if (decides_figures(key.key))
            keys[key.key] = Json::parse(json_text(key.value));
    return keys;
}

std::string header_of(RunConfig const& config, replay::RecordedRun const& run, std::string const& function) {
    Json header;
    header["format"] = "faster-events";
    header["version"] = format_version;
    if (!function.empty())
        header["function"] = function;
    header["configuration"] = configuration_json(config);
    header["machine"] = machine_json(*run.blueprint);
    return io::text_of(header);
}

Json sample_json(replay::OperationTape::Block const& block, SampleStatistics const& sample) {
    Json row{block.bytes, block.content_bytes, block.checksum, sample.core, sample.start_cycle, sample.end_cycle};
    for (std::uint64_t const counter : sample.counters)
        row.push_back(counter);
    return row;
}

std::string index_of_file(std::string const& header, replay::RecordedRun const& run, RunStatistics const& statistics,
                          std::string const& summary) {
    Json index;
    index["header_checksum"] = io::checksum_of_zstd_frame(header);
    index["summary"] = Json::parse(summary);
    index["summary"].erase("host");
    for (Key const& key : all_keys())
        if (!key.decides_figures)
            index["summary"]["configuration"].erase(key.name());
    index["samples"] = Json::array();
    for (std::size_t i = 0; i < statistics.samples.size(); ++i)
        index["samples"].push_back(sample_json(run.tape.blocks()[i], statistics.samples[i]));
    if (run.memory)
        index["memory"] = memory_json(*run.memory);
    return io::text_of(index);
}

void put(std::string_view bytes, std::ostream& stream) {
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace

void write_event_file(io::OutputFile const& file, RunConfig const& config, replay::RecordedRun const& run,
                      RunStatistics const& statistics, std::string const& summary, std::string const& function) {
    file.commit([&](std::ostream& stream) {
        io::ZstdPress press;
        std::string const header = press.frame(header_of(config, run, function));
        put(std::string(opening_mark) + little_endian(format_version), stream);
        put(little_endian(static_cast<std::uint32_t>(header.size())) + header, stream);
        std::uint64_t at = opening_bytes + header.size();
        replay::OperationTape::Bytes block;
        for (std::size_t i = 0; i < run.tape.samples(); ++i) {
            run.tape.read_block(i, block);
            put({block.data(), block.size()}, stream);
            at += block.size();
        }
        std::string const index = press.frame(index_of_file(header, run, statistics, summary));
        put(index + little_endian(at) + little_endian(std::uint64_t{index.size()}), stream);
        put(closing_mark, stream);
    });
}

}  // namespace faster::events
