#pragma once
#include <memory>
#include <string>

#include "kernel/explore/answers.hpp"

namespace faster {

/// The page of an exploration over HTTP, for this host only and for who knows the token in its address.
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
    /// Answers until SIGINT, SIGTERM or SIGHUP comes.
    void serve();

  private:
    class Http;
    std::unique_ptr<Http> http_;
};

}  // namespace faster
