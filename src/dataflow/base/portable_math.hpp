#pragma once

/// Functions of the C library that may differ in the last bit from machine to machine, made of + - * / and square roots
/// alone. IEEE 754 defines these to the bit, so with doubles of 64 bits and without contraction (-ffp-contract=off) the
/// results are the same everywhere. They are within a few units in the last place of the true value.
namespace dataflow::portable {

constexpr double pi = 3.14159265358979323846;

/// Natural logarithm of a finite x > 0.
double log(double x);

/// e to the power of x; 0 below -700, and no more than exp(700).
double exp(double x);

/// x to the power of `exponent`; 0 for x = 0 and `exponent` > 0. x >= 0.
double pow(double x, double exponent);

/// Sine and cosine of an angle [rad].
struct SineAndCosine {
    double sine = 0;
    double cosine = 1;
};
SineAndCosine sine_and_cosine(double angle);

/// The angle [rad] of a vector with y >= 0 and x >= 0, not both 0.
double angle_of(double y, double x);

}  // namespace dataflow::portable
