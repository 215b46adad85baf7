// J. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates" (1997),
// section 4.2. Changed: of his four stages we have the first, which nearly always knows, and the exact one.
//
// Invariant: the sign is that of the points as they are, so what is built on it (convex_hull) is convex to
// the bit, however near to each other its corners lie.

#include "turn.h"

#include <array>
#include <cmath>

namespace halftone::view {

namespace {

/// A sum without rounding, as numbers of ascending size that do not overlap.
class Expansion {
public:
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  /// The largest number that is not zero says it.
  int sign_of_sum() const {
    for (std::size_t k = count_; k-- > 0;)
      if (numbers_[k] != 0) return sign(numbers_[k]);
    return 0;
  }

private:
  /// Grow-Expansion, by Knuth's sum of two numbers and its error.
  void add(double number) {
    for (std::size_t k = 0; k < count_; ++k) {
      const double sum = number + numbers_[k];
      const double part = sum - number;
      numbers_[k] = (number - (sum - part)) + (numbers_[k] - part);
      number = sum;
    }
    numbers_[count_++] = number;
  }

  std::array<double, 12> numbers_{};
  std::size_t count_ = 0;
};

} // namespace

int sign_of_products(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c) {
  Expansion sum;
  sum.add_product(a.x, b.y);
  sum.add_product(-a.y, b.x);
  sum.add_product(b.x, c.y);
  sum.add_product(-b.y, c.x);
  sum.add_product(c.x, a.y);
  sum.add_product(-c.y, a.x);
  return sum.sign_of_sum();
}

} // namespace halftone::view
