#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/temp_folder.hpp"

namespace faster::test {

/// A command that writes, in a folder where it has written before, from other inputs.
struct WritingCommand {
    std::string name;
    std::vector<std::string> words;
    /// Folders that grow in place: a repeat goes on where it was. What in them appears complete or not at all.
    std::vector<std::string> in_place = {};
    std::vector<std::string> whole_files_in_place = {};
    /// Those that also say what failed, if not all did.
    std::vector<std::string> reports = {};
};

/// One for every command that writes.
std::vector<WritingCommand> writing_commands();

/// Every file below a folder by its path, with its content as far as that is the same every time.
using Tree = std::map<std::string, std::string>;
Tree tree_of(std::filesystem::path const& folder);

/// The folder before and after a command, made when it is first asked for.
class WritingScene {
  public:
    explicit WritingScene(WritingCommand const& command);

    WritingCommand const& command() const { return command_; }
    double seconds() const { return seconds_; }  ///< of the command, undisturbed
    std::size_t pages() const;                   ///< of 4096 bytes, of all files that it writes
    /// A copy of the folder before the command.
    void lay_out(std::filesystem::path const& folder) const;
    /// What is wrong with a folder in which the command was stopped; empty if nothing is: every output is the older
    /// one or the new one (or missing, if `may_be_missing`), and nothing hidden is there unless `may_be_left`.
    /// `has_failed`: so reports may say something else.
    std::string complaint(std::filesystem::path const& folder, bool may_be_left, bool may_be_missing = false,
                          bool has_failed = false) const;
    /// What is wrong with a folder in which it was done undisturbed afterwards.
    std::string complaint_after_repeat(std::filesystem::path const& folder) const;

  private:
    bool is_in_place(std::string const& file) const;

    WritingCommand command_;
    TempFolder before_;
    Tree older_, newer_;
    double seconds_ = 0;
};

}  // namespace faster::test
