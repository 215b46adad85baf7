// Ray trees breadth first: the colour of a tree is the sum of weight times local term over its nodes, so
// nothing has to come back, and all rays of one depth are one queue. Each queue is worked off in slices, the
// deepest queue first, which bounds memory for any tree: a queue holds the branches of one slice at the most.
//
// Invariant: the rays of one tree come in the same order at every depth, however batches and slices are cut;
// radiance is added depth by depth. So a sample has the same bits in any batch.

#include <halftone/trace/trace.h>

#include "branch.h"
#include "signature.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory_resource>

namespace halftone::trace {

namespace {

constexpr std::size_t slice_size = 1024; // rays; what is known of them stays in the second-level cache

/// The rays of one depth.
struct Queue {
  std::vector<Ray> rays;
  std::size_t done = 0;
  std::size_t mets = 0; ///< number of entries that gaps of its rays may refer to
};

/// All memory of a call, kept from slice to slice.
struct Workspace {
  explicit Workspace(const Prepared& prepared) : sets(prepared.media) {}

  InsideSets sets;
  std::vector<Queue> queues;                      ///< [0] holds the rays of depth 1
  std::vector<std::vector<core::Color>> radiance; ///< by depth and sample
  /// A stack: a slice drops what slices of its depth, and those deeper, have added before it.
  Mets mets;
  std::vector<Seen> seen;   ///< of a slice, in its first entries
  std::vector<Local> local; ///< likewise
  SeenScratch seen_scratch;
  LocalScratch local_scratch;
};

/// The eye may lie on a surface: then a ray starts in the gap there.
Gap gap_at_eye(const Prepared& prepared, const geometry::Line& line, MeetingScratch& scratch, Mets& mets) {
  geometry::Line behind = line;
  behind.direction = -line.direction;
  behind.outward = !line.outward;
  const Touching ahead = touching(prepared, line, scratch, mets);
  return {ahead, touching(prepared, behind, scratch, mets)};
}

void start(const Prepared& prepared, std::span<const EyeRay> eye, std::span<Sample> samples,
           Workspace& work) {
  Queue& queue = work.queues[0];
  const core::Vec3& origin = prepared.world.camera.eye;
  const int surface = prepared.eye_surface;
  const core::Vec3 normal =
      surface < 0 ? core::Vec3{0} : scene::normal_at(prepared.world.surfaces[surface], origin);
  const int inside = work.sets.number_of(prepared.around_eye);
  work.mets.clear();
  for (std::size_t k = 0; k < eye.size(); ++k) {
    samples[k] = {};
    samples[k].rays = 1;
    const core::Vec3& direction = eye[k].direction;
    const geometry::Line line{origin, direction, surface, glm::dot(normal, direction) > 0, true};
    const bool in_gap = surface >= 0;
    queue.rays.push_back({origin, direction, core::Color{1}, surface, line.outward, in_gap, true, inside,
                          static_cast<int>(k),
                          in_gap ? gap_at_eye(prepared, line, work.seen_scratch.meeting, work.mets) : Gap{}});
  }
  queue.mets = work.mets.size();
}

/// Adds what the slice has brought to its samples.
void collect(const Prepared& prepared, const InsideSets& sets, std::span<const Ray> rays, int depth,
             std::span<const Seen> all_seen, std::span<const Local> local, std::span<core::Color> radiance,
             std::span<Sample> samples) {
  std::array<std::uint64_t, 4> kinds{}; // by SeenKind
  for (std::uint64_t kind = 0; kind < kinds.size(); ++kind)
    kinds[kind] = mixed(static_cast<std::uint64_t>(depth) << 8 | kind);
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const Ray& ray = rays[k];
    const Seen& seen = all_seen[k];
    if (seen.kind == SeenKind::nothing) {
      radiance[ray.sample] += ray.weight * prepared.world.background;
      continue;
    }
    radiance[ray.sample] += ray.weight * local[k].radiance;
    std::uint64_t signature = kinds[static_cast<std::size_t>(seen.kind)];
    signature = mixed(signature ^ pair_of(seen.met.body, seen.met.face));
    signature = mixed(signature ^ pair_of(seen.before, sets.medium(seen.behind)));
    signature = mixed(signature + local[k].facts);
    Sample& sample = samples[ray.sample];
    if (depth == 1) sample.first = signature;
    sample.tree += signature;
  }
}

/// The next slice of the queue of a depth; its branches go to the next queue.
void trace_slice(const Prepared& prepared, int depth, std::span<const EyeRay> eye, std::span<Sample> samples,
                 Workspace& work, Counts& counts) {
  Queue& queue = work.queues[depth - 1];
  Queue& next = work.queues[depth];
  const std::size_t count = std::min(slice_size, queue.rays.size() - queue.done);
  const auto rays = std::span(queue.rays).subspan(queue.done, count);
  queue.done += count;
  if (work.seen.size() < count) {
    work.seen.resize(count);
    work.local.resize(count);
  }
  const auto seen = std::span(work.seen).first(count);
  const auto local = std::span(work.local).first(count);
  work.mets.resize(queue.mets);
  find_seen(prepared, work.sets, rays, depth == 1 ? eye : std::span<const EyeRay>{}, work.seen_scratch,
            work.mets, seen);
  next.mets = work.mets.size();
  shade_seen(prepared, rays, seen, work.local_scratch, local, samples, counts);
  if (depth < prepared.world.trace.depth)
    branch(prepared, work.sets, rays, seen, local, next.rays, samples, counts);
  collect(prepared, work.sets, rays, depth, seen, local, work.radiance[depth - 1], samples);
}

/// All trees of up to slice_size eye rays.
void trace_trees(const Prepared& prepared, std::span<const EyeRay> eye, std::span<Sample> samples,
                 Workspace& work, Counts& counts) {
  counts.eye += eye.size();
  int depth = 1;
  const auto open = [&] { // the queue of this depth, and the next one
    if (work.queues.size() < static_cast<std::size_t>(depth) + 1) {
      work.queues.resize(depth + 1);
      work.radiance.resize(depth + 1);
    }
    if (work.radiance[depth - 1].size() < eye.size())
      work.radiance[depth - 1].assign(eye.size(), core::black);
  };
  for (std::vector<core::Color>& sums : work.radiance) sums.clear();
  open();
  start(prepared, eye, samples, work);
  while (depth > 0) {
    Queue& queue = work.queues[depth - 1];
    if (queue.done == queue.rays.size()) {
      queue.rays.clear();
      queue.done = 0;
      --depth;
      continue;
    }
    trace_slice(prepared, depth, eye, samples, work, counts);
    ++depth;
    open();
  }
  for (std::size_t k = 0; k < eye.size(); ++k)
    for (const std::vector<core::Color>& sums : work.radiance)
      if (!sums.empty()) samples[k].radiance += sums[k];
}

} // namespace

struct Tracer::Impl {
  Impl(const scene::World& world, Search search, core::Simd simd) : prepared(world, search, simd) {}
  Prepared prepared;
};

Tracer::Tracer(const scene::World& world, Search search, core::Simd simd)
    : impl_(std::make_unique<const Impl>(world, search, simd)) {}

Tracer::~Tracer() = default;

std::size_t Tracer::memory() const { return impl_->prepared.memory(); }

void Tracer::trace(std::span<const EyeRay> rays, std::span<Sample> samples, Counts& counts) const {
  Workspace work(impl_->prepared);
  for (std::size_t first = 0; first < rays.size(); first += slice_size) {
    const std::size_t count = std::min(slice_size, rays.size() - first);
    trace_trees(impl_->prepared, rays.subspan(first, count), samples.subspan(first, count), work, counts);
  }
  counts.comparisons += work.seen_scratch.meeting.comparisons + work.local_scratch.shadow.comparisons;
}

Visible Tracer::visibility(const LitPoint& point, int light, std::span<const int> casters,
                           Counts& counts) const {
  ++counts.shadow;
  counts.comparisons += casters.size();
  std::array<std::byte, 1024> memory; // enough but for many solids of glass behind each other
  std::pmr::monotonic_buffer_resource pool(memory.data(), memory.size());
  GlassScratch scratch(&pool);
  return trace::visibility(impl_->prepared, light, point, casters, scratch);
}

} // namespace halftone::trace
