#pragma once
#include <functional>
#include <memory>
#include <string>

#include "dataflow/tools/explore/answers.hpp"

namespace dataflow {

/// The page of an exploration over HTTP, for this host only and for who knows the token in its address.
///
/// Whatever clients send, and however slowly: a request has at most 16 KiB of headers and 128 KiB of body, of any
/// encoding, and has to be there within 20 s. There are at most 64 connections; one more takes the place of the one
/// that has said nothing whole for longest. Ranges are not asked for, and answers are not waited for when it stops.
class ExploreServer {
  public:
    /// Port 0: any that is free. Throws InputError if it cannot be had. The answers must outlive this.
    ExploreServer(explore::Answers& answers, int port);
    ~ExploreServer();
    ExploreServer(ExploreServer const&) = delete;
    ExploreServer& operator=(ExploreServer const&) = delete;

    int port() const;
    /// Where the page is.
    std::string address() const;
    /// Answers until SIGINT, SIGTERM or SIGHUP comes. If an answer takes longer than half a second more, the program
    /// ends here, with exit code 0. `tell_of_end` is called before that.
    void serve(std::function<void()> const& tell_of_end);

  private:
    class Http;
    std::unique_ptr<Http> http_;
};

}  // namespace dataflow
