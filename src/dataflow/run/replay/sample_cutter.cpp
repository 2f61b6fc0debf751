#include "dataflow/run/replay/sample_cutter.hpp"

#include "dataflow/run/replay/canonical_operations.hpp"

namespace dataflow::replay {

using timing::Operation;
using timing::OperationLog;
using timing::Phrase;

namespace {
bool accesses(Operation const& operation, std::uint32_t ports) {
    timing::Ports::Number const tail = operation.tail_ports();
    return operation.is_at(ports) || (timing::Ports::is_mask(tail) && (tail & ports) != 0);
}
/// Of a follower's operation; 0 if it accesses others as well: what comes of it is not known from the group alone.
timing::Ports::Number ports_inside(Operation const& operation, timing::Group::Member const& member) {
    auto const ports = static_cast<timing::Ports::Number>(operation.ports() & ~member.fed_ports);
    return (ports & ~member.inner_ports) == 0 ? ports : timing::Ports::Number{0};
}
}  // namespace

ScriptedSample SampleCutter::cut(SampleOperations operations) {
    ScriptedSample cut;
    cut.before = std::move(operations);
    cut.after.resize(cut.before.size());
    if (!lead_.has_followers())
        return cut;
    std::uint32_t const suppliers = lead_.group.suppliers();
    for (unsigned m = 0; m < lead_.group.members().size(); ++m)
        if (suppliers != 1U << m)
            open(m, cut);
    open_driver(cut);
    book_.clear();
    while (cut.phrases.size() < ScriptedSample::most_phrases &&
           phrase_.read(lead_.group, suppliers, Phrase::most_in_recording) == Phrase::Reading::complete) {
        cut.phrases.push_back(book_.number_of(phrase_, lead_.group, timing::PhraseBook::Compare::prints));
        cut.script.due += book_[cut.phrases.back()].due;
        phrase_.consume();
    }
    for (unsigned m = 0; m < lead_.group.members().size(); ++m)
        if (suppliers != 1U << m)
            close(m, cut);
    return cut;
}

/// Leaves a follower's operations up to its first answer, and the driver's up to what the sample begins with.
void SampleCutter::open(unsigned member, ScriptedSample& cut) {
    std::vector<Operation>& before = cut.before[index(member)];
    std::uint32_t const anchor = 1U << lead_.group.members()[member].anchor_port;
    auto first = before.begin();
    while (member != 0 && first != before.end() && !first->is_at(anchor))
        ++first;
    log(member).clear();
    for (auto operation = first; operation != before.end(); ++operation)
        log(member).append(*operation);
    if (member != 0 && first != before.end())
        cut.script.next_ports[member] = ports_inside(*first, lead_.group.members()[member]);
    before.erase(first, before.end());
}

void SampleCutter::open_driver(ScriptedSample& cut) {
    std::uint32_t const inner = lead_.group.members().front().inner_ports;
    OperationLog& driver = log(0);
    std::vector<Operation>& before = cut.before[index(0)];
    std::size_t begin = 0;
    for (std::size_t i = 0; i < driver.pending() && !accesses(driver.begin()[i], inner); ++i)
        if (driver.begin()[i].kind() == Operation::Kind::stamp || driver.begin()[i].all_ports() != 0)
            begin = i + 1;
    before.assign(driver.begin(), driver.begin() + begin);
    driver.consume(begin, 0);
}

void SampleCutter::close(unsigned member, ScriptedSample& cut) {
    cut.after[index(member)].assign(log(member).begin(), log(member).begin() + log(member).pending());
    log(member).clear();
}

SampleOperations joined(ScriptedSample const& cut, timing::PhraseBook const& book, timing::Group const& group) {
    std::vector<OperationLog> logs(cut.before.size());
    for (std::size_t i = 0; i < logs.size(); ++i)
        for (Operation const& operation : cut.before[i])
            logs[i].append(operation);
    for (timing::PhraseBook::Number const number : cut.phrases)
        Phrase::each(
            book.codes(number), book[number].size,
            [&](unsigned member, Operation const& operation) {
                logs[group.members()[member].process->index()].append(operation);
            },
            [](unsigned /*member*/, timing::Ports::Number /*next_ports*/, bool /*frozen*/) {});
    SampleOperations operations;
    for (std::size_t i = 0; i < logs.size(); ++i) {
        for (Operation const& operation : cut.after[i])
            logs[i].append(operation);
        operations.push_back(canonical(logs[i].begin(), logs[i].pending()));
    }
    return operations;
}

}  // namespace dataflow::replay
