#pragma once
#include <exception>
#include <new>
#include <string>

#include "dataflow/base/held_signals.hpp"
#include "dataflow/base/input_error.hpp"

namespace dataflow {

/// Of the exception at hand, which a user's code has thrown: itself, if it says what is wrong or ends the program;
/// otherwise the mistake that it is. `say`: in a line, of the exception's what(), or of null if it has none.
template <class Say> std::exception_ptr as_mistake(Say const& say) {
    try {
        throw;
    } catch (InputError const&) {
    } catch (std::bad_alloc const&) {
    } catch (processes::Interrupted const&) {
    } catch (std::exception const& error) {
        return std::make_exception_ptr(InputError(say(error.what())));
    } catch (...) {
        return std::make_exception_ptr(InputError(say(static_cast<char const*>(nullptr))));
    }
    return std::current_exception();
}

/// The mistake that the exception at hand is, in the words that all of them have.
///   who       has thrown it, e.g. "describe() of the design"
///   expected  instead
inline std::exception_ptr thrown_by(std::string const& who, std::string const& expected) {
    return as_mistake([&](char const* what) {
        return who + " has thrown" +
               (what != nullptr ? ": " + std::string(what) : " something that is no std::exception") + ", expected " +
               expected;
    });
}

}  // namespace dataflow
