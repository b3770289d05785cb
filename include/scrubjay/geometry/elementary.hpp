/// \file
/// Elementary functions that give the same bits on every machine.
///
/// The C library's sin, exp and their kin may differ in the last bit between processors and between libraries, which
/// would break two promises: same seed, same bytes; and a microcontroller that computes what the host does. These use
/// IEEE 754 addition, multiplication, division and square root alone, which are exactly rounded everywhere. Accurate
/// to about 1e-15 relative (absolute near zeros), over the ranges stated.
#pragma once

namespace scrubjay {

struct SinCos {
  double sin;
  double cos;
};

/// Sine and cosine of `angle` [rad], |angle| up to 1e6; past 1e9, and for what is no number, both are NaN.
SinCos sin_cos(double angle);

/// e to the power of x; 0 below -708, clamped to exp(709) above.
double exp(double x);

/// Natural logarithm of x > 0 (normal numbers). -infinity for x <= 0.
double log(double x);

/// Angle of the vector (x, y) in (-pi, pi]; 0 for the zero vector, NaN if either is no number or both are infinite.
double atan2(double y, double x);

}  // namespace scrubjay
