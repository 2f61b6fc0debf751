#include "kernel/recording/gtkwave_save.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "kernel/base/files/hidden_name.hpp"
#include "kernel/base/files/output_file.hpp"
#include "kernel/base/printable.hpp"
#include "kernel/recording/port_names.hpp"
#include "kernel/recording/state_codes.hpp"

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
    void translated_signal(std::string const& path, unsigned bits, std::string const& table) {
        flags(translated);
        put("^1 {}\n", table);
        put("{}{}\n", path, range(bits));
    }
    std::string const& text() const { return text_; }

    template <class... Arguments> void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    }

  private:
    static std::string range(unsigned bits) { return bits > 1 ? fmt::format("[{}:0]", bits - 1) : ""; }
    std::string text_;
};

/// Files that translate numbers to names.
struct Tables {
    std::string states;
    std::string stalls;
};

void add_module(SaveText& save, std::string const& path, Machine const& machine, std::size_t module,
                Tables const& tables) {
    std::string const& name = machine.processes[module].name;
    save.open_group(name, false);
    save.translated_signal(path + ".state", state_bits(machine), printable(tables.states));
    save.translated_signal(path + ".stall", stall_bits(machine), printable(tables.stalls));
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

void add_memory(SaveText& save, std::string const& path, MachineMemory const& memory) {
    for (std::string const& port : port_names(memory)) {
        save.signal(binary, fmt::format("{}.{}_enable", path, port), 1);
        save.signal(binary, fmt::format("{}.{}_write_enable", path, port), 1);
        save.signal(decimal, fmt::format("{}.{}_address", path, port), address_bits(memory));
    }
}

void add_fifos(SaveText& save, std::string const& path, RecordedCore const& core, SignalFilter const& filter) {
    for (std::size_t fifo = 0; fifo < core.machine->fifos.size(); ++fifo) {
        if (!filter.shows_fifo(fifo))
            continue;
        std::string const& name = core.machine->fifos[fifo].name;
        save.open_group("fifo " + name, true);
        add_fifo(save, fmt::format("{}.fifo_{}", path, name), core, fifo);
        save.close_group("fifo " + name);
    }
}

void add_memories(SaveText& save, std::string const& path, Machine const& machine, SignalFilter const& filter) {
    for (std::size_t i = 0; i < machine.memories.size(); ++i) {
        if (!filter.shows_memory(i))
            continue;
        MachineMemory const& memory = machine.memories[i];
        save.open_group("bram " + memory.name, true);
        add_memory(save, fmt::format("{}.bram_{}", path, memory.name), memory);
        save.close_group("bram " + memory.name);
    }
}

void add_core(SaveText& save, RecordedCore const& core, SignalFilter const& filter, Tables const& tables) {
    Machine const& machine = *core.machine;
    std::string const name = fmt::format("core_{}", core.core);
    std::string const path = "accelerator." + name;
    save.open_group(name, false);
    for (char const* const number : {"started", "ended"})
        save.signal(decimal, fmt::format("{}.sample.{}", path, number), 32);
    for (std::size_t module = 0; module < machine.processes.size(); ++module)
        if (filter.shows_process(module))
            add_module(save, fmt::format("{}.{}", path, machine.processes[module].name), machine, module, tables);
    add_fifos(save, path, core, filter);
    add_memories(save, path, machine, filter);
    save.close_group(name);
}

/// A line of a table: a value as GTKWave shows it in hexadecimal, and what it means.
std::string translation(std::int64_t value, unsigned bits, std::string const& meaning) {
    return fmt::format("{:0{}X} {}\n", value, (bits + 3) / 4, meaning);
}

std::string state_table(Machine const& machine) {
    unsigned const bits = state_bits(machine);
    std::string text = translation(between_loops, bits, "-");
    for (std::size_t const loop : loops_of(machine))
        text += translation(in_loop(loop), bits, machine.loops[loop].name);
    return text;
}

std::string stall_table(Machine const& machine) {
    unsigned const bits = stall_bits(machine);
    std::string text = translation(no_stall, bits, "-");
    for (std::size_t const fifo : fifos_of(machine))
        for (bool const is_full : {false, true})
            text +=
                translation(stall_on(fifo, is_full), bits, machine.fifos[fifo].name + (is_full ? " full" : " empty"));
    if (machine.external_memory)
        text += translation(stall_on(machine, machine.fifos.size(), 0), bits, "memory");
    return text;
}

/// Where a file is in the end, from the root: GTKWave looks for tables in its own folder.
std::string final_name(std::filesystem::path const& file) {
    return io::without_hidden_names(std::filesystem::absolute(file).lexically_normal()).string();
}

}  // namespace

std::vector<std::filesystem::path> files_beside(std::filesystem::path const& vcd) {
    std::vector<std::filesystem::path> files;
    for (char const* ending : {".gtkw", ".states.txt", ".stalls.txt"})
        files.push_back(std::filesystem::path(vcd).replace_extension(ending));
    return files;
}

void write_gtkwave_save(std::filesystem::path const& vcd, Machine const& machine,
                        std::vector<RecordedCore> const& cores, SignalFilter const& filter) {
    std::vector<std::filesystem::path> const files = files_beside(vcd);
    Tables const tables{final_name(files[1]), final_name(files[2])};
    SaveText save;
    // The zoom is the logarithm of the time between two marks.
    double const ticks = ticks_per_cycle(machine.clock_mhz);
    double const zoom = std::log2(first_cycles / ticks_across * ticks);
    Cycles first = cores.empty() ? 0 : ~Cycles{0};
    for (RecordedCore const& core : cores)
        first = std::min(first, core.from);
    save.put("[*] faster-sim\n[dumpfile] \"{}\"\n", printable(final_name(vcd)));
    save.put("[timestart] {}\n", std::llround(static_cast<double>(first) * ticks));
    save.put("[size] 1500 950\n[pos] -1 -1\n*{:.6f} 0\n[sst_width] 200\n[signals_width] 260\n", -zoom);
    for (RecordedCore const& core : cores)
        add_core(save, core, filter, tables);
    io::write_file_atomically(files[1], state_table(machine));
    io::write_file_atomically(files[2], stall_table(machine));
    io::write_file_atomically(files[0], save.text());
}

}  // namespace faster::recording
