#include "dataflow/base/portable_math.hpp"

#include <algorithm>
#include <cmath>

namespace dataflow::portable {

namespace {

constexpr double ln_2 = 0.69314718055994530942;
constexpr double square_root_of_half = 0.70710678118654752440;

/// Powers of two are exact.
double doubled(double value, int times) { return std::ldexp(value, times); }

}  // namespace

/// 2 artanh((m - 1) / (m + 1)) of the mantissa, whose series converges quickly around 1.
double log(double x) {
    int exponent = 0;
    double mantissa = std::frexp(x, &exponent);
    if (mantissa < square_root_of_half) {
        mantissa *= 2;
        --exponent;
    }
    double const s = (mantissa - 1) / (mantissa + 1);
    double const square = s * s;
    double sum = 0;
    for (int i = 23; i >= 1; i -= 2)
        sum = sum * square + 1.0 / i;
    return 2 * s * sum + exponent * ln_2;
}

double exp(double x) {
    constexpr double most = 700;
    if (x < -most)
        return 0;
    double const limited = std::min(x, most);
    double const halvings = std::floor(limited / ln_2 + 0.5);
    double const rest = limited - halvings * ln_2;
    double sum = 1;
    for (int i = 16; i >= 1; --i)
        sum = 1 + sum * rest / i;
    return doubled(sum, static_cast<int>(halvings));
}

double pow(double x, double exponent) {
    if (exponent == 0)
        return 1;
    return x > 0 ? exp(exponent * log(x)) : 0;
}

/// Taylor's series of a quarter of the reduced angle, doubled twice.
SineAndCosine sine_and_cosine(double angle) {
    double const turns = std::floor(angle / (2 * pi) + 0.5);
    double const x = (angle - turns * 2 * pi) / 4;
    double const square = x * x;
    double sine = 1;
    double cosine = 1;
    for (int i = 18; i >= 2; i -= 2) {
        sine = 1 - sine * square / (i * (i + 1));
        cosine = 1 - cosine * square / (i * (i - 1));
    }
    SineAndCosine result{sine * x, cosine};
    for (int i = 0; i < 2; ++i)
        result = {2 * result.sine * result.cosine, 1 - 2 * result.sine * result.sine};
    return result;
}

/// The arc tangent of an angle halved three times, by its series.
double angle_of(double y, double x) {
    double const length = std::sqrt(x * x + y * y);
    double tangent = y / (x + length);
    for (int i = 0; i < 2; ++i)
        tangent = tangent / (1 + std::sqrt(1 + tangent * tangent));
    double const square = tangent * tangent;
    double sum = 0;
    for (int i = 25; i >= 1; i -= 2)
        sum = 1.0 / i - sum * square;
    return 8 * tangent * sum;
}

}  // namespace dataflow::portable
