#include "dataflow/run/replay/operation_tape.hpp"

#include <cerrno>
#include <cstring>
#include <unistd.h>

#include "dataflow/base/files/zstd_frame.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/run/replay/sample_codec.hpp"

namespace dataflow::replay {

OperationTape::OperationTape(std::filesystem::path const& file, std::vector<Block> blocks)
    : file_(std::fopen(file.c_str(), "rb")), name_(file.string()), blocks_(std::move(blocks)) {
    if (file_ == nullptr)
        throw HostError(name_ + ": cannot be read: " + std::strerror(errno) + ", expected a readable file");
}

void OperationTape::fail(char const* what) const {
    throw HostError(name_ + ": cannot " + what + ": " + std::strerror(errno) +
                    ", expected room in the system's folder for temporary files");
}

void OperationTape::put(std::size_t sample, ScriptedSample const& scripted, timing::PhraseBook const& book) {
    std::string const content = encode(scripted, book);
    if (press_ == nullptr)
        press_ = std::make_unique<io::ZstdPress>();
    std::string const frame = press_->frame(content);
    if (file_ == nullptr)
        file_.reset(std::tmpfile());
    if (file_ == nullptr)
        fail("create it");
    if (std::fwrite(frame.data(), 1, frame.size(), file_.get()) != frame.size())
        fail("write it");
    if (sample >= blocks_.size())
        blocks_.resize(sample + 1);
    blocks_[sample] = {written_, frame.size(), content.size(), io::checksum_of_zstd_frame(frame)};
    written_ += frame.size();
}

void OperationTape::finish() {
    if (file_ != nullptr && std::fflush(file_.get()) != 0)
        fail("write it");
}

void OperationTape::read_block(std::size_t sample, Bytes& bytes) const {
    bytes.resize(blocks_[sample].bytes);
    std::size_t done = 0;
    while (done < bytes.size()) {
        ssize_t const count = pread(fileno(file_.get()), bytes.data() + done, bytes.size() - done,
                                    static_cast<off_t>(blocks_[sample].at + done));
        if (count <= 0)
            throw InputError(name_ + ": cannot be read as far as it should go, expected all that was written");
        done += static_cast<std::size_t>(count);
    }
}

}  // namespace dataflow::replay
