#include "embree_scene.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace halftone::bench {

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

float below(double x) { return std::nextafter(static_cast<float>(x), -infinite); }
float above(double x) { return std::nextafter(static_cast<float>(x), infinite); }

void set_line(RTCRay& ray, const Line& line, float tnear, float tfar) {
  ray.org_x = static_cast<float>(line.origin.x);
  ray.org_y = static_cast<float>(line.origin.y);
  ray.org_z = static_cast<float>(line.origin.z);
  ray.dir_x = static_cast<float>(line.direction.x);
  ray.dir_y = static_cast<float>(line.direction.y);
  ray.dir_z = static_cast<float>(line.direction.z);
  ray.tnear = tnear;
  ray.tfar = tfar;
  ray.time = 0;
  ray.mask = ~0U;
  ray.flags = 0;
}

} // namespace

/// What Embree hands through to the callbacks. The context comes first, so that the one is the other.
struct EmbreeScene::Query {
  RTCIntersectContext context;
  const EmbreeScene* scene = nullptr;
  Line line;
  double distance = 0; ///< of a shadow ray
  int start = -1;
  const InsideSet* inside = nullptr;
  Hit hit; ///< of user geometry
  std::vector<GlassSpan>* spans = nullptr;

  Query(const EmbreeScene& of, const Line& along) : scene(&of), line(along) {
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  }
  static Query& of(RTCIntersectContext* context) { return *reinterpret_cast<Query*>(context); }
};

void InsideSet::add(int body) {
  if (count_ == capacity)
    throw std::runtime_error("more solids in one another than the Embree contender takes");
  bodies_[static_cast<std::size_t>(count_++)] = body;
}

void InsideSet::remove(int body) {
  for (int i = 0; i < count_; ++i)
    if (bodies_[static_cast<std::size_t>(i)] == body) {
      bodies_[static_cast<std::size_t>(i)] = bodies_[static_cast<std::size_t>(--count_)];
      return;
    }
}

EmbreeScene::EmbreeScene(RTCDevice device, const scene::World& world)
    : world_(world),
      epsilon_(static_cast<float>(1e-5 * world.extent)) {
  for (int b = 0; b < static_cast<int>(world.bodies.size()); ++b) {
    const scene::Body& body = world.bodies[b];
    const bool round = body.kind == scene::BodyKind::sphere || body.kind == scene::BodyKind::frustum;
    const bool glass = world.materials[body.material].glass.has_value();
    is_flat_.push_back(!glass && !round);
    if (glass)
      glass_.all.emplace_back(world, b);
    else if (round)
      opaque_.all.emplace_back(world, b);
    else
      for (int f = 0; f < static_cast<int>(body.faces.size()); ++f)
        for (std::size_t k = 1; k + 1 < body.faces[f].outline.size(); ++k)
          triangles_.push_back({b, f, std::get<scene::Plane>(world.surfaces[body.faces[f].surface])});
  }
  for (RTCScene* scene : {&all_, &opaque_scene_, &glass_scene_}) {
    *scene = rtcNewScene(device);
    rtcSetSceneFlags(*scene, RTC_SCENE_FLAG_ROBUST);
  }
  add_triangles(device);
  add_solids(device, opaque_, false);
  add_solids(device, glass_, true);
  for (RTCScene scene : {all_, opaque_scene_, glass_scene_}) rtcCommitScene(scene);
}

EmbreeScene::~EmbreeScene() {
  for (RTCScene scene : {all_, opaque_scene_, glass_scene_}) rtcReleaseScene(scene);
}

void EmbreeScene::add_triangles(RTCDevice device) {
  if (triangles_.empty()) return;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 3 * triangles_.size()));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles_.size()));
  if (!vertices || !indices) throw std::runtime_error("Embree has no memory for the triangles");
  unsigned next = 0;
  for (std::size_t i = 0, k = 1; i < triangles_.size(); ++i) {
    const Triangle& triangle = triangles_[i];
    const std::vector<Vec3>& outline = world_.bodies[triangle.body].faces[triangle.face].outline;
    if (i > 0 && (triangles_[i - 1].body != triangle.body || triangles_[i - 1].face != triangle.face)) k = 1;
    for (const std::size_t corner : {std::size_t{0}, k, k + 1}) {
      for (int axis = 0; axis < 3; ++axis) *vertices++ = static_cast<float>(outline[corner][axis]);
      *indices++ = next++;
    }
    ++k;
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(all_, geometry);
  rtcAttachGeometry(opaque_scene_, geometry);
  rtcReleaseGeometry(geometry);
}

void EmbreeScene::add_solids(RTCDevice device, Solids& solids, bool glass) {
  if (solids.all.empty()) return;
  solids.scene = this;
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(solids.all.size()));
  rtcSetGeometryUserData(geometry, &solids);
  rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, meet);
  rtcSetGeometryOccludedFunction(geometry, glass ? collect_glass : shade_by_opaque);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(all_, geometry);
  rtcAttachGeometry(glass ? glass_scene_ : opaque_scene_, geometry);
  rtcReleaseGeometry(geometry);
}

void EmbreeScene::bounds(const RTCBoundsFunctionArguments* arguments) {
  const auto& solids = *static_cast<const Solids*>(arguments->geometryUserPtr);
  const int body = solids.all[arguments->primID].body();
  const auto& [low, high] = solids.scene->world_.bodies[body].bounds;
  RTCBounds& box = *arguments->bounds_o;
  box.lower_x = below(low.x);
  box.lower_y = below(low.y);
  box.lower_z = below(low.z);
  box.upper_x = above(high.x);
  box.upper_y = above(high.y);
  box.upper_z = above(high.z);
}

void EmbreeScene::meet(const RTCIntersectFunctionNArguments* arguments) {
  if (!arguments->valid[0]) return;
  const Convex& solid = static_cast<const Solids*>(arguments->geometryUserPtr)->all[arguments->primID];
  Query& query = Query::of(arguments->context);
  const bool inside = query.inside->has(solid.body());
  if (!inside && query.start == solid.body()) return;
  const auto span = solid.cut(query.line);
  if (!span || span->out <= 0) return;
  const double t = inside ? span->out : std::max(span->in, 0.0);
  auto& ray = *reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  // Between solids the double decides; a triangle that is nearer has shortened the ray since.
  const bool solid_is_nearest = query.hit.body >= 0 && ray.ray.tfar == static_cast<float>(query.hit.t);
  if (t >= (solid_is_nearest ? query.hit.t : static_cast<double>(ray.ray.tfar))) return;
  query.hit = {t, solid.body(), inside ? span->out_face : span->in_face};
  ray.ray.tfar = static_cast<float>(t);
  ray.hit.geomID = arguments->geomID;
  ray.hit.primID = arguments->primID;
}

void EmbreeScene::shade_by_opaque(const RTCOccludedFunctionNArguments* arguments) {
  if (!arguments->valid[0]) return;
  const Query& query = Query::of(arguments->context);
  const Convex& solid = static_cast<const Solids*>(arguments->geometryUserPtr)->all[arguments->primID];
  if (query.start == solid.body()) return;
  const auto span = solid.cut(query.line);
  if (!span || span->out <= 0 || span->in >= query.distance) return;
  reinterpret_cast<RTCRay*>(arguments->ray)->tfar = -infinite;
}

void EmbreeScene::collect_glass(const RTCOccludedFunctionNArguments* arguments) {
  if (!arguments->valid[0]) return;
  const Query& query = Query::of(arguments->context);
  const Convex& solid = static_cast<const Solids*>(arguments->geometryUserPtr)->all[arguments->primID];
  if (query.start == solid.body()) return; // seen from outside, in light from outside
  const auto span = solid.cut(query.line);
  if (!span || span->out <= 0 || span->in >= query.distance) return;
  query.spans->push_back({*span, solid.body()});
}

float EmbreeScene::tnear(int start) const {
  return start >= 0 && is_flat_[static_cast<std::size_t>(start)] ? epsilon_ : 0;
}

Hit EmbreeScene::nearest(const Line& line, int start, const InsideSet& inside) const {
  Query query(*this, line);
  query.start = start;
  query.inside = &inside;
  RTCRayHit ray;
  set_line(ray.ray, line, tnear(start), infinite);
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(all_, &query.context, &ray);
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  if (triangles_.empty() || ray.hit.geomID != 0) return query.hit; // triangles were attached first
  const Triangle& triangle = triangles_[ray.hit.primID];
  const scene::Plane& plane = triangle.plane; // the distance again, in double precision
  const double t =
      (plane.offset - glm::dot(plane.normal, line.origin)) / glm::dot(plane.normal, line.direction);
  return {std::max(0.0, t), triangle.body, triangle.face};
}

bool EmbreeScene::is_dark(const Line& line, double distance, int start) const {
  Query query(*this, line);
  query.distance = distance;
  query.start = start;
  RTCRay ray;
  set_line(ray, line, tnear(start), below(distance));
  rtcOccluded1(opaque_scene_, &query.context, &ray);
  return ray.tfar < 0;
}

std::span<const GlassSpan> EmbreeScene::glass_between(const Line& line, double distance, int start) const {
  thread_local std::vector<GlassSpan> spans;
  spans.clear();
  Query query(*this, line);
  query.distance = distance;
  query.start = start;
  query.spans = &spans;
  RTCRay ray;
  set_line(ray, line, 0, above(distance));
  rtcOccluded1(glass_scene_, &query.context, &ray);
  return spans;
}

InsideSet EmbreeScene::solids_around(const Vec3& point) const {
  InsideSet inside;
  for (int b = 0; b < static_cast<int>(world_.bodies.size()); ++b)
    if (world_.bodies[b].kind != scene::BodyKind::polygon && Convex(world_, b).contains(point)) inside.add(b);
  return inside;
}

} // namespace halftone::bench
