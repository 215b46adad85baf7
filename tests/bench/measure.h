#pragma once
// One scene, all contenders: times in turn, errors once.

#include "contender.h"
#include "curve.h"

#include <functional>
#include <optional>

namespace halftone::bench {

struct Measured {
  std::string setting;
  double seconds = 0; ///< the least of its runs
  int runs = 0;
  double error = 0; ///< RMSE in levels: against the exact picture for ours, its own converged one for others
  double exact_error = 0; ///< against the exact picture
};

struct Series {
  std::string contender;
  std::string title;
  std::vector<Measured> measured;
  std::optional<double> limit;  ///< of its own converged picture, against the exact one
  std::vector<Levels> pictures; ///< one for each of measured

  std::vector<Point> points() const;
};

/// The exact picture, and where it is from.
struct Exact {
  Levels levels;
  bool is_rounded = false; ///< to 8 bits: then pictures are rounded before they are compared with it
  std::string origin;
};

struct SceneResult {
  std::string scene;
  Exact exact;
  std::vector<Series> series;

  const Series* find(const std::string& contender) const;
};

struct Effort {
  int repetitions = 5;
  double long_run = 2; ///< seconds: what takes longer is run once
  double longest = 20; ///< seconds: after a setting that takes longer, its contender has no more
};

using Progress = std::function<void(const std::string&)>;

/// From tests/golden where the scene is one of those, else by mode reference, and then kept in the folder.
Exact exact_picture(const Subject& subject, const std::filesystem::path& golden, int threads,
                    const Progress& progress);

/// Every repetition runs every setting of every contender once, so that a slow minute of the machine is
/// nobody's alone.
SceneResult measure(const Subject& subject, const Exact& exact, const Contenders& contenders,
                    const Effort& effort, const Progress& progress);

} // namespace halftone::bench
