#include "dataflow/tools/recording/fst_file.hpp"

#include <cerrno>
#include <fmt/format.h>
#include <fstapi.h>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/held_signals.hpp"

namespace dataflow::recording {

namespace {
/// Digits of a value, one letter each, the highest first.
using Digits = std::array<char, 65>;

Digits digits_of(std::optional<std::uint64_t> value, unsigned bits) {
    Digits digits{};
    for (unsigned i = 0; i < bits; ++i)
        digits[i] = !value ? 'x' : ((*value >> (bits - 1 - i)) & 1U) != 0 ? '1' : '0';
    return digits;
}

/// GTKWave's code removes what is there, and for root that may be /dev/null.
std::filesystem::path const& no_device(std::filesystem::path const& file) {
    io::OutputFile const probe(file);
    return file;
}
}  // namespace

void FstFile::Closer::operator()(void* writer) const { fstWriterClose(writer); }

FstFile::FstFile(std::filesystem::path const& file, double clock_mhz)
    : target_(no_device(file)), writer_(fstWriterCreate(target_.path().c_str(), 1)) {
    if (writer_ == nullptr)
        target_.fail();
    fstWriterSetPackType(writer_.get(), FST_WR_PT_ZLIB);
    fstWriterSetVersion(writer_.get(), fmt::format("faster-sim {}", FASTER_VERSION).c_str());
    fstWriterSetDate(writer_.get(), "");  // so that equal runs write equal files
    fstWriterSetTimescaleFromString(writer_.get(), counts_in_ns(clock_mhz) ? "1ns" : "1ps");
}

void FstFile::open_scope(std::string const& name) {
    fstWriterSetScope(writer_.get(), FST_ST_VCD_MODULE, name.c_str(), nullptr);
}
void FstFile::close_scope() { fstWriterSetUpscope(writer_.get()); }

/// One for all signals with the same values; those without a name are none.
std::uint32_t FstFile::table_of(std::vector<std::string> const& values, unsigned bits) {
    auto const [known, is_new] = tables_.try_emplace(values);
    if (!is_new)
        return known->second;
    std::vector<Digits> digits;
    std::vector<char const*> names;
    for (std::size_t value = 0; value < values.size(); ++value)
        if (!values[value].empty()) {
            digits.push_back(digits_of(value, bits));
            names.push_back(values[value].c_str());
        }
    std::vector<char const*> numbers;
    numbers.reserve(digits.size());
    for (Digits const& number : digits)
        numbers.push_back(number.data());
    std::string const name = fmt::format("values_{}", tables_.size());
    known->second = fstWriterCreateEnumTable(writer_.get(), name.c_str(), static_cast<std::uint32_t>(names.size()),
                                             bits, names.data(), numbers.data());
    return known->second;
}

void FstFile::declare(SignalShape const& shape) {
    if (!shape.values.empty())
        fstWriterEmitEnumTableRef(writer_.get(), table_of(shape.values, shape.bits));
    std::string const range = shape.bits > 1 ? fmt::format(" [{}:0]", shape.bits - 1) : "";
    signals_.push_back({fstWriterCreateVar(writer_.get(), FST_VT_VCD_WIRE, FST_VD_IMPLICIT, shape.bits,
                                           (shape.name + range).c_str(), 0),
                        shape.bits});
}

/// The writer tells of nothing that goes wrong on its way, so that what the system says is looked at while it writes.
template <class Write> void FstFile::watched(Write const& write) {
    errno = 0;
    write();
    if (errno == ENOSPC || errno == EDQUOT || errno == EFBIG || errno == EIO)
        lost_by_ = errno;
}

/// The writer writes what has gathered where time goes on, so that it is here that one can give up.
void FstFile::go_to(std::uint64_t ticks) {
    processes::give_up_if_interrupted();
    watched([&] { fstWriterEmitTimeChange(writer_.get(), ticks); });
    if (lost_by_ != 0) {
        errno = lost_by_;
        target_.fail();
    }
    last_ticks_ = ticks;
}

void FstFile::change(std::size_t number, std::optional<std::uint64_t> value) {
    Signal const& signal = signals_[number];
    fstWriterEmitValueChange(writer_.get(), signal.handle, digits_of(value, signal.bits).data());
}

/// What the writer could not write at all is seen when the file is opened once more; to open it says nothing of why.
void FstFile::finish() {
    watched([&] { writer_.reset(); });
    int const reason = lost_by_ != 0 ? lost_by_ : errno == 0 ? EIO : errno;
    std::unique_ptr<void, void (*)(void*)> const reader(fstReaderOpen(target_.path().c_str()), fstReaderClose);
    bool const is_complete = lost_by_ == 0 && reader != nullptr &&
                             fstReaderGetMaxHandle(reader.get()) == signals_.size() &&
                             fstReaderGetEndTime(reader.get()) == last_ticks_;
    std::error_code error;
    bytes_ = std::filesystem::file_size(target_.path(), error);
    if (error || !is_complete) {
        errno = reason;
        target_.fail();
    }
    target_.finish();
}

}  // namespace dataflow::recording
