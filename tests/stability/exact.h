#pragma once
// Arithmetic that is exact beside double's: Twofold, the unevaluated sum of two doubles, by the algorithms of
// T. Dekker (1971) as M. Joldes, J.-M. Muller and V. Popescu proved them ("Tight and rigorous error bounds
// for basic building blocks of double-word arithmetic", 2017): relative errors of sums, products, quotients
// and roots are below 3, 5, 15 and 4 times 2^-106, so that what is judged in units of 2^-53 is judged to
// 2^-45 of a unit. Quad (113 bits, in software, fifteen times as slow) is the check on it.

#include <halftone/core/vector.h>

#include <cmath>

namespace halftone::test {

__extension__ typedef __float128 Quad;

class Twofold {
public:
  Twofold(double value = 0) : high_(value) {}

  explicit operator double() const { return high_; }

  friend Twofold operator+(const Twofold& a, const Twofold& b) {
    const Twofold high = sum(a.high_, b.high_), low = sum(a.low_, b.low_);
    const Twofold most = ordered(high.high_, high.low_ + low.high_);
    return ordered(most.high_, low.low_ + most.low_);
  }
  friend Twofold operator-(const Twofold& a) { return {-a.high_, -a.low_}; }
  friend Twofold operator-(const Twofold& a, const Twofold& b) { return a + -b; }
  friend Twofold operator*(const Twofold& a, const Twofold& b) {
    const Twofold high = product(a.high_, b.high_);
    return ordered(high.high_, high.low_ + (a.high_ * b.low_ + a.low_ * b.high_));
  }
  friend Twofold operator/(const Twofold& a, const Twofold& b) {
    const double high = a.high_ / b.high_;
    return ordered(high, (a - b * Twofold(high)).high_ / b.high_);
  }
  friend bool operator<(const Twofold& a, const Twofold& b) {
    return a.high_ < b.high_ || (a.high_ == b.high_ && a.low_ < b.low_);
  }
  friend bool operator>(const Twofold& a, const Twofold& b) { return b < a; }
  friend bool operator==(const Twofold& a, const Twofold& b) = default;

  /// 0 of what is not positive.
  friend Twofold root(const Twofold& value) {
    if (!(value.high_ > 0)) return 0.0;
    const double high = std::sqrt(value.high_);
    return ordered(high, (value - product(high, high)).high_ / (2 * high));
  }

private:
  Twofold(double high, double low) : high_(high), low_(low) {}

  static Twofold sum(double a, double b) {
    const double s = a + b, of_b = s - a;
    return {s, (a - (s - of_b)) + (b - of_b)};
  }
  /// The same where |a| >= |b|.
  static Twofold ordered(double a, double b) {
    const double s = a + b;
    return {s, b - (s - a)};
  }
  static Twofold product(double a, double b) {
    const double p = a * b;
    return {p, std::fma(a, b, -p)};
  }

  double high_ = 0, low_ = 0;
};

/// Newton's method from the double: each step doubles the bits. 0 of what is not positive.
inline Quad root(Quad value) {
  if (!(value > 0)) return 0;
  Quad x = std::sqrt(static_cast<double>(value));
  for (int k = 0; k < 3; ++k) x = (x + value / x) / 2;
  return x;
}

/// Real: Twofold or Quad.
template<typename Real>
struct ExactVec {
  Real x = 0, y = 0, z = 0;

  ExactVec() = default;
  ExactVec(const Real& a, const Real& b, const Real& c) : x(a), y(b), z(c) {}
  explicit ExactVec(const core::Vec3& v) : x(v.x), y(v.y), z(v.z) {}

  friend ExactVec operator+(const ExactVec& a, const ExactVec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend ExactVec operator-(const ExactVec& a, const ExactVec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend ExactVec operator*(const Real& s, const ExactVec& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Real dot(const ExactVec& a, const ExactVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
  friend ExactVec cross(const ExactVec& a, const ExactVec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
  friend Real length(const ExactVec& a) { return root(dot(a, a)); }
};

} // namespace halftone::test
