#include "retiming/tape_writer.hpp"

#include "config/machine.hpp"
#include "retiming/canonical_operations.hpp"

namespace faster::retiming {

namespace {
constexpr std::size_t most_waiting = 16;  // samples: some megabytes
}  // namespace

TapeWriter::TapeWriter(RecordedRun& run, Parts const& parts, std::size_t processes, Timed timed)
    : run_(run), parts_(parts), timed_(std::move(timed)), step_ports_(processes), thread_([this] { work(); }) {}

TapeWriter::~TapeWriter() { stop(); }

void TapeWriter::put(std::size_t sample, SampleOperations operations) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return waiting_.size() < most_waiting; });
    waiting_.emplace_back(sample, std::move(operations));
    changed_.notify_all();
}

void TapeWriter::finish() {
    stop();
    if (error_)
        std::rethrow_exception(error_);
    run_.tape.finish();
}

std::optional<RunStatistics> TapeWriter::statistics() {
    return retiming_ == nullptr ? std::nullopt : retiming_->finish(run_.counters);
}

void TapeWriter::stop() {
    {
        std::lock_guard<std::mutex> const lock(mutex_);
        stops_ = true;
        changed_.notify_all();
    }
    if (thread_.joinable())
        thread_.join();
}

void TapeWriter::work() {
    for (;;) {
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, [this] { return stops_ || !waiting_.empty(); });
        if (waiting_.empty())
            return;
        auto [sample, operations] = std::move(waiting_.front());
        waiting_.pop_front();
        changed_.notify_all();
        lock.unlock();
        if (!error_)
            write(sample, std::move(operations));
    }
}

void TapeWriter::write(std::size_t sample, SampleOperations operations) {
    try {
        for (std::size_t i = 0; i < operations.size(); ++i) {
            if (i == index_of(ModuleId::inlier_unit))
                return_tails(operations[i]);
            operations[i] = canonical(operations[i].data(), operations[i].size());
            for (timing::Operation const& operation : operations[i])
                if (operation.kind() == timing::Operation::Kind::step)
                    step_ports_[i] = step_ports_[i] | timing::Ports(operation.ports());
        }
        if (!cutter_)
            cutter_ = std::make_unique<SampleCutter>(*run_.blueprint, parts_);
        ScriptedSample cut = cutter_->cut(std::move(operations));
        run_.tape.put(sample, cut, cutter_->book());
        if (timed_.config != nullptr && retiming_ == nullptr)
            retiming_ = std::make_unique<LiveRetiming>(*run_.blueprint, *timed_.config, timed_.shares);
        if (retiming_ != nullptr)
            retiming_->put(sample, std::move(cut), cutter_->book());
    } catch (...) {
        error_ = std::current_exception();
    }
}

}  // namespace faster::retiming
