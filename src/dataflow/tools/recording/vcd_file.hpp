#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "dataflow/base/files/c_file.hpp"
#include "dataflow/tools/recording/unfinished_file.hpp"
#include "dataflow/tools/recording/waveform_file.hpp"

namespace dataflow::recording {

/// Writes a value change dump (IEEE 1364-2005, clause 18).
class VcdFile : public WaveformFile {
  public:
    VcdFile(std::filesystem::path const& file, double clock_mhz);

    void open_scope(std::string const& name) override;
    void close_scope() override;
    void declare(SignalShape const& shape) override;
    void end_declarations() override;
    void go_to(std::uint64_t ticks) override;
    void change(std::size_t signal, std::optional<std::uint64_t> value) override;
    void finish() override;
    std::uint64_t bytes() const override { return bytes_; }

  private:
    struct Signal {
        std::array<char, 8> id{};  ///< ends with a zero
        bool is_vector = false;
    };
    static std::array<char, 8> id_of(std::size_t number);
    void put_text(std::string const& text);
    void make_room();
    void write_out();

    UnfinishedFile target_;
    io::CFile file_;
    std::vector<char> buffer_;
    std::size_t fill_ = 0;
    std::uint64_t bytes_ = 0;  ///< written out
    std::vector<Signal> signals_;
};

}  // namespace dataflow::recording
