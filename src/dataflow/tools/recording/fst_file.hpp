#pragma once
#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "dataflow/tools/recording/unfinished_file.hpp"
#include "dataflow/tools/recording/waveform_file.hpp"

namespace dataflow::recording {

/// Writes an FST, GTKWave's compressed format of waveforms, by GTKWave's own code.
class FstFile : public WaveformFile {
  public:
    FstFile(std::filesystem::path const& file, double clock_mhz);

    void open_scope(std::string const& name) override;
    void close_scope() override;
    void declare(SignalShape const& shape) override;
    void end_declarations() override {}
    void go_to(std::uint64_t ticks) override;
    void change(std::size_t signal, std::optional<std::uint64_t> value) override;
    void finish() override;
    std::uint64_t bytes() const override { return bytes_; }

  private:
    struct Signal {
        std::uint32_t handle = 0;
        unsigned bits = 1;
    };
    std::uint32_t table_of(std::vector<std::string> const& values, unsigned bits);
    template <class Write> void watched(Write const& write);

    struct Closer {
        void operator()(void* writer) const;
    };
    UnfinishedFile target_;
    std::unique_ptr<void, Closer> writer_;
    std::vector<Signal> signals_;
    std::map<std::vector<std::string>, std::uint32_t> tables_;
    std::uint64_t last_ticks_ = 0;
    std::uint64_t bytes_ = 0;
    int lost_by_ = 0;  ///< errno of a write that failed; 0: none
};

}  // namespace dataflow::recording
