#include "progress.h"

#include <cmath>
#include <iostream>

#include <unistd.h>

namespace halftone::cli {

namespace {

std::string duration(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole < 60) return std::to_string(whole) + " s";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

} // namespace

std::string progress_text(int done, int rows, double seconds) {
  return "row " + std::to_string(done) + " of " + std::to_string(rows) + ", " +
         duration(seconds * (rows - done) / done) + " left";
}

Progress::Progress(int rows) : rows_(rows), terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (shown_ == 0) return;
  show("");
  std::cerr << '\r' << std::flush;
}

void Progress::report(int done) {
  const auto now = Clock::now();
  if (!terminal_ || now < next_ || done <= 0 || done >= rows_) return;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  show("halftone: " + progress_text(done, rows_, elapsed));
  next_ = now + std::chrono::milliseconds(100);
}

void Progress::show(const std::string& line) {
  const std::string blanks(shown_ > line.size() ? shown_ - line.size() : 0, ' ');
  std::cerr << '\r' << line << blanks << std::flush;
  shown_ = line.size();
}

} // namespace halftone::cli
