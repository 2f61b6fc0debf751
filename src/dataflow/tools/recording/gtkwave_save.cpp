#include "dataflow/tools/recording/gtkwave_save.hpp"

#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <iterator>
#include <map>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/tools/recording/state_codes.hpp"
#include "dataflow/tools/recording/waveform_file.hpp"

namespace dataflow::recording {

namespace {

// GTKWave's trace flags.
using Flags = std::uint64_t;
constexpr Flags decimal = 0x24, binary = 0x28, signed_decimal = 0x424, translated = 0x2022, named = 0x100000028;
constexpr Flags group_begin = 0x800200, group_end = 0x1000200;
constexpr Flags closed_group_begin = 0xc00200, closed_group_end = 0x1401200;

constexpr double first_cycles = 300;  // shown at first
constexpr double ticks_across = 5;    // marks of the time axis, 200 pixels apart

/// A table that GTKWave translates values by: as it shows them in hexadecimal, and what they mean.
std::string table_of(std::vector<std::string> const& names, unsigned bits) {
    std::string table;
    for (std::size_t value = 0; value < names.size(); ++value)
        if (!names[value].empty())
            table += fmt::format("{:0{}X} {}\n", value, (bits + 3) / 4, names[value]);
    return table;
}

/// The save file as far as it is written, and the tables that it names.
class Save {
  public:
    /// `stem`: of the waveform's name.
    Save(std::string stem, ValueNames names) : stem_(std::move(stem)), names_(names) {}

    void open_group(std::string const& name, bool is_closed) {
        flags(is_closed ? closed_group_begin : group_begin);
        put("-{}\n", name);
        groups_.push_back({name, is_closed});
    }
    void close_group() {
        flags(groups_.back().is_closed ? closed_group_end : group_end);
        put("-{}\n", groups_.back().name);
        groups_.pop_back();
    }
    void signal(Flags radix, std::string const& path, unsigned bits) {
        flags(radix);
        put("{}{}\n", path, range(bits));
    }
    void named_signal(std::string const& path, unsigned bits, std::string const& table,
                      std::vector<std::string> const& names) {
        if (names_ == ValueNames::in_waveform)
            return signal(named, path, bits);
        tables_[table] = table_of(names, bits);
        flags(translated);
        put("^1 {}\n{}{}\n", printable(name_of(table)), path, range(bits));
    }
    template <class... Arguments> void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
    }
    void write_to(std::filesystem::path const& folder) const {
        for (auto const& [table, text] : tables_)
            io::write_file_atomically(folder / name_of(table), text);
        io::write_file_atomically(folder / (stem_ + ".gtkw"), text_);
    }

  private:
    struct Group {
        std::string name;
        bool is_closed;
    };
    std::string name_of(std::string const& table) const { return stem_ + "." + table + ".txt"; }
    static std::string range(unsigned bits) { return bits > 1 ? fmt::format("[{}:0]", bits - 1) : ""; }
    void flags(Flags value) { put("@{:x}\n", value); }

    std::string stem_;
    ValueNames names_;
    std::string text_;
    std::vector<Group> groups_;
    std::map<std::string, std::string> tables_;
};

void add_module(Save& save, std::string const& path, Machine const& machine, std::size_t module) {
    save.open_group(machine.processes[module].name, false);
    save.named_signal(path + ".state", state_bits(machine), "states", state_names(machine));
    save.named_signal(path + ".stall", stall_bits(machine), "stalls", stall_names(machine));
    save.signal(decimal, path + ".iteration", 32);
    save.close_group();
}

void add_field(Save& save, std::string const& path, std::string const& fifo, TokenField const& field) {
    if (field.values != nullptr)
        return save.named_signal(path, field.bits, fmt::format("{}_{}", fifo, field.name), value_names(field));
    save.signal(field.is_signed ? signed_decimal : decimal, path, field.bits);
}

void add_fifo(Save& save, std::string const& path, RecordedCore const& core, std::size_t fifo) {
    std::string const& name = core.machine->fifos[fifo].name;
    save.open_group("fifo " + name, true);
    save.signal(decimal, path + ".occupancy", signal_bits(core.fifos[fifo].capacity));
    for (char const* const bit : {"full", "empty", "write", "read"})
        save.signal(binary, fmt::format("{}.{}", path, bit), 1);
    for (char const* const side : {"written", "read"})
        for (TokenField const& field : core.token_layouts[fifo])
            add_field(save, fmt::format("{}.{}_{}", path, side, label(field)), name, field);
    save.close_group();
}

void add_block_ram(Save& save, std::string const& path, MachineMemory const& memory) {
    save.open_group("bram " + memory.name, true);
    for (std::string const& port : port_names(memory)) {
        save.signal(binary, fmt::format("{}.{}_enable", path, port), 1);
        save.signal(binary, fmt::format("{}.{}_write_enable", path, port), 1);
        save.signal(decimal, fmt::format("{}.{}_address", path, port), address_bits(memory));
    }
    save.close_group();
}

void add_core(Save& save, RecordedCore const& core, SignalFilter const& filter) {
    Machine const& machine = *core.machine;
    std::string const name = fmt::format("core_{}", core.core);
    std::string const path = "accelerator." + name;
    save.open_group(name, false);
    for (char const* const number : {"started", "ended"})
        save.signal(decimal, fmt::format("{}.sample.{}", path, number), 32);
    for (std::size_t i = 0; i < machine.processes.size(); ++i)
        if (filter.shows_process(i))
            add_module(save, fmt::format("{}.{}", path, machine.processes[i].name), machine, i);
    for (std::size_t i = 0; i < machine.fifos.size(); ++i)
        if (filter.shows_fifo(i))
            add_fifo(save, fmt::format("{}.fifo_{}", path, machine.fifos[i].name), core, i);
    for (std::size_t i = 0; i < machine.memories.size(); ++i)
        if (filter.shows_memory(i))
            add_block_ram(save, fmt::format("{}.bram_{}", path, machine.memories[i].name), machine.memories[i]);
    save.close_group();
}

void add_external_memory(Save& save, std::size_t ports) {
    std::string const path = "accelerator.memory";
    save.open_group("memory", false);
    for (std::size_t port = 0; port < ports; ++port) {
        save.open_group(fmt::format("port {}", port), false);
        save.signal(binary, fmt::format("{}.port_{}.busy", path, port), 1);
        save.signal(decimal, fmt::format("{}.port_{}.waiting", path, port), 32);
        save.signal(decimal, fmt::format("{}.port_{}.bytes", path, port), 64);
        save.close_group();
    }
    save.signal(binary, path + ".controller.busy", 1);
    save.signal(decimal, path + ".controller.queue", 32);
    save.close_group();
}

}  // namespace

std::vector<std::filesystem::path> files_beside(std::filesystem::path const& waveform, ValueNames names) {
    std::vector<char const*> endings{".gtkw"};
    if (names == ValueNames::in_tables)
        endings.insert(endings.end(), {".states.txt", ".stalls.txt"});
    std::vector<std::filesystem::path> files;
    files.reserve(endings.size());
    for (char const* const ending : endings)
        files.push_back(std::filesystem::path(waveform).replace_extension(ending));
    return files;
}

void write_gtkwave_save(std::filesystem::path const& waveform, ValueNames names, Machine const& machine,
                        RecordedWindow const& window, SignalFilter const& filter) {
    std::string const stem = waveform.stem().string();
    Save save(stem, names);
    // The zoom is the logarithm of the time between two marks.
    double const ticks = ticks_per_cycle(machine.clock_mhz);
    double const zoom = std::log2(first_cycles / ticks_across * ticks);
    save.put("[*] faster-sim\n[dumpfile] \"{}\"\n[savefile] \"{}\"\n", printable(waveform.filename().string()),
             printable(stem + ".gtkw"));
    save.put("[timestart] {}\n", std::llround(static_cast<double>(window.from()) * ticks));
    save.put("[size] 1500 950\n[pos] -1 -1\n*{:.6f} 0\n[sst_width] 200\n[signals_width] 260\n", -zoom);
    save.signal(binary, "accelerator.clock", 1);
    save.signal(decimal, "accelerator.cycle", bits_of_cycle);
    for (RecordedCore const& core : window.cores)
        add_core(save, core, filter);
    if (window.memory != nullptr && !window.cores.empty() && filter.shows_external_memory())
        add_external_memory(save, window.memory->shape.ports);
    save.write_to(std::filesystem::absolute(waveform).parent_path());
}

}  // namespace dataflow::recording
