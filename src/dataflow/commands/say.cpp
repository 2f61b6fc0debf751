#include "dataflow/commands/say.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/program_name.hpp"

namespace dataflow {

namespace {

[[noreturn]] void fail() {
    std::string const why = std::strerror(errno);
    throw InputError("standard output: cannot be written (" + why + "), expected an open one with room");
}

bool put(std::string const& text, std::FILE* stream) {
    return std::fwrite(text.data(), 1, text.size(), stream) == text.size();
}

}  // namespace

void say_text(std::string_view text) {
    if (!put(printable_lines(text), stdout))
        fail();
}

void warn_text(std::string_view text) { put(printable_lines(text), stderr); }

void say_warnings(std::vector<std::string> const& warnings) {
    for (std::string const& warning : warnings)
        warn("{}: warning: {}\n", program_name(), message_line(warning));
}

void say_written(std::vector<std::string> const& names) {
    for (std::string const& name : names)
        if (!name.empty())
            say("\nwritten: {}\n", name);
}

void finish_saying() {
    if (std::fflush(stdout) != 0)
        fail();
}

}  // namespace dataflow
