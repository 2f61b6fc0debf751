#include "recording/vcd_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fmt/format.h>

#include "common/input_error.hpp"

namespace faster::recording {

namespace {
constexpr std::size_t buffer_size = 1U << 20;

/// Whole nanoseconds, if a cycle is a whole number of them.
bool counts_in_ns(double clock_mhz) {
    double const ns = 1e3 / clock_mhz;
    return std::abs(ns - std::round(ns)) < 1e-9;
}
}  // namespace

VcdFile::VcdFile(std::filesystem::path const& file, double clock_mhz)
    : name_(file.string()), file_(std::fopen(file.c_str(), "wb")) {
    if (file_ == nullptr)
        throw InputError(fmt::format("{}: cannot be written: {}, expected a file in a folder that is there", name_,
                                     std::strerror(errno)));
    bool const in_ns = counts_in_ns(clock_mhz);
    ticks_per_cycle_ = in_ns ? std::round(1e3 / clock_mhz) : 1e6 / clock_mhz;
    buffer_.reserve(buffer_size + 4096);
    put_text(fmt::format("$version faster-sim {} $end\n$comment {:g} MHz $end\n$timescale 1 {} $end\n", FASTER_VERSION,
                         clock_mhz, in_ns ? "ns" : "ps"));
}

VcdFile::~VcdFile() = default;

std::string VcdFile::id_of(std::size_t number) {
    std::string id;
    do {
        id += static_cast<char>('!' + number % 94);
        number /= 94;
    } while (number > 0);
    return id;
}

void VcdFile::open_scope(std::string const& name) { put_text(fmt::format("$scope module {} $end\n", name)); }
void VcdFile::close_scope() { put_text("$upscope $end\n"); }

VcdFile::Signal VcdFile::add(std::string const& name, unsigned bits, std::size_t domain) {
    Variable variable;
    variable.id = id_of(variables_.size());
    variable.bits = bits;
    variable.domain = domain;
    std::string const range = bits > 1 ? fmt::format(" [{}:0]", bits - 1) : "";
    put_text(fmt::format("$var wire {} {} {}{} $end\n", bits, variable.id, name, range));
    variables_.push_back(variable);
    return variables_.size() - 1;
}

void VcdFile::begin(std::vector<std::pair<Cycles, Cycles>> windows) {
    windows_ = std::move(windows);
    first_ = ~Cycles{0};
    for (auto const& [first, last] : windows_) {
        first_ = std::min(first_, first);
        last_ = std::max(last_, last);
    }
    put_text("$enddefinitions $end\n");
    for (std::size_t domain = 0; domain < windows_.size(); ++domain)
        touch_domain(domain);
}

void VcdFile::touch(Signal signal) {
    if (variables_[signal].is_dirty)
        return;
    variables_[signal].is_dirty = true;
    dirty_.push_back(signal);
}

void VcdFile::touch_domain(std::size_t domain) {
    for (Signal signal = 0; signal < variables_.size(); ++signal)
        if (variables_[signal].domain == domain)
            touch(signal);
}

void VcdFile::set(Signal signal, std::int64_t value) {
    Variable& variable = variables_[signal];
    std::uint64_t const mask = variable.bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << variable.bits) - 1;
    variable.value = static_cast<std::uint64_t>(value) & mask;
    touch(signal);
}

void VcdFile::schedule(Cycles cycle, Signal signal, std::int64_t value) {
    later_.push({cycle, scheduled_++, signal, value});
}

/// Stops at every cycle in which something changes: at what is scheduled, and where a window begins or is over.
void VcdFile::advance(Cycles cycle) {
    while (cycle_ < cycle) {
        Cycles stop = later_.empty() ? cycle : std::min(cycle, std::max(later_.top().cycle, cycle_ + 1));
        for (auto const& [first, last] : windows_)
            for (Cycles const border : {first, last + 1})
                if (border > cycle_ && border < stop)
                    stop = border;
        flush_cycle();
        cycle_ = stop;
        for (std::size_t domain = 0; domain < windows_.size(); ++domain)
            if (cycle_ == windows_[domain].first || cycle_ == windows_[domain].second + 1)
                touch_domain(domain);
        for (; !later_.empty() && later_.top().cycle <= cycle_; later_.pop())
            set(later_.top().signal, later_.top().value);
    }
}

void VcdFile::flush_cycle() {
    if (cycle_ < first_ || cycle_ > last_ + 1)
        return;
    bool has_time = false;
    for (Signal const signal : dirty_) {
        Variable& variable = variables_[signal];
        variable.is_dirty = false;
        bool const known = is_in_window(variable.domain);
        bool const same =
            variable.is_written && known == variable.was_known && (!known || variable.value == variable.written);
        if (same)
            continue;
        if (!has_time)
            put_text(fmt::format("#{}\n", std::llround(static_cast<double>(cycle_) * ticks_per_cycle_)));
        has_time = true;
        put_value(variable, known);
        variable.is_written = true;
        variable.was_known = known;
        variable.written = variable.value;
    }
    dirty_.clear();
}

void VcdFile::put_value(Variable const& variable, bool known) {
    char text[96];
    char* at = text;
    if (variable.bits > 1)
        *at++ = 'b';
    if (!known) {
        *at++ = 'x';
    } else {
        unsigned const bits = variable.value == 0 ? 1 : 64U - static_cast<unsigned>(__builtin_clzll(variable.value));
        for (unsigned bit = bits; bit-- > 0;)
            *at++ = ((variable.value >> bit) & 1U) != 0 ? '1' : '0';
    }
    if (variable.bits > 1)
        *at++ = ' ';
    for (char const letter : variable.id)
        *at++ = letter;
    *at++ = '\n';
    put(text, static_cast<std::size_t>(at - text));
}

void VcdFile::put(char const* text, std::size_t size) {
    buffer_.append(text, size);
    if (buffer_.size() >= buffer_size)
        write_out();
}

void VcdFile::write_out() {
    if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size())
        throw InputError(fmt::format("{}: cannot be written: {}, expected room for it", name_, std::strerror(errno)));
    buffer_.clear();
}

void VcdFile::finish() {
    advance(last_ + 2);
    write_out();
    if (std::fclose(file_.release()) != 0)
        throw InputError(fmt::format("{}: cannot be written: {}, expected room for it", name_, std::strerror(errno)));
}

}  // namespace faster::recording
