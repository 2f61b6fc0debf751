#include "dataflow/run/replay/tape_reader.hpp"

#include <optional>
#include <string>
#include <string_view>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/run/replay/sample_codec.hpp"

namespace dataflow::replay {

ScriptedSample TapeReader::read(std::size_t sample) {
    ScriptedSample scripted;
    OperationTape::Block const& block = tape_.blocks()[sample];
    tape_.read_block(sample, frame_);
    std::string_view const frame(frame_.data(), frame_.size());
    std::optional<std::string_view> const content = zstd_.content(frame, block.content_bytes);
    if (!content || content->size() != block.content_bytes || io::checksum_of_zstd_frame(frame) != block.checksum ||
        !decode(*content, known_, scripted))
        throw InputError(tape_.name() + ": the operations of sample " + std::to_string(sample) +
                         " are damaged, expected them as " + program_name() + " run --events wrote them");
    return scripted;
}

}  // namespace dataflow::replay
