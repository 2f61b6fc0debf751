#include "dataflow/run/events/event_file.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <ostream>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/files/zstd_frame.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/events/event_file_format.hpp"
#include "dataflow/run/events/machine_json.hpp"

namespace dataflow::events {

namespace {

constexpr std::size_t most_header_bytes = std::size_t{1} << 24;
constexpr std::size_t most_index_bytes = std::size_t{1} << 27;  // a million samples take 100 MB
constexpr std::uint64_t most_block_bytes = std::uint64_t{1} << 28;

/// Reads an event file from both ends.
class EventFileReader {
  public:
    explicit EventFileReader(std::filesystem::path const& path) : path_(path) {
        io::require_file(path);
        stream_.open(path, std::ios::binary | std::ios::ate);
        size_ = stream_ ? static_cast<std::uint64_t>(stream_.tellg()) : 0;
    }

    EventFile read() {
        EventFile file;
        read_opening();
        read_closing();
        try {
            Json const index = frame_at(index_at_, index_bytes_, most_index_bytes, "index");
            Json const header = frame_at(opening_bytes, header_bytes_, most_header_bytes, "header");
            if (index.at("header_checksum") != header_checksum_)
                fail("its header does not belong to its index, expected both from one run");
            require_own(header);
            read_configuration(header.at("configuration"), file.loaded);
            read_machine(header.at("machine"), machine_of(file.loaded.config), file.run);
            read_samples(index.at("samples"), file);
            read_memory(index, machine_of(file.loaded.config), file.samples.size(), file.run);
            file.summary = index.at("summary").dump();
            file.function = header.value("function", "");
        } catch (Json::exception const& error) {
            fail_version(error.what());
        } catch (std::invalid_argument const& error) {
            fail_version(error.what());
        }
        return file;
    }

    std::string program() {
        read_opening();
        read_closing();
        try {
            return frame_at(opening_bytes, header_bytes_, most_header_bytes, "header").value("program", program_name());
        } catch (Json::exception const& error) {
            fail_version(error.what());
        }
    }

  private:
    [[noreturn]] void fail(std::string const& what) const { throw InputError(path_.string() + ": " + what); }
    [[noreturn]] void fail_version(std::string const& what) const {
        fail(fmt::format(
            "is not as this faster-sim writes it ({}), expected a file of the same version; record it anew", what));
    }

    void require_own(Json const& header) const {
        std::string const program = header.value("program", program_name());
        if (program != program_name())
            fail(
                fmt::format("was recorded by {0}, which alone knows its design, expected a file of {1}; use {0} for it",
                            program, program_name()));
    }

    std::string bytes_at(std::uint64_t at, std::uint64_t count) {
        std::string bytes(count, '\0');
        stream_.seekg(static_cast<std::streamoff>(at));
        stream_.read(bytes.data(), static_cast<std::streamsize>(count));
        if (!stream_)
            fail("cannot be read, expected a readable file");
        return bytes;
    }

    void read_opening() {
        std::string const expected = "is no event file, expected what " + program_name() + " run --events wrote";
        if (size_ < opening_bytes)
            fail(expected);
        std::string const bytes = bytes_at(0, opening_bytes);
        std::string_view const view = bytes;
        if (view.substr(0, opening_mark.size()) != opening_mark)
            fail(expected);
        auto const version = from_little_endian<std::uint32_t>(view.substr(8));
        if (version != format_version)
            fail(fmt::format("is an event file of version {}, expected version {}", version, format_version));
        header_bytes_ = from_little_endian<std::uint32_t>(view.substr(12));
    }

    void read_closing() {
        std::string const cut_off =
            "is cut off, expected the whole file that " + program_name() + " run --events wrote";
        if (size_ < opening_bytes + closing_bytes)
            fail(cut_off);
        std::string const bytes = bytes_at(size_ - closing_bytes, closing_bytes);
        std::string_view const view = bytes;
        if (view.substr(16) != closing_mark)
            fail(cut_off);
        index_at_ = from_little_endian<std::uint64_t>(view);
        index_bytes_ = from_little_endian<std::uint64_t>(view.substr(8));
        std::uint64_t const end = size_ - closing_bytes;
        if (index_at_ > end || index_bytes_ != end - index_at_ ||
            index_at_ < opening_bytes + std::uint64_t{header_bytes_})
            fail("is damaged: its parts do not add up to its size, expected the file as it was written");
    }

    Json frame_at(std::uint64_t at, std::uint64_t bytes, std::size_t most, char const* what) {
        std::string const frame = bytes_at(at, bytes);
        auto const content = io::content_of_zstd_frame(frame, most);
        if (!content)
            fail(fmt::format("its {} is damaged, expected the file as it was written", what));
        header_checksum_ = io::checksum_of_zstd_frame(frame);
        return io::parse_json(*content);
    }

    void read_configuration(Json const& values, LoadedConfig& loaded) {
        RunConfig const defaults;
        Keys const keys = figure_keys();
        for (Key const& key : keys) {
            if (!values.contains(key.name()))
                throw std::invalid_argument("it has no key " + key.name());
            Json const& value = values.at(key.name());
            std::string const text = value.is_string() ? value.get<std::string>() : value.dump();
            for (std::string const& complaint : apply_override(key.name() + "=" + text, loaded))
                throw std::invalid_argument(complaint);
            bool const is_default = json_text(key.read(loaded.config)) == json_text(key.read(defaults));
            loaded.origins.record(key.name(), is_default ? KeyOrigin{} : KeyOrigin{KeySource::file, path_.string()});
        }
        if (values.size() != keys.size())
            throw std::invalid_argument("it has other keys");
    }

    void read_samples(Json const& rows, EventFile& file) {
        constexpr std::size_t before_counters = 6;
        std::vector<replay::OperationTape::Block> blocks;
        std::uint64_t at = opening_bytes + std::uint64_t{header_bytes_};
        for (Json const& row : rows) {
            auto const value = [&row](std::size_t i) { return row.at(i).get<std::uint64_t>(); };
            if (value(0) > index_at_ - at || value(1) > most_block_bytes)
                fail("is damaged: its samples do not add up to its size, expected the file as it was written");
            blocks.push_back({at, value(0), value(1), row.at(2).get<std::uint32_t>()});
            at += value(0);
            SampleStatistics sample{file.samples.size(), value(3), value(4), value(5), {}};
            std::size_t const end = std::min(row.size(), before_counters + design().counters().size());
            for (std::size_t i = before_counters; i < end; ++i)
                sample.counters.push_back(value(i));
            file.run.counters.push_back(sample.counters);
            file.samples.push_back(std::move(sample));
        }
        if (at != index_at_)
            fail("is damaged: its samples do not add up to its size, expected the file as it was written");
        file.run.tape = replay::OperationTape(path_, std::move(blocks));
    }

    std::filesystem::path path_;
    std::ifstream stream_;
    std::uint64_t size_ = 0;
    std::uint32_t header_bytes_ = 0;
    std::uint32_t header_checksum_ = 0;
    std::uint64_t index_at_ = 0;
    std::uint64_t index_bytes_ = 0;
};

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
    header["program"] = program_name();
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

EventFile read_event_file(std::filesystem::path const& path) { return EventFileReader(path).read(); }

std::string recording_program(std::filesystem::path const& path) { return EventFileReader(path).program(); }

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

}  // namespace dataflow::events
