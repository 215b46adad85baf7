#include <halftone/scene/world.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <random>
#include <set>

using namespace halftone::scene;

namespace {

Scene scene_of(std::vector<Shape> shapes) {
  Scene scene;
  scene.camera.target = {0, 1, 0};
  scene.materials.push_back({});
  for (Shape& shape : shapes) {
    Object object;
    object.shape = std::move(shape);
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

/// Number of surfaces that two bodies share.
int shared(const World& world, int a, int b) {
  std::set<int> first, common;
  for (const Face& face : world.bodies[a].faces) first.insert(face.surface);
  for (const Face& face : world.bodies[b].faces)
    if (first.count(face.surface)) common.insert(face.surface);
  return static_cast<int>(common.size());
}

double height(const World& world, const Face& face, const Vec3& p) {
  const auto& plane = std::get<Plane>(world.surfaces[face.surface]);
  return (face.flipped ? -1 : 1) * (glm::dot(plane.normal, p) - plane.offset);
}

} // namespace

TEST_CASE("a block on a floor shares the floor's plane, with its own face looking down") {
  const World world = make_world(
      scene_of({Polygon{{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}}, Box{{-1, -1, 0}, {1, 1, 1}}}));
  REQUIRE(shared(world, 0, 1) == 1);
  for (const Face& face : world.bodies[1].faces)
    if (face.surface == world.bodies[0].faces[0].surface) CHECK(height(world, face, {0, 0, 0.5}) < 0);
}

TEST_CASE("faces closer than 2^-36 of the extent coincide, others do not") {
  const double extent = 8;
  for (const auto& [gap, expected] : {std::pair{0x1p-37, 1}, std::pair{0x1p-35, 0}}) {
    const double z = 1 + gap * extent;
    const World world = make_world(scene_of({Box{{-8, -8, 0}, {8, 8, 1}}, Box{{-1, -1, z}, {1, 1, 2}}}));
    INFO("gap " << gap << " of the extent");
    CHECK(shared(world, 0, 1) == expected);
  }
}

TEST_CASE("coincidence survives any rotation and translation of a stack of every pair of solids") {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> angle(-180, 180), shift(-50, 50);
  const auto solids = [](double z) {
    return std::vector<Shape>{Box{{-1, -1, z}, {1, 1, z + 1}}, Frustum{{0, 0, z}, {0, 0, z + 1}, 1, 1},
                              Frustum{{0, 0, z}, {0, 0, z + 1}, 1, 0.5},
                              Prism{{0, 0, z}, {0, 0, z + 1}, 1, 7, 10}};
  };
  for (int round = 0; round < 200; ++round) {
    const Placement placement{
        0.7, {angle(random), angle(random), angle(random)}, {shift(random), shift(random), shift(random)}};
    for (const Shape& lower : solids(0))
      for (const Shape& upper : solids(1)) {
        Scene scene = scene_of({lower, upper});
        for (Object& object : scene.objects) object.placement = placement;
        INFO("round " << round << ", shapes " << lower.index() << " and " << upper.index());
        // The discs or end faces; two cylinders in line share their sides as well.
        REQUIRE(shared(make_world(scene), 0, 1) >= 1);
      }
  }
}

TEST_CASE("equal quadrics coincide whatever part of them is covered") {
  const World world =
      make_world(scene_of({Frustum{{0, 0, 0}, {0, 0, 3}, 1, 1}, Frustum{{0, 0, 2}, {0, 0, 1}, 1, 1},
                           Frustum{{0, 0, 0}, {0, 0, 4}, 4, 0}, Frustum{{0, 0, 1}, {0, 0, 2}, 3, 2},
                           Sphere{{1, 2, 3}, 2}, Sphere{{1, 2, 3}, 2}, Sphere{{1, 2, 3}, 2.001}}));
  CHECK(shared(world, 0, 1) == 1);
  CHECK(shared(world, 2, 3) == 1);
  CHECK(shared(world, 4, 5) == 1);
  CHECK(shared(world, 4, 6) == 0);
}

TEST_CASE("cones smaller than the tolerance coincide only where they run and widen alike") {
  const World world = make_world(scene_of(
      {Sphere{{0, 0, 0}, 1e17}, Frustum{{0, 0, 0}, {0, 0, 1}, 1, 0.5}, Frustum{{3, 0, 1}, {3, 0, 0}, 0.5, 1},
       Frustum{{0, 0, 0}, {0, 1, 1}, 1, 0.5}, Frustum{{0, 0, 0}, {0, 0, 1}, 0.5, 1}}));
  CHECK(shared(world, 1, 2) > 0);
  const auto side = [&](int body) { return world.bodies[body].faces[0].surface; };
  CHECK(side(1) == side(2));
  CHECK(side(1) != side(3));
  CHECK(side(1) != side(4));
}

TEST_CASE("a thin plate on a floor keeps both of its sides") {
  const World world = make_world(scene_of(
      {Polygon{{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}}, Box{{-1, -1, 0}, {1, 1, 0x1p-40}}}));
  std::set<int> surfaces;
  for (const Face& face : world.bodies[1].faces) surfaces.insert(face.surface);
  CHECK(surfaces.size() == 6);
}

TEST_CASE("every face of every solid looks outward, whichever way a file's loops run") {
  Polyhedron tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                         {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
  Scene scene = scene_of({tetrahedron, Box{{-1, -2, -3}, {1, 2, 3}}, Prism{{1, 1, 1}, {2, 3, 5}, 1, 5, 33}});
  scene.objects.push_back(scene.objects[0]);
  scene.objects.back().shape = Sphere{{0, 0, 0}, 2};
  scene.objects.back().trace = TraceRule::never;
  const World world = make_world(scene);
  for (const Body& body : world.bodies) {
    const Vec3 inside = (body.bounds[0] + body.bounds[1]) / 2.0 - Vec3{0.01};
    for (const Face& face : body.faces) {
      REQUIRE(face.outline.size() >= 3);
      if (&body != &world.bodies[0]) CHECK(height(world, face, inside) < 0);
      for (const Face& other : body.faces)
        for (const Vec3& corner : other.outline) CHECK(height(world, face, corner) < 1e-14);
      const Vec3 turn = glm::cross(face.outline[1] - face.outline[0], face.outline[2] - face.outline[1]);
      const auto& plane = std::get<Plane>(world.surfaces[face.surface]);
      CHECK(glm::dot(turn, plane.normal) * (face.flipped ? -1 : 1) > 0);
    }
  }
}

TEST_CASE("a prism's first corner lies where the format says") {
  const World world = make_world(scene_of({Prism{{0, 0, 0}, {0, 0, 1}, 2, 4, 0}}));
  bool found = false;
  for (const Vec3& p : world.bodies[0].faces[0].outline)
    found = found || glm::length(p - Vec3{2, 0, 0}) < 1e-15;
  CHECK(found);
  CHECK(world.bodies[0].faces.size() == 6);
}

TEST_CASE("a faceted sphere has the stated faces, and a faceted cone one cap") {
  Scene scene = scene_of({Sphere{{0, 0, 0}, 1}, Frustum{{0, 0, 0}, {0, 0, 1}, 1, 0}});
  scene.trace.facets = 9;
  for (Object& object : scene.objects) object.trace = TraceRule::never;
  const World world = make_world(scene);
  CHECK(world.bodies[0].faces.size() == 9 * 4);
  CHECK(world.bodies[1].faces.size() == 9 + 1);
  CHECK_FALSE(world.bodies[1].faces.back().rounded);
  CHECK(world.bodies[0].kind == BodyKind::polyhedron);
}

TEST_CASE("placement scales, then turns about x, y and z, then translates") {
  Scene scene = scene_of({Sphere{{1, 0, 0}, 1}});
  scene.objects[0].placement = {2, {0, 0, 90}, {10, 20, 30}};
  const auto sphere = std::get<SphereSurface>(make_world(scene).surfaces[0]);
  CHECK(sphere.center == Vec3{10, 22, 30});
  CHECK(sphere.radius == 2);
  scene.objects[0].placement = {1, {90, 90, 0}, {0, 0, 0}};
  scene.objects[0].shape = Sphere{{0, 1, 0}, 1}; // y to z about x, then z to x about y
  CHECK(std::get<SphereSurface>(make_world(scene).surfaces[0]).center == Vec3{1, 0, 0});
}

TEST_CASE("what needs tracing is glass, mirrors and round shapes, unless the scene says otherwise") {
  Scene scene = scene_of({Box{{0, 0, 0}, {1, 1, 1}}, Box{{0, 0, 2}, {1, 1, 3}}, Sphere{{5, 5, 5}, 1},
                          Sphere{{9, 9, 9}, 1}, Box{{0, 0, 4}, {1, 1, 5}}, Box{{0, 0, 6}, {1, 1, 7}}});
  scene.materials.resize(3);
  scene.materials[1].glass = Glass{1.5, {0, 0, 0}};
  scene.materials[2].mirror = {0.5, 0, 0};
  scene.objects[1].material = 1;
  scene.objects[3].trace = TraceRule::never;
  scene.objects[4].material = 2;
  scene.objects[5].trace = TraceRule::always;
  const World world = make_world(scene);
  const std::vector<bool> expected{false, true, true, false, true, true};
  for (std::size_t i = 0; i < expected.size(); ++i) CHECK(world.bodies[i].traced == expected[i]);
  for (const Body& body : make_world(scanline_scene(scene)).bodies) CHECK_FALSE(body.traced);
}

TEST_CASE("mode scanline draws glass opaque with its own albedo and highlight, and without its pattern") {
  Scene scene = scene_of({Box{{0, 0, 0}, {1, 1, 1}}});
  scene.materials[0].diffuse = {0.1, 0.2, 0.3};
  scene.materials[0].opaque = {0.4, 0.5, 0.6};
  scene.materials[0].specular = {0.7, 0.8, 0.9};
  scene.materials[0].shininess = 77;
  scene.materials[0].glass = Glass{1.5, {1, 2, 3}};
  scene.materials[0].checker = Checker{{1, 0, 0}, 1, 0, 1};
  const Material drawn = scanline_scene(scene).materials.at(0);
  CHECK_FALSE(drawn.glass);
  CHECK(drawn.diffuse == Color{0.4, 0.5, 0.6});
  CHECK(drawn.specular == Color{0.7, 0.8, 0.9});
  CHECK(drawn.shininess == 77);
  CHECK_FALSE(drawn.checker);
}

TEST_CASE("mode scanline leaves mirrors dark, and opaque albedos, highlights and patterns as they are") {
  Scene scene = scene_of({Box{{0, 0, 0}, {1, 1, 1}}});
  scene.materials[0].diffuse = {0.1, 0.2, 0.3};
  scene.materials[0].opaque = {0.4, 0.5, 0.6};
  scene.materials[0].specular = {0.7, 0.8, 0.9};
  scene.materials[0].mirror = {0.5, 0.25, 0};
  scene.materials[0].checker = Checker{{1, 0, 0}, 2, 1, 2};
  const Material drawn = scanline_scene(scene).materials.at(0);
  CHECK(drawn.mirror == Color{0});
  CHECK(drawn.diffuse == Color{0.1, 0.2, 0.3});
  CHECK(drawn.specular == Color{0.7, 0.8, 0.9});
  REQUIRE(drawn.checker);
  CHECK(drawn.checker->color == Color{1, 0, 0});
  CHECK(drawn.checker->size == 2);
}

TEST_CASE("mode scanline draws every round shape faceted, whatever its rule of tracing and material") {
  const Shape sphere = Sphere{{0, 0, 0}, 1}, cone = Frustum{{0, 0, 0}, {0, 0, 1}, 1, 0};
  Scene scene = scene_of({sphere, cone, sphere, Box{{0, 0, 0}, {1, 1, 1}}});
  scene.materials.resize(2);
  scene.materials[1].glass = Glass{1.5, {0, 0, 0}};
  scene.trace.facets = 8;
  scene.objects[1].trace = TraceRule::always;
  scene.objects[2].material = 1;
  scene.objects[3].trace = TraceRule::always;
  const World world = make_world(scanline_scene(scene));
  for (const Body& body : world.bodies) {
    CHECK(body.kind == BodyKind::polyhedron);
    CHECK_FALSE(body.traced);
  }
  CHECK(world.bodies[0].faces.size() == 8 * 4);
  CHECK(world.bodies[1].faces.size() == 8 + 1);
  CHECK(world.bodies[2].faces.size() == 8 * 4);
  CHECK(world.bodies[3].faces.size() == 6);
}

TEST_CASE("the camera's corners are the field of view's") {
  Scene scene = scene_of({});
  scene.image.width = 200;
  scene.image.height = 100;
  scene.camera = {{1, 2, 3}, {1, 7, 3}, {0, 0, 1}, 90};
  const CameraFrame camera = make_world(scene).camera;
  const auto near = [](const Vec3& a, const Vec3& b) { return glm::length(a - b) < 1e-15; };
  CHECK(near(camera.direction(100, 50), {0, 1, 0}));
  CHECK(near(camera.direction(0, 50), glm::normalize(Vec3{-2, 1, 0})));
  CHECK(near(camera.direction(100, 0), glm::normalize(Vec3{0, 1, 1})));
}
