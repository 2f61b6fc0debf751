#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "dataflow/base/files/c_file.hpp"
#include "dataflow/base/files/zstd_frame.hpp"
#include "dataflow/base/uninitialized.hpp"
#include "dataflow/run/replay/scripted_sample.hpp"

namespace dataflow::replay {

/// What the processes do, a compressed block per sample. Says nothing about time, so that any timing can be put to it,
/// and any core can score any sample. Kept in a temporary file, or in an event file; may be read by several threads at
/// once.
class OperationTape {
  public:
    /// Where the block of a sample lies in the file.
    struct Block {
        std::uint64_t at = 0;
        std::uint64_t bytes = 0;
        std::uint64_t content_bytes = 0;
        std::uint32_t checksum = 0;  ///< of the content
    };

    /// An empty tape, in a temporary file once something is put. InputError if there is no room for it.
    OperationTape() = default;
    /// The blocks of a file that is there.
    OperationTape(std::filesystem::path const& file, std::vector<Block> blocks);

    /// Samples in any order, each once; nothing is read before finish().
    void put(std::size_t sample, ScriptedSample const& scripted, timing::PhraseBook const& book);
    void finish();

    std::size_t samples() const { return blocks_.size(); }
    std::vector<Block> const& blocks() const { return blocks_; }
    /// The compressed block of a sample. InputError if it cannot be read.
    using Bytes = std::vector<char, Uninitialized<char>>;
    void read_block(std::size_t sample, Bytes& bytes) const;
    std::string const& name() const { return name_; }

  private:
    [[noreturn]] void fail(char const* what) const;

    io::CFile file_;
    std::string name_ = "temporary file of operations";
    std::uint64_t written_ = 0;
    std::unique_ptr<io::ZstdPress> press_;  ///< once something is put
    std::vector<Block> blocks_;             // by sample
};

}  // namespace dataflow::replay
