#include "painting.h"

#include "progress.h"

#include <halftone/core/error.h>
#include <halftone/scene/read.h>

#include <sstream>
#include <system_error>
#include <utility>

namespace halftone::cli {

namespace {

using Clock = std::chrono::steady_clock;

/// How often the file is looked at: soon enough for somebody who has saved it and looks up.
constexpr std::chrono::milliseconds look_interval(100);
/// How long a drawing may take to end: to stop, and for what is being sent to be taken.
constexpr std::chrono::milliseconds patience(500);

Painting::Version version_of(const std::filesystem::path& file) {
  std::error_code none;
  return {std::filesystem::last_write_time(file, none), std::filesystem::file_size(file, none)};
}

/// As while an editor replaces it.
bool is_there(const Painting::Version& version) {
  return version.changed_at != std::filesystem::file_time_type::min();
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string in_seconds(double seconds) {
  std::ostringstream text;
  text.precision(2);
  text << std::fixed << seconds << " s";
  return text.str();
}

} // namespace

Painting::Painting(const std::filesystem::path& file, const render::Settings& settings, link::Link& link,
                   std::chrono::milliseconds timeout, Finished finished)
    : file_(file),
      settings_(settings),
      link_(link),
      driver_(link, timeout),
      finished_(std::move(finished)),
      version_(version_of(file)),
      thread_([this](const std::stop_token& end) { work(end); }) {}

Painting::~Painting() { end(); }

void Painting::end() {
  thread_.request_stop();
  std::unique_lock lock(mutex_);
  drawing_.request_stop();
  if (wanted_.wait_for(lock, patience, [&] { return has_ended_; })) return;
  has_cut_ = true;
  link_.cut();
}

void Painting::finish() {
  end();
  thread_.join();
  try {
    if (failure_) std::rethrow_exception(failure_);
  } catch (const link::DeviceError&) {
    if (!has_cut_) throw;
  }
}

void Painting::look() {
  const auto now = Clock::now();
  const bool is_due = now - looked_at_ >= look_interval;
  const Version version = is_due ? version_of(file_) : version_;
  if (is_due) looked_at_ = now;
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
  if (version == version_ || !is_there(version)) return;
  version_ = version;
  is_wanted_ = true;
  drawing_.request_stop();
  wanted_.notify_one();
}

std::string Painting::title() const {
  const std::lock_guard lock(mutex_);
  return title_;
}

void Painting::tell(const std::string& words) {
  const std::lock_guard lock(mutex_);
  title_ = file_.filename().string() + ": " + words;
}

void Painting::work(const std::stop_token& end) {
  try {
    while (true) {
      {
        std::unique_lock lock(mutex_);
        if (!wanted_.wait(lock, end, [&] { return is_wanted_; }) || end.stop_requested()) break;
        is_wanted_ = false;
        drawing_ = {};
      }
      try {
        paint();
      } catch (const core::InputError& error) {
        const std::lock_guard lock(mutex_);
        title_ = error.what(); // begins with the name of the file
      }
    }
  } catch (...) {
    const std::lock_guard lock(mutex_);
    failure_ = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  has_ended_ = true;
  wanted_.notify_all();
}

void Painting::paint() {
  const std::stop_token stop = [&] {
    const std::lock_guard lock(mutex_);
    return drawing_.get_token();
  }();
  tell("reading");
  const scene::Scene scene = scene::read_scene(file_);
  const int width = scene.image.width, height = scene.image.height;
  Painted painted{scene, driver_, {}, {}, driver_.seconds()};
  if (!size_ || size_->width != width || size_->height != height) {
    driver_.begin(width, height);
    size_ = scene.image;
  }
  const auto start = Clock::now();
  const auto take = [&](const render::Row& row) {
    if (!driver_.holds(row.y, row.rgb)) driver_.send_row(row.y, row.rgb);
    painted.radiance.insert(painted.radiance.end(), row.radiance.begin(), row.radiance.end());
    tell(progress_text(row.y + 1, height, seconds_since(start)));
  };
  tell("preparing");
  painted.statistics = render::render(scene, settings_, take, stop);
  if (stop.stop_requested()) return;
  driver_.finish();
  finished_(painted);
  tell("done in " + in_seconds(seconds_since(start)));
}

} // namespace halftone::cli
