#pragma once
// A scene that is drawn beside a window, and again when its file changes.

#include <halftone/core/vector.h>
#include <halftone/driver/driver.h>
#include <halftone/link/link.h>
#include <halftone/render/render.h>
#include <halftone/scene/scene.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace halftone::cli {

/// A picture, all of which is with the device.
struct Painted {
  const scene::Scene& scene;
  driver::Driver& driver;
  render::Statistics statistics;
  std::vector<core::Color> radiance;
  double seconds_before = 0; ///< of the driver, for earlier pictures
};

/// Draws in a thread of its own, which sends the rows; a row that the device holds already is not sent again.
class Painting {
public:
  /// What to do with a picture, in the thread that draws.
  using Finished = std::function<void(const Painted& painted)>;

  /// Of a file: what was written within a tick of the system's clock has the same time, but another size
  /// where the file was looked at half written.
  struct Version {
    std::filesystem::file_time_type changed_at = std::filesystem::file_time_type::min();
    std::uintmax_t size = 0;

    bool operator==(const Version&) const = default;
  };

  /// Begins to draw. Nobody else receives over the link, which must outlive the painting.
  Painting(const std::filesystem::path& file, const render::Settings& settings, link::Link& link,
           std::chrono::milliseconds timeout, Finished finished);

  /// Ends at once, whatever is not drawn yet. A device that is being waited for is not waited for any longer:
  /// the link is cut.
  ~Painting();

  /// Ends likewise, and throws what has failed by then, but not what its own end has broken off.
  void finish();
  Painting(const Painting&) = delete;
  Painting& operator=(const Painting&) = delete;

  /// To be called now and then: draws again where the file has changed. Throws what ended the drawing: errors
  /// of the device and of output files. One in the scene file is words, for it may be gone with the next
  /// change.
  void look();

  /// As in "scene.toml: row 12 of 400, 3 s left".
  std::string title() const;

private:
  void end();
  void work(const std::stop_token& end);
  void paint();
  void tell(const std::string& words);

  std::filesystem::path file_;
  render::Settings settings_;
  link::Link& link_;
  driver::Driver driver_;
  Finished finished_;

  Version version_; ///< of the file, when it was looked at last
  std::chrono::steady_clock::time_point looked_at_;

  std::optional<scene::Image> size_; ///< that the driver began with

  mutable std::mutex mutex_; ///< guards what follows
  std::condition_variable_any wanted_;
  bool is_wanted_ = true;    ///< to draw, again
  std::stop_source drawing_; ///< the drawing that is under way, or the next
  std::string title_;
  std::exception_ptr failure_;
  bool has_ended_ = false; ///< the thread's work
  bool has_cut_ = false;   ///< the link

  std::jthread thread_; ///< the last: it uses the others
};

} // namespace halftone::cli
