#pragma once
// Whose picture survives: the same scene in other units and elsewhere, drawn by each contender and compared
// with what the same setting of it makes of the scene as it is. Where things touch, that picture may be wrong
// already, so it is compared with the exact one too.

#include "measure.h"

namespace halftone::bench {

/// Of one contender and scene. Errors are RMSE in levels.
struct Survival {
  std::string scene;
  std::string contender;
  std::string setting;
  std::vector<double> off; ///< of each transformed scene, against the scene as it is
  std::optional<double>
      exact; ///< of the scene as it is, rounded, against another program's, where there is one
};

struct Survivals {
  std::vector<std::string> transforms; ///< a few words for each
  std::vector<Survival> all;
  std::vector<std::string> missing; ///< a line for each contender that was left out
};

/// One good setting of each contender that has one here. golden: the folder of other programs' pictures.
Survivals survivals(const std::vector<Subject>& subjects, const Contenders& contenders,
                    const std::filesystem::path& golden, const Progress& progress);

/// A table in Markdown.
std::string text_of(const Survivals& survivals);
std::string json_of(const Survivals& survivals);

} // namespace halftone::bench
