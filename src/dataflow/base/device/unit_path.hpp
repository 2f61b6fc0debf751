#pragma once
#include <string>

namespace dataflow {

/// An estimate with its range.
struct Estimate {
    double low = 0;
    double typical = 0;
    double high = 0;
};

inline Estimate operator*(double times, Estimate const& a) {
    return {times * a.low, times * a.typical, times * a.high};
}
inline Estimate operator+(Estimate const& a, Estimate const& b) {
    return {a.low + b.low, a.typical + b.typical, a.high + b.high};
}

/// A longest path of a unit, clock to clock.
struct UnitPath {
    std::string from;
    std::string to;
    unsigned stages = 1;  ///< that its logic may be spread over
    Estimate delay_ns;    ///< of all of it

    Estimate of_stage() const { return {delay_ns.low / stages, delay_ns.typical / stages, delay_ns.high / stages}; }
};

}  // namespace dataflow
