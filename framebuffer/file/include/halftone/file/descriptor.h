#pragma once
// A file descriptor that is closed with its owner.

#include <utility>

#include <unistd.h>

namespace halftone::file {

class Descriptor {
public:
  /// Takes over a descriptor; a negative number is none.
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }

  int number() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }

  /// For who closes it himself.
  int release() { return std::exchange(number_, -1); }

  void close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }

private:
  int number_;
};

} // namespace halftone::file
