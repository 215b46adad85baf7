#pragma once
// A line on the terminal that says how far the picture is and how long it will take.

#include <chrono>
#include <string>

namespace halftone::cli {

/// As in "row 12 of 400, 3 s left", after so many seconds; done is at least 1.
std::string progress_text(int done, int rows, double seconds);

/// Silent where stderr is not a terminal, and during the first second. The line is wiped in the end, so that
/// what is printed next begins at the margin. No escape sequences: any terminal will do.
class Progress {
public:
  explicit Progress(int rows);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// done rows are finished.
  void report(int done);

private:
  using Clock = std::chrono::steady_clock;

  void show(const std::string& line);

  int rows_;
  bool terminal_;
  std::size_t shown_ = 0; ///< length of the line that stands there
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_ + std::chrono::seconds(1);
};

} // namespace halftone::cli
