#pragma once
#include <string>

#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::test {

/// The message of the InputError that `action` throws; "(no error)" if it throws none. Other exceptions pass through
/// and fail the test.
template <class Action> std::string input_error_text(Action const& action) {
    try {
        action();
    } catch (InputError const& error) {
        return error.what();
    }
    return "(no error)";
}

}  // namespace faster::test
