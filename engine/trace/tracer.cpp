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

namespace halftone::trace {

namespace {

constexpr std::size_t slice_size = 1024; // rays; what is known of them stays in the second-level cache

/// All memory of a call, kept from slice to slice.
struct Workspace {
  explicit Workspace(const Prepared& prepared) : sets(prepared.media) {}

  InsideSets sets;
  std::vector<Rays> queues;                       ///< [0] holds the rays of depth 1
  std::vector<std::size_t> done;                  ///< of each queue
  std::vector<std::vector<core::Color>> radiance; ///< by depth and sample
  Seen seen;
  Local local;
  SeenScratch seen_scratch;
  LocalScratch local_scratch;
};

/// The eye may lie on a surface: then a ray starts in the gap there.
Gap gap_at_eye(const Prepared& prepared, const geometry::Line& line, MeetingScratch& scratch,
               std::vector<Met>& mets) {
  geometry::Line behind = line;
  behind.direction = -line.direction;
  behind.outward = !line.outward;
  const Touching ahead = touching(prepared, line, scratch, mets);
  return {ahead, touching(prepared, behind, scratch, mets)};
}

void start(const Prepared& prepared, std::span<const EyeRay> eye, std::span<Sample> samples,
           Workspace& work) {
  Rays& rays = work.queues[0];
  const core::Vec3& origin = prepared.world.camera.eye;
  const int surface = prepared.eye_surface;
  const core::Vec3 normal =
      surface < 0 ? core::Vec3{0} : scene::normal_at(prepared.world.surfaces[surface], origin);
  const int inside = work.sets.number_of(prepared.around_eye);
  for (std::size_t k = 0; k < eye.size(); ++k) {
    samples[k] = {};
    samples[k].rays = 1;
    const std::size_t i = rays.add();
    const core::Vec3& direction = eye[k].direction;
    const geometry::Line line{origin, direction, surface, glm::dot(normal, direction) > 0, true};
    rays.set_origin(i, origin);
    rays.set_direction(i, direction);
    rays.set_weight(i, core::Color{1});
    rays.surface[i] = surface;
    rays.outward[i] = line.outward;
    rays.inside[i] = inside;
    rays.in_gap[i] = surface >= 0;
    if (surface >= 0) rays.gap[i] = gap_at_eye(prepared, line, work.seen_scratch.meeting, rays.mets);
    rays.sample[i] = static_cast<int>(k);
  }
}

/// Adds what the slice has brought to its samples.
void collect(const Prepared& prepared, const InsideSets& sets, const Rays& rays, Slice slice, int depth,
             const Seen& seen, const Local& local, std::span<core::Color> radiance,
             std::span<Sample> samples) {
  for (std::size_t k = 0; k < slice.size(); ++k) {
    const std::size_t ray = slice.begin + k;
    const int sample = rays.sample[ray];
    if (seen.kind[k] == SeenKind::nothing) {
      radiance[sample] += rays.weight(ray) * prepared.world.background;
      continue;
    }
    radiance[sample] += rays.weight(ray) * local.radiance[k];
    const Met& met = seen.met[k];
    std::uint64_t signature =
        mixed(static_cast<std::uint64_t>(depth) << 8 | static_cast<std::uint64_t>(seen.kind[k]));
    signature = mixed(signature ^ pair_of(met.body, met.face));
    signature = mixed(signature ^ pair_of(seen.before[k], sets.medium(seen.behind[k])));
    signature = mixed(signature + local.facts[k]);
    if (depth == 1) samples[sample].first = signature;
    samples[sample].tree += signature;
  }
}

/// One slice of the queue of a depth; its branches go to the next queue.
void trace_slice(const Prepared& prepared, Slice slice, int depth, std::span<const EyeRay> eye,
                 std::span<Sample> samples, Workspace& work, Counts& counts) {
  Rays& rays = work.queues[depth - 1];
  find_seen(prepared, work.sets, rays, slice, depth == 1 ? eye : std::span<const EyeRay>{}, work.seen_scratch,
            work.seen);
  shade_seen(prepared, rays, slice, work.seen, work.local_scratch, work.local, samples, counts);
  if (depth < prepared.world.trace.depth)
    branch(prepared, work.sets, rays, slice, work.seen, work.local, work.queues[depth], samples, counts);
  collect(prepared, work.sets, rays, slice, depth, work.seen, work.local, work.radiance[depth - 1], samples);
}

/// All trees of up to slice_size eye rays.
void trace_trees(const Prepared& prepared, std::span<const EyeRay> eye, std::span<Sample> samples,
                 Workspace& work, Counts& counts) {
  counts.eye += eye.size();
  int depth = 1;
  const auto open = [&] { // the queue of this depth, and the next one
    if (work.queues.size() < static_cast<std::size_t>(depth) + 1) {
      work.queues.resize(depth + 1);
      work.done.resize(depth + 1);
      work.radiance.resize(depth + 1);
    }
    if (work.radiance[depth - 1].size() < eye.size())
      work.radiance[depth - 1].assign(eye.size(), core::black);
  };
  for (std::vector<core::Color>& sums : work.radiance) sums.clear();
  open();
  start(prepared, eye, samples, work);
  while (depth > 0) {
    Rays& rays = work.queues[depth - 1];
    std::size_t& done = work.done[depth - 1];
    if (done == rays.count) {
      rays.clear();
      done = 0;
      --depth;
      continue;
    }
    const Slice slice{done, std::min(done + slice_size, rays.count)};
    done = slice.end;
    trace_slice(prepared, slice, depth, eye, samples, work, counts);
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
  ShadowScratch scratch;
  const Visible visible = trace::visibility(impl_->prepared, light, point, casters, scratch);
  counts.comparisons += scratch.comparisons;
  return visible;
}

} // namespace halftone::trace
