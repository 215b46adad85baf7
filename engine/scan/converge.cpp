// Multi-scanning inside bounding polyhedra (Tadamura, Nakamae, Nishita c. 1986, section 3.4.1, figure 5):
// samples at a fixed step; where two neighbours meet different first objects, an iteration converges on the
// boundary between them. Ours compares the signature of the first hit (body, face, cell of the pattern,
// lights that reach it), proceeds in batches, and refines both sides where the middle meets a third thing.
//
// Invariant: the samples of a stretch do not depend on what else is in the batch.

#include "converge.h"

#include <halftone/core/small_numbers.h>

#include <algorithm>
#include <cmath>

namespace halftone::scan {

namespace {

struct Request {
  int stretch = 0;
  double x = 0;
};

/// Whether a stretch is wide enough to be sampled just inside its ends.
bool has_ends(const Sampled& stretch) { return stretch.right - stretch.left > 2 * core::line_resolution; }

/// In the middle of each cell, and just inside the ends: what begins between an end and the first middle
/// would not differ from any neighbour.
std::vector<Request> first_round(std::span<const Sampled> stretches, int per_pixel) {
  std::vector<Request> requests;
  for (int s = 0; s < static_cast<int>(stretches.size()); ++s) {
    const Sampled& stretch = stretches[s];
    if (has_ends(stretch)) requests.push_back({s, stretch.left + core::line_resolution / 2});
    for (double cell = std::floor(stretch.left * per_pixel); cell < stretch.right * per_pixel; ++cell) {
      const double left = std::max(stretch.left, cell / per_pixel);
      const double right = std::min(stretch.right, (cell + 1) / per_pixel);
      if (left < right) requests.push_back({s, (left + right) / 2});
    }
    if (has_ends(stretch)) requests.push_back({s, stretch.right - core::line_resolution / 2});
  }
  return requests;
}

std::vector<Request> next_round(std::span<const Sampled> stretches) {
  std::vector<Request> requests;
  for (int s = 0; s < static_cast<int>(stretches.size()); ++s) {
    const std::vector<Sample>& samples = stretches[s].samples;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i)
      if (samples[i].signature != samples[i + 1].signature &&
          samples[i + 1].x - samples[i].x > core::line_resolution)
        requests.push_back({s, (samples[i].x + samples[i + 1].x) / 2});
  }
  return requests;
}

/// Where nothing begins between an end and its neighbour, the neighbour stands for all of its cell, as in
/// mid-stretch.
void drop_like_ends(Sampled& stretch) {
  std::vector<Sample>& samples = stretch.samples;
  if (!has_ends(stretch)) return;
  if (samples.size() > 1 && samples[0].signature == samples[1].signature) samples.erase(samples.begin());
  if (samples.size() > 1 && samples.back().signature == samples[samples.size() - 2].signature)
    samples.pop_back();
}

void evaluate(const Frame& frame, std::span<Sampled> stretches, const std::vector<Request>& requests,
              trace::Counts& counts) {
  std::vector<trace::EyeRay> rays;
  for (const Request& request : requests) {
    const Sampled& stretch = stretches[request.stretch];
    if (!stretch.bodies.empty()) {
      rays.push_back({glm::normalize(frame.screen.direction(request.x, stretch.y)), stretch.bodies});
      continue;
    }
    const trace::Counts before = counts;
    const FlatSample flat =
        shade_flat(frame, frame.faces[stretch.face], stretch.lights, request.x, stretch.y, counts);
    stretches[request.stretch].samples.push_back(
        {request.x, flat.radiance, flat.signature, static_cast<int>(counts.shadow - before.shadow)});
  }
  std::vector<trace::Sample> traced(rays.size());
  frame.tracer.trace(rays, traced, counts);
  auto next = traced.begin();
  for (const Request& request : requests) {
    Sampled& stretch = stretches[request.stretch];
    if (stretch.bodies.empty()) continue;
    stretch.samples.push_back({request.x, next->radiance, next->first, next->rays});
    ++next;
  }
}

} // namespace

void converge(const Frame& frame, std::span<Sampled> stretches, int per_pixel, trace::Counts& counts) {
  std::vector<Request> requests = first_round(stretches, per_pixel);
  while (!requests.empty()) {
    evaluate(frame, stretches, requests, counts);
    for (Sampled& stretch : stretches)
      std::sort(stretch.samples.begin(), stretch.samples.end(),
                [](const Sample& a, const Sample& b) { return a.x < b.x; });
    requests = next_round(stretches);
  }
  for (Sampled& stretch : stretches) drop_like_ends(stretch);
}

} // namespace halftone::scan
