#include <halftone/terminal/output_file.h>

#include <halftone/terminal/exit_code.h>

#include <halftone/file/write.h>

#include <string>
#include <system_error>

namespace halftone::terminal {

namespace fs = std::filesystem;

namespace {

/// Where a file is or would be, whatever it is called: absolute, without links.
fs::path place_of(const fs::path& file) {
  std::error_code none; // as at the end of a loop of links, where writing will fail
  return fs::weakly_canonical(fs::absolute(file, none), none);
}

bool are_same(const fs::path& a, const fs::path& b) {
  std::error_code none;
  if (fs::equivalent(a, b, none)) return true;
  const fs::path place = place_of(a);
  return !place.empty() && place == place_of(b);
}

} // namespace

void check_outputs(const std::vector<Output>& outputs, const std::vector<fs::path>& inputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->file.empty()) continue;
    const std::string named = output->option + ' ' + output->file.string() + ": ";
    for (const fs::path& input : inputs)
      if (!input.empty() && are_same(output->file, input))
        throw ArgumentError(named + "is an input, which would be lost");
    for (auto other = outputs.begin(); other != output; ++other)
      if (!other->file.empty() && are_same(output->file, other->file))
        throw ArgumentError(named + "is what " + other->option + " writes, which would be lost");
    file::check_writable(output->file);
  }
}

SignalShelter::SignalShelter() {
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&signals, signal);
  ::pthread_sigmask(SIG_BLOCK, &signals, &before_);
}

SignalShelter::~SignalShelter() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

} // namespace halftone::terminal
