#include "hls/untimed_network.hpp"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "dataflow/base/as_mistake.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/process_pool.hpp"

namespace dataflow::untimed {

namespace {
/// Leaves a function that nobody can help any more.
struct GivenUp {};
/// Rounds in which functions have looked for tokens, and nobody has done anything else, before they are given up.
constexpr std::size_t most_idle_rounds = 100'000;
/// In a stream, in a call; half a gigabyte.
constexpr std::size_t most_tokens = std::size_t{1} << 26U;
}  // namespace

void refuse_size(StreamBase const& stream) {
    throw InputError("stream " + stream.name() + " is asked for its size(), which hardware does not count, expected " +
                     "empty() or full()");
}

void refuse_stranger(StreamBase const& stream) {
    throw InputError("stream " + stream.name() + " is none of the design's, expected streams between functions as " +
                     "members of the class that derives HlsDesign");
}

std::exception_ptr thrown_by_process(std::string const& name) {
    return thrown_by("process " + name, "a function that returns");
}

/// Whose turn it is: that of a function, each of which has a thread, or that of the network.
class UntimedNetwork::Baton {
  public:
    void give(std::size_t process) {
        std::unique_lock lock(mutex_);
        turn_ = process;
        changed_.notify_all();
        changed_.wait(lock, [this] { return turn_ == of_network; });
    }
    void await(std::size_t process) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this, process] { return turn_ == process; });
    }
    void give_back() {
        std::lock_guard const lock(mutex_);
        turn_ = of_network;
        changed_.notify_all();
    }

  private:
    static constexpr std::size_t of_network = ~std::size_t{0};
    std::mutex mutex_;
    std::condition_variable changed_;
    std::size_t turn_ = of_network;
};

/// One function while it runs.
class UntimedNetwork::Watcher final : public Observer {
  public:
    Watcher(UntimedNetwork& network, Baton& baton, std::size_t process)
        : network_(network), baton_(baton), process_(process), thread_([this] { run(); }) {}
    ~Watcher() override { thread_.join(); }
    Watcher(Watcher const&) = delete;
    Watcher& operator=(Watcher const&) = delete;

    bool can_go_on() const { return !is_done_ && (awaited_ == nullptr || awaited_->has_token()); }
    bool is_done() const { return is_done_; }
    /// It has done something since the last call, and not only looked for tokens.
    bool has_moved() { return std::exchange(has_moved_, false); }
    void give_up() { is_given_up_ = true; }
    /// By one that is given up.
    StreamBase const* awaited() const { return awaited_; }
    std::exception_ptr const& error() const { return error_; }

    std::size_t process() const override { return process_; }
    void reads(StreamBase& stream) override {
        recorder().access({stream.number(), false});
        while (!stream.has_token() && !is_given_up_) {
            awaited_ = &stream;
            baton_.give_back();
            baton_.await(process_);
        }
        awaited_ = nullptr;
        if (is_given_up_)
            throw GivenUp();
        has_moved_ = true;
    }
    void wrote(StreamBase& stream) override {
        has_moved_ = true;
        recorder().access({stream.number(), true});
        std::vector<std::vector<std::int64_t>>& written = network_.written_;
        if (written.size() <= stream.number())
            written.resize(stream.number() + 1);
        written[stream.number()].push_back(stream.shown_last());
        if (written[stream.number()].size() > most_tokens)
            throw InputError("a function of the design has written more than " + std::to_string(most_tokens) +
                             " tokens into stream " + stream.name() + ", expected one that returns");
    }
    bool attempts(StreamBase const& stream, Attempt const& attempt) override {
        Access const access{stream.number(), attempt.writes};
        recorder().attempt(access);
        if (!attempt.only_asks)
            recorder().access(access);
        bool const finds = (attempt.writes || stream.has_token()) && ++attempts_ % 3 != 0;
        has_moved_ = has_moved_ || (finds && !attempt.only_asks);
        if (!finds) {
            baton_.give_back();
            baton_.await(process_);
            if (is_given_up_)
                throw GivenUp();
        }
        return finds;
    }
    void asks_size(StreamBase const& stream) override { refuse_size(stream); }
    void meets_stranger(StreamBase const& stream) override { refuse_stranger(stream); }
    void begins_iteration(LoopMark const& loop) override { recorder().begin(loop); }
    void ends_iteration(LoopMark const& /*loop*/) noexcept override { recorder().end(); }

  private:
    LoopRecorder& recorder() const { return *network_.recorders_[process_]; }
    void run() {
        baton_.await(process_);
        observer = this;
        try {
            if (!is_given_up_)
                network_.processes_[process_].call();
        } catch (GivenUp const&) {  // all that it did is known
        } catch (...) {
            error_ = thrown_by_process(network_.processes_[process_].name);
        }
        observer = nullptr;
        is_done_ = has_moved_ = true;
        baton_.give_back();
    }

    UntimedNetwork& network_;
    Baton& baton_;
    std::size_t process_;
    StreamBase const* awaited_ = nullptr;
    std::size_t attempts_ = 0;
    bool has_moved_ = false;
    bool is_done_ = false;
    bool is_given_up_ = false;
    std::exception_ptr error_;
    std::thread thread_;  // last: it uses the others
};

UntimedNetwork::UntimedNetwork(std::vector<ProcessCall> const& processes, std::vector<LoopNames> const& around)
    : processes_(processes) {
    for (std::size_t i = 0; i < processes.size(); ++i)
        recorders_.push_back(
            std::make_unique<LoopRecorder>(processes[i].name, i < around.size() ? around[i] : LoopNames()));
}

UntimedNetwork::~UntimedNetwork() = default;

void UntimedNetwork::run() {
    written_.assign(written_.size(), {});
    waiting_.clear();
    std::exception_ptr error;
    {
        Baton baton;
        std::vector<std::unique_ptr<Watcher>> watchers;
        try {
            for (std::size_t i = 0; i < processes_.size(); ++i)
                watchers.push_back(std::make_unique<Watcher>(*this, baton, i));
        } catch (std::system_error const& refusal) {  // the functions that have a thread are given up below
            error = std::make_exception_ptr(HostError("no thread for a function of the design (" +
                                                      refusal.code().message() + "), expected room for more of them"));
        }
        auto const first_error = [&](Watcher const& watcher) {
            if (!error)
                error = watcher.error();
        };
        std::size_t idle_rounds = 0;
        for (bool has_moved = true; has_moved && idle_rounds < most_idle_rounds && !error;) {
            has_moved = false;
            ++idle_rounds;
            for (std::size_t i = 0; i < watchers.size() && !error; ++i)
                if (watchers[i]->can_go_on()) {
                    has_moved = true;
                    baton.give(i);
                    first_error(*watchers[i]);
                    idle_rounds = watchers[i]->has_moved() ? 0 : idle_rounds;
                }
        }
        for (std::size_t i = 0; i < watchers.size(); ++i)
            if (!watchers[i]->is_done()) {
                if (StreamBase const* const stream = watchers[i]->awaited())
                    waiting_ += (waiting_.empty() ? "" : ", ") + processes_[i].name + " waits for " + stream->name();
                watchers[i]->give_up();
                baton.give(i);
            }
    }
    if (error)
        std::rethrow_exception(error);
    events_.clear();
    for (auto const& recorder : recorders_)
        events_.push_back(recorder->take());
}

void UntimedNetwork::run_apart() {
    using processes::Outcome;
    processes::SignalWatch const watch;
    Outcome outcome = processes::run_all({{[this] { return sent_run(); }}}, 1, watch).front();
    if (outcome.kind != Outcome::Kind::done)
        throw InputError(std::string("a function of the design has ended its process, ") +
                         (outcome.kind == Outcome::Kind::crashed ? "by signal " + std::to_string(outcome.signal)
                          : outcome.kind == Outcome::Kind::failed
                              ? "with exit code " + std::to_string(outcome.exit_code)
                              : "which took more than an hour") +
                         ", expected functions that return");
    receive(std::move(outcome.output));
}

/// What has been thrown, or nothing, and what was done.
std::string UntimedNetwork::sent_run() {
    bool is_of_host = false;
    std::optional<std::string> error;
    try {
        run();
    } catch (HostError const& refusal) {
        is_of_host = true;
        error = refusal.what();
    } catch (InputError const& mistake) {
        error = mistake.what();
    } catch (std::bad_alloc const&) {
        is_of_host = true;
        error = "no memory for the functions of the design, expected more of it";
    }
    ValueWriter bytes;
    bytes.put(error, is_of_host, events_, waiting_);
    for (auto const& recorder : recorders_)
        recorder->send(bytes);
    return bytes.bytes();
}

void UntimedNetwork::receive(std::string bytes) {
    ValueReader reader(std::move(bytes));
    bool is_of_host = false;
    std::optional<std::string> error;
    reader.get(error, is_of_host, events_, waiting_);
    if (error && is_of_host)
        throw HostError(*error);
    if (error)
        throw InputError(*error);
    for (auto const& recorder : recorders_)
        recorder->receive(reader);
}

}  // namespace dataflow::untimed
