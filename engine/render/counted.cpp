#include "counted.h"

#include <algorithm>
#include <vector>

namespace halftone::render {

void add(const scan::Counts& counts, Statistics& statistics) {
  statistics.rays.eye += counts.rays.eye;
  statistics.rays.reflected += counts.rays.reflected;
  statistics.rays.refracted += counts.rays.refracted;
  statistics.rays.shadow += counts.rays.shadow;
  statistics.virtual_lines += counts.virtual_lines;
  statistics.intervals += counts.intervals;
  statistics.samples += counts.samples;
  statistics.comparisons += counts.comparisons + counts.rays.comparisons;
  statistics.traced_pixels += counts.traced_pixels;
  statistics.skipped.branches += counts.rays.cut_off;
  statistics.skipped.samples += counts.plain_pixels;
}

void add_frame(const scan::Frame& frame, Statistics& statistics) {
  statistics.prepared_bytes += frame.memory();
  statistics.skipped.faces += frame.hidden_faces;
  std::vector<bool> is_needed(frame.world.bodies.size(), !frame.traced.empty()); // a ray may meet anything
  for (const scan::ScreenFace& face : frame.faces) is_needed[face.body] = true;
  for (const std::vector<int>& casters : frame.casters) {
    statistics.skipped.casters += frame.world.bodies.size() - casters.size();
    for (const int body : casters) is_needed[body] = true;
  }
  statistics.skipped.objects += std::count(is_needed.begin(), is_needed.end(), false);
}

} // namespace halftone::render
