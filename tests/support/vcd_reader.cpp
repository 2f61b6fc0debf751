#include "support/vcd_reader.hpp"

#include <algorithm>
#include <cstdio>
#include <fstapi.h>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "faster/dataflow_names.hpp"

namespace faster::test {

namespace {

class Reader {
  public:
    explicit Reader(std::uint64_t ticks_per_cycle) : ticks_per_cycle_(ticks_per_cycle) {}

    void declare(std::string const& line) {
        std::istringstream words(line);
        std::string word, skipped, id, name;
        words >> word;
        if (word == "$scope") {
            words >> skipped >> name;
            scopes_.push_back(name);
        } else if (word == "$upscope") {
            scopes_.pop_back();
        } else if (word == "$var") {
            words >> skipped >> skipped >> id >> name;
            std::string path;
            for (std::size_t i = 1; i < scopes_.size(); ++i)
                path += scopes_[i] + ".";
            names_[id] = path + name;
            vcd_.signals[path + name];
        } else if (word == "$timescale") {
            std::getline(words, vcd_.timescale, '$');
        }
    }
    void change(std::string const& line) {
        if (line[0] == '#') {
            time_ = std::stoull(line.substr(1));
            return;
        }
        bool const is_vector = line[0] == 'b';
        std::size_t const gap = is_vector ? line.find(' ') : 0;
        std::string const bits = is_vector ? line.substr(1, gap - 1) : line.substr(0, 1);
        std::string const& signal = names_.at(line.substr(gap + 1));
        if (time_ % ticks_per_cycle_ != 0 && signal != "clock")
            throw std::runtime_error(signal + " changes between cycles");
        Vcd::Value value;
        value.cycle = time_ / ticks_per_cycle_;
        value.known = bits.find('x') == std::string::npos;
        value.bits = value.known ? std::stoull(bits, nullptr, 2) : 0;
        vcd_.signals[signal].push_back(value);
    }
    Vcd take() { return std::move(vcd_); }

  private:
    std::uint64_t ticks_per_cycle_;
    std::uint64_t time_ = 0;
    std::vector<std::string> scopes_;
    std::map<std::string, std::string> names_;
    Vcd vcd_;
};

}  // namespace

Vcd read_vcd(std::filesystem::path const& file, std::uint64_t ticks_per_cycle) {
    std::ifstream stream(file);
    if (!stream)
        throw std::runtime_error(file.string() + " is not there");
    Reader reader(ticks_per_cycle);
    bool declares = true;
    for (std::string line; std::getline(stream, line);) {
        if (line.rfind("$enddefinitions", 0) == 0)
            declares = false;
        else if (declares)
            reader.declare(line);
        else if (line[0] != '$')
            reader.change(line);
    }
    return reader.take();
}

Vcd read_fst(std::filesystem::path const& file, std::uint64_t ticks_per_cycle) {
    std::filesystem::path const vcd = file.string() + ".vcd";
    std::unique_ptr<void, void (*)(void*)> const fst(fstReaderOpen(file.c_str()), fstReaderClose);
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> text(std::fopen(vcd.c_str(), "w"), std::fclose);
    if (fst == nullptr || text == nullptr)
        throw std::runtime_error(file.string() + " is no FST");
    fstReaderProcessHier(fst.get(), text.get());
    fstReaderSetFacProcessMaskAll(fst.get());
    fstReaderIterBlocks(fst.get(), nullptr, nullptr, text.get());
    text.reset();
    return read_vcd(vcd, ticks_per_cycle);
}

std::uint64_t Vcd::duration(std::string const& signal, std::uint64_t bits) const {
    std::uint64_t sum = 0;
    std::vector<Value> const& values = signals.at(signal);
    for (std::size_t i = 0; i + 1 < values.size(); ++i)
        if (values[i].known && values[i].bits == bits)
            sum += values[i + 1].cycle - values[i].cycle;
    return sum;
}

std::uint64_t Vcd::largest(std::string const& signal) const {
    std::uint64_t largest = 0;
    for (Value const& value : signals.at(signal))
        largest = std::max(largest, value.known ? value.bits : 0);
    return largest;
}

Vcd::Value Vcd::at(std::string const& signal, std::uint64_t cycle) const {
    std::vector<Value> const& values = signals.at(signal);
    auto const later = [](std::uint64_t c, Value const& value) { return c < value.cycle; };
    auto const next = std::upper_bound(values.begin(), values.end(), cycle, later);
    return next == values.begin() ? Value{} : *(next - 1);
}

std::vector<Vcd::Value> Vcd::sampled(std::string const& signal, std::string const& enable) const {
    std::vector<Value> found;
    std::vector<Value> const& enables = signals.at(enable);
    for (std::size_t i = 0; i + 1 < enables.size(); ++i)
        if (enables[i].known && enables[i].bits == 1)
            for (std::uint64_t cycle = enables[i].cycle; cycle < enables[i + 1].cycle; ++cycle) {
                found.push_back(at(signal, cycle));
                found.back().cycle = cycle;
            }
    return found;
}

std::vector<Vcd::Value> Vcd::within(std::string const& signal, std::uint64_t from, std::uint64_t to) const {
    std::vector<Value> found{at(signal, from)};
    found.front().cycle = from;
    for (Value const& value : signals.at(signal))
        if (value.cycle > from && value.cycle <= to)
            found.push_back(value);
    return found;
}

}  // namespace faster::test
