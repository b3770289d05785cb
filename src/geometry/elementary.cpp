#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <scrubjay/geometry/elementary.hpp>

namespace scrubjay {
namespace {

constexpr double kPiOver2 = 1.57079632679489661923;
// pi/2 in three parts of about 33 bits, so that a multiple of the first two is exact (Cody & Waite, Software Manual
// for the Elementary Functions, 1980).
constexpr double kPiOver2High = 1.57079632673412561417e+00;
constexpr double kPiOver2Middle = 6.07710050630396597660e-11;
constexpr double kPiOver2Low = 2.02226624879595063154e-21;
constexpr double kLn2High = 6.93147180369123816490e-01;
constexpr double kLn2Low = 1.90821492927058770002e-10;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kSqrt2 = 1.41421356237309504880;

// Taylor polynomials on [-pi/4, pi/4]: the first term left out is below 1e-19.
double sin_series(double x) {
  const double z = x * x;
  return x + x * z *
                 (-1.0 / 6 +
                  z * (1.0 / 120 +
                       z * (-1.0 / 5040 +
                            z * (1.0 / 362880 + z * (-1.0 / 39916800 + z * (1.0 / 6227020800.0 +
                                                                            z * (-1.0 / 1307674368000.0 +
                                                                                 z * (1.0 / 355687428096000.0))))))));
}

double cos_series(double x) {
  const double z = x * x;
  return 1.0 + z * (-0.5 + z * (1.0 / 24 +
                                z * (-1.0 / 720 + z * (1.0 / 40320 + z * (-1.0 / 3628800 +
                                                                          z * (1.0 / 479001600.0 +
                                                                               z * (-1.0 / 87178291200.0 +
                                                                                    z * (1.0 / 20922789888000.0))))))));
}

// Arc tangent on [0, 1]: reduced to |t| <= 1/16 around a multiple of 1/8, then its Taylor polynomial.
double atan_unit(double x) {
  if (!(x <= 1.0)) return kNan;
  static constexpr double kAtanEighths[9] = {0.0,
                                             0.12435499454676143503,
                                             0.24497866312686415417,
                                             0.35877067027057223050,
                                             0.46364760900080611621,
                                             0.55859931534356243597,
                                             0.64350110879328438680,
                                             0.71882999962162450542,
                                             0.78539816339744830962};
  const int eighths = static_cast<int>(x * 8.0 + 0.5);
  const double anchor = eighths * 0.125;
  const double t = (x - anchor) / (1.0 + x * anchor);
  const double z = t * t;
  const double series =
      t *
      (1.0 - z * (1.0 / 3 -
                  z * (1.0 / 5 - z * (1.0 / 7 - z * (1.0 / 9 - z * (1.0 / 11 - z * (1.0 / 13 - z * (1.0 / 15))))))));
  return kAtanEighths[eighths] + series;
}

}  // namespace

SinCos sin_cos(double angle) {
  constexpr double kLargest = 1e9;  // past it, nothing would be left of the angle after the reduction
  if (!(std::fabs(angle) <= kLargest)) return {kNan, kNan};
  const double quarter_turns = std::floor(angle * (1.0 / kPiOver2) + 0.5);
  const double r =
      ((angle - quarter_turns * kPiOver2High) - quarter_turns * kPiOver2Middle) - quarter_turns * kPiOver2Low;
  const double s = sin_series(r);
  const double c = cos_series(r);
  switch (static_cast<std::int64_t>(quarter_turns) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double exp(double x) {
  if (!(x > -708.0)) return 0.0;
  if (x > 709.0) x = 709.0;
  const double k = std::floor(x * (1.0 / (kLn2High + kLn2Low)) + 0.5);
  const double r = (x - k * kLn2High) - k * kLn2Low;
  // Taylor polynomial on [-ln2/2, ln2/2]: the first term left out is below 5e-18.
  double series = 1.0 / 6227020800.0;
  series = 1.0 / 479001600.0 + r * series;
  series = 1.0 / 39916800 + r * series;
  series = 1.0 / 3628800 + r * series;
  series = 1.0 / 362880 + r * series;
  series = 1.0 / 40320 + r * series;
  series = 1.0 / 5040 + r * series;
  series = 1.0 / 720 + r * series;
  series = 1.0 / 120 + r * series;
  series = 1.0 / 24 + r * series;
  series = 1.0 / 6 + r * series;
  series = 0.5 + r * series;
  series = 1.0 + r * series;
  series = 1.0 + r * series;
  return series * std::bit_cast<double>(static_cast<std::uint64_t>(static_cast<std::int64_t>(k) + 1023) << 52);
}

double log(double x) {
  if (!(x > 0.0)) return -std::numeric_limits<double>::infinity();
  const auto bits = std::bit_cast<std::uint64_t>(x);
  auto exponent = static_cast<int>(bits >> 52) - 1023;
  double mantissa = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFFull) | 0x3FF0000000000000ull);
  if (mantissa > kSqrt2) {
    mantissa *= 0.5;
    ++exponent;
  }
  // log m = 2 artanh(s); |s| <= 0.172, so the first term left out is below 1e-19.
  const double s = (mantissa - 1.0) / (mantissa + 1.0);
  const double z = s * s;
  double series = 1.0 / 23;
  for (const double odd : {21.0, 19.0, 17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0}) series = 1.0 / odd + z * series;
  return exponent * kLn2High + (2.0 * s + (2.0 * s * z * series + exponent * kLn2Low));
}

double atan2(double y, double x) {
  const double ax = std::fabs(x);
  const double ay = std::fabs(y);
  if (ax == 0.0 && ay == 0.0) return 0.0;
  double angle = ay <= ax ? atan_unit(ay / ax) : kPiOver2 - atan_unit(ax / ay);
  if (x < 0.0) angle = 2.0 * kPiOver2 - angle;
  return y < 0.0 ? -angle : angle;
}

}  // namespace scrubjay
