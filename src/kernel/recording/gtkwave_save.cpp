#include "kernel/recording/gtkwave_save.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <iterator>

#include "faster/parts.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/recording/bram_ports.hpp"

namespace faster::recording {

namespace {

// GTKWave's trace flags.
constexpr unsigned decimal = 0x24, binary = 0x28, signed_decimal = 0x424, translated = 0x2022;
constexpr unsigned group_begin = 0x800200, group_end = 0x1000200, closed = 0x400000;

constexpr double first_cycles = 300;  // shown at first
constexpr double ticks_across = 5;    // marks of the time axis, 200 pixels apart

class SaveText {
  public:
    void flags(unsigned value) { put("@{:x}\n", value); }
    void open_group(std::string const& name, bool is_closed) {
        flags(group_begin | (is_closed ? closed : 0U));
        put("-{}\n", name);
    }
    void close_group(std::string const& name) {
        flags(group_end);
        put("-{}\n", name);
    }
    void signal(unsigned radix, std::string const& path, unsigned bits) {
        flags(radix);
        put("{}{}\n", path, range(bits));
    }
    void translated_signal(std::string const& path, std::string const& table) {
        flags(translated);
        put("^1 {}\n", table);
        put("{}[7:0]\n", path);
    }
    std::string const& text() const { return text_; }

    template <class... Arguments> void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    }

  private:
    static std::string range(unsigned bits) { return bits > 1 ? fmt::format("[{}:0]", bits - 1) : ""; }
    std::string text_;
};

struct Tables {
    std::string states;
    std::string stalls;
};

void add_module(SaveText& save, std::string const& path, std::string const& name, Tables const& tables) {
    save.open_group(name, false);
    save.translated_signal(path + ".state", tables.states);
    save.translated_signal(path + ".stall", tables.stalls);
    save.signal(decimal, path + ".iteration", 32);
    save.close_group(name);
}

void add_fifo(SaveText& save, std::string const& path, RecordedCore const& core, std::size_t fifo) {
    save.signal(decimal, path + ".occupancy", bits_for(core.fifos[fifo].capacity));
    for (char const* const name : {"full", "empty", "write", "read"})
        save.signal(binary, fmt::format("{}.{}", path, name), 1);
    for (char const* const side : {"written", "read"})
        for (TokenField const& field : core.token_layouts[fifo])
            save.signal(field.is_signed ? signed_decimal : decimal, fmt::format("{}.{}_{}", path, side, label(field)),
                        field.bits);
}

void add_bram(SaveText& save, std::string const& path, AcceleratorConfig const& config, std::size_t bram) {
    auto const side = static_cast<std::uint64_t>(config.window);
    for (std::string const& port : bram_port_names(static_cast<BramId>(bram), config)) {
        save.signal(binary, fmt::format("{}.{}_enable", path, port), 1);
        save.signal(binary, fmt::format("{}.{}_write_enable", path, port), 1);
        save.signal(decimal, fmt::format("{}.{}_address", path, port), bits_for(side * side - 1));
    }
}

void add_core(SaveText& save, AcceleratorConfig const& config, RecordedCore const& core, SignalFilter const& filter,
              Tables const& tables) {
    std::string const name = fmt::format("core_{}", core.core);
    std::string const path = "accelerator." + name;
    save.open_group(name, false);
    for (char const* const number : {"started", "ended"})
        save.signal(decimal, fmt::format("{}.sample.{}", path, number), 32);
    for (std::size_t module = 0; module < module_count; ++module)
        if (filter.shows(static_cast<ModuleId>(module)))
            add_module(save, fmt::format("{}.{}", path, module_names[module]), module_names[module], tables);
    for (std::size_t fifo = 0; fifo < fifo_count; ++fifo) {
        if (!filter.shows(static_cast<FifoId>(fifo)))
            continue;
        std::string const group = fmt::format("fifo {}", fifo_names[fifo]);
        save.open_group(group, true);
        add_fifo(save, fmt::format("{}.fifo_{}", path, fifo_names[fifo]), core, fifo);
        save.close_group(group);
    }
    for (std::size_t bram = 0; bram < bram_count; ++bram) {
        if (!filter.shows(static_cast<BramId>(bram)))
            continue;
        std::string const group = fmt::format("bram {}", bram_names[bram]);
        save.open_group(group, true);
        add_bram(save, fmt::format("{}.bram_{}", path, bram_names[bram]), config, bram);
        save.close_group(group);
    }
    save.close_group(name);
}

std::string state_table(Parts const& parts) {
    std::string text = fmt::format("{:02X} -\n", between_loops);
    for (std::size_t const loop : loops_of(parts))
        text += fmt::format("{:02X} {}\n", in_loop(loop), loop_names[loop].name);
    return text;
}

std::string stall_table(Parts const& parts) {
    std::string text = fmt::format("{:02X} -\n", no_stall);
    for (std::size_t const fifo : fifos_of(parts))
        for (bool const is_full : {false, true})
            text +=
                fmt::format("{:02X} {} {}\n", stall_on(fifo, is_full), fifo_names[fifo], is_full ? "full" : "empty");
    return text;
}

void write(std::filesystem::path const& file, std::string const& text) {
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
        throw InputError(
            fmt::format("{}: cannot be written, expected a file in a folder that is there", file.string()));
}

}  // namespace

void write_gtkwave_save(std::filesystem::path const& vcd, AcceleratorConfig const& config,
                        std::vector<RecordedCore> const& cores, SignalFilter const& filter) {
    auto const beside = [&vcd](char const* ending) {
        return std::filesystem::absolute(std::filesystem::path(vcd).replace_extension(ending)).lexically_normal();
    };
    Tables const tables{beside(".states.txt").string(), beside(".stalls.txt").string()};
    SaveText save;
    // The zoom is the logarithm of the time between two marks.
    double const ticks = ticks_per_cycle(config.clock_mhz);
    double const zoom = std::log2(first_cycles / ticks_across * ticks);
    Cycles first = cores.empty() ? 0 : ~Cycles{0};
    for (RecordedCore const& core : cores)
        first = std::min(first, core.from);
    save.put("[*] faster-sim\n[dumpfile] \"{}\"\n", std::filesystem::absolute(vcd).lexically_normal().string());
    save.put("[timestart] {}\n", std::llround(static_cast<double>(first) * ticks));
    save.put("[size] 1500 950\n[pos] -1 -1\n*{:.6f} 0\n[sst_width] 200\n[signals_width] 260\n", -zoom);
    for (RecordedCore const& core : cores)
        add_core(save, config, core, filter, tables);
    write(tables.states, state_table(Parts(config)));
    write(tables.stalls, stall_table(Parts(config)));
    write(beside(".gtkw"), save.text());
}

}  // namespace faster::recording
