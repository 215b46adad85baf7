#pragma once
// Who takes part: a renderer with settings from fast to accurate.

#include "levels.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace halftone::bench {

struct Drawn {
  Levels levels;
  double seconds = 0; ///< wall time, parsed scene to last row; start-up and files are apart
};

/// A scene to draw. Folders and files are there for those who draw from files.
struct Subject {
  std::string name;
  scene::Scene scene;
  std::filesystem::path folder; ///< where what is drawn for it may be left
};

class Contender {
public:
  virtual ~Contender() = default;

  virtual std::string name() const = 0; ///< a word, for files and tables
  virtual std::string title() const = 0;
  virtual std::vector<std::string> settings() const = 0; ///< from fast to accurate
  virtual Drawn draw(const Subject& subject, std::size_t setting) = 0;

  /// What the settings converge to, with far more samples. Not called where judged_by_exact.
  virtual Levels converged(const Subject& subject) = 0;

  /// Whether its error is the one against the exact picture: ours claim to draw that. The others' error is
  /// against their own converged picture, so that another model of light is not held against them.
  virtual bool judged_by_exact() const { return false; }
};

using Contenders = std::vector<std::unique_ptr<Contender>>;

/// All that there are, ours first, and in `missing` a line for each that is not installed.
Contenders all_contenders(int threads, std::vector<std::string>& missing);

/// The parts of the above, each in its own file.
void add_ours(Contenders& contenders, int threads);
void add_embree(Contenders& contenders, int threads, std::vector<std::string>& missing);
void add_povray(Contenders& contenders, int threads, std::vector<std::string>& missing);

} // namespace halftone::bench
