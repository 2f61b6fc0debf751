#pragma once
#include <filesystem>
#include <string>
#include <sys/types.h>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/temp_folder.hpp"

namespace faster::test {

/// `faster-sim explore` while it answers.
class ExploreProcess {
  public:
    /// Waits until it has printed its address. Throws std::runtime_error if it does not.
    ExploreProcess(std::string const& tool, std::vector<std::string> arguments, std::filesystem::path const& folder);
    /// Ends it.
    ~ExploreProcess();
    ExploreProcess(ExploreProcess const&) = delete;
    ExploreProcess& operator=(ExploreProcess const&) = delete;

    std::string const& address() const { return address_; }
    std::string said() const { return content_of(output_ / "stdout"); }
    int port() const;
    /// Of the process.
    pid_t number() const { return process_; }
    /// "/TOKEN/"
    std::string home() const;
    /// As Ctrl-C does; returns the exit code, or -1 if it ended otherwise.
    int interrupt();

  private:
    TempFolder output_;
    pid_t process_ = -1;
    std::string address_;
};

}  // namespace faster::test
