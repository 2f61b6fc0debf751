#include "kernel/recording/vcd_file.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fmt/format.h>

#include "kernel/base/files/file_error.hpp"
#include "kernel/base/files/hidden_name.hpp"
#include "kernel/base/files/output_file.hpp"

namespace faster::recording {

namespace {
constexpr std::size_t buffer_size = 1U << 20;

/// Eight binary digits, the highest first.
void put_byte(char* at, std::uint64_t byte) {
    std::uint64_t const copies = byte * 0x0101010101010101U;
    std::uint64_t const own = copies & 0x0102040810204080U;  // the k-th byte keeps the bit 7 - k
    std::uint64_t const digits = (((own + 0x7F7F7F7F7F7F7F7FU) | own) >> 7 & 0x0101010101010101U) | 0x3030303030303030U;
    std::memcpy(at, &digits, sizeof digits);
}

/// A number's binary digits without leading zeros. Returns the end.
char* put_binary(char* at, std::uint64_t value) {
    unsigned const bits = bits_for(value);
    value <<= 64U - bits;
    for (unsigned done = 0; done < bits; done += 8, value <<= 8)
        put_byte(at + done, value >> 56);
    return at + bits;
}

}  // namespace

bool counts_in_ns(double clock_mhz) {
    double const ns = 1e3 / clock_mhz;
    return std::abs(ns - std::round(ns)) < 1e-9;
}

double ticks_per_cycle(double clock_mhz) {
    return counts_in_ns(clock_mhz) ? std::round(1e3 / clock_mhz) : 1e6 / clock_mhz;
}

VcdFile::VcdFile(std::filesystem::path const& file, double clock_mhz)
    : name_(file), ticks_per_cycle_(ticks_per_cycle(clock_mhz)) {
    try {
        if (!io::is_device(file))
            scratch_.emplace(std::filesystem::weakly_canonical(std::filesystem::absolute(file)),
                             io::Scratch::Kind::file);
    } catch (std::filesystem::filesystem_error const& error) {
        fail(error.code().message());
    }
    file_.reset(std::fopen((scratch_ ? scratch_->path() : name_).c_str(), "wb"));
    if (file_ == nullptr)
        fail(std::strerror(errno));
    bool const in_ns = counts_in_ns(clock_mhz);
    buffer_.resize(buffer_size);
    put_text(fmt::format("$version faster-sim {} $end\n$comment {:g} MHz $end\n$timescale 1 {} $end\n", FASTER_VERSION,
                         clock_mhz, in_ns ? "ns" : "ps"));
}

std::array<char, 8> VcdFile::id_of(std::size_t number) {
    std::array<char, 8> id{};
    std::size_t length = 0;
    do {
        id[length++] = static_cast<char>('!' + number % 94);
        number /= 94;
    } while (number > 0);
    return id;
}

void VcdFile::open_scope(std::string const& name) { put_text(fmt::format("$scope module {} $end\n", name)); }
void VcdFile::close_scope() { put_text("$upscope $end\n"); }

VcdFile::Signal VcdFile::add(std::string const& name, unsigned bits, std::size_t domain) {
    Variable variable;
    variable.id = id_of(variables_.size());
    variable.bits = static_cast<std::uint8_t>(bits);
    variable.domain = static_cast<std::uint32_t>(domain);
    std::string const range = bits > 1 ? fmt::format(" [{}:0]", bits - 1) : "";
    put_text(fmt::format("$var wire {} {} {}{} $end\n", bits, variable.id.data(), name, range));
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
    if (cycle - cycle_ < ring_size) {
        ring_[cycle % ring_size].push_back({signal, value});
        ++in_ring_;
    } else {
        later_.push({cycle, scheduled_++, signal, value});
    }
}

/// The next cycle, up to `cycle`, in which something may change: by a schedule, or because a window begins or is over.
Cycles VcdFile::next_stop(Cycles cycle) const {
    Cycles stop = std::min(cycle, next_border_);
    if (!later_.empty())
        stop = std::min(stop, later_.top().cycle);
    if (in_ring_ > 0)
        for (Cycles near = cycle_ + 1; near < stop && near < cycle_ + ring_size; ++near)
            if (!ring_[near % ring_size].empty())
                return near;
    return std::max(stop, cycle_ + 1);
}

void VcdFile::cross_border() {
    next_border_ = ~Cycles{0};
    for (std::size_t domain = 0; domain < windows_.size(); ++domain)
        for (Cycles const border : {windows_[domain].first, windows_[domain].second + 1}) {
            if (border == cycle_)
                touch_domain(domain);
            else if (border > cycle_)
                next_border_ = std::min(next_border_, border);
        }
}

void VcdFile::advance(Cycles cycle) {
    while (cycle_ < cycle) {
        Cycles const stop = next_stop(cycle);
        flush_cycle();
        cycle_ = stop;
        if (cycle_ >= next_border_)
            cross_border();
        for (; !later_.empty() && later_.top().cycle <= cycle_; later_.pop())
            set(later_.top().signal, later_.top().value);
        std::vector<Change>& now = ring_[cycle_ % ring_size];
        in_ring_ -= now.size();
        for (Change const& change : now)
            set(change.signal, change.value);
        now.clear();
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
    if (fill_ + 128 > buffer_.size())
        write_out();
    char* at = buffer_.data() + fill_;
    if (variable.bits > 1)
        *at++ = 'b';
    if (!known) {
        *at++ = 'x';
    } else {
        at = put_binary(at, variable.value);
    }
    if (variable.bits > 1)
        *at++ = ' ';
    for (char const* letter = variable.id.data(); *letter != 0; ++letter)
        *at++ = *letter;
    *at++ = '\n';
    fill_ = static_cast<std::size_t>(at - buffer_.data());
}

void VcdFile::put_text(std::string const& text) {
    for (char const letter : text) {
        if (fill_ == buffer_.size())
            write_out();
        buffer_[fill_++] = letter;
    }
}

void VcdFile::write_out() {
    processes::give_up_if_interrupted();
    if (std::fwrite(buffer_.data(), 1, fill_, file_.get()) != fill_)
        fail(std::strerror(errno));
    fill_ = 0;
}

void VcdFile::finish() {
    advance(last_ + 2);
    write_out();
    if (std::fclose(file_.release()) != 0)
        fail(std::strerror(errno));
    if (scratch_ && std::rename(scratch_->path().c_str(), scratch_->target().c_str()) != 0)
        fail(std::strerror(errno));
    scratch_.reset();
}

void VcdFile::fail(std::string const& why) const { io::fail_to_write(io::without_hidden_names(name_), why); }

}  // namespace faster::recording
