#pragma once
// A scene made from a fuzzer's bytes: its numbers are few, so that faces coincide, eyes and lights lie on
// surfaces and rays along them; some a little off, and some out of all proportion. It is written as text, for
// the reader to say what is valid.

#include "read.h"

#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>

namespace halftone::fuzz {

class SceneMaker {
public:
  SceneMaker(const std::uint8_t* bytes, std::size_t size) : fuzz_(bytes, size) {}

  /// Without the objects that the reader refuses; nothing where it refuses the camera.
  std::optional<scene::Scene> make() {
    if (chance(4)) unit_ = std::pow(10.0, count(-40, 40));
    write_surroundings();
    for (int k = 0; k < materials; ++k) write_material(k);
    const std::string head = std::exchange(text_, exact_text()).str();
    auto scene = read(head);
    if (!scene) return std::nullopt;
    scene->title = fuzz_.ConsumeBytesAsString(8);
    for (int k = count(1, 6); k > 0; --k) {
      write_object();
      if (const auto one = read(head + std::exchange(text_, exact_text()).str()))
        scene->objects.push_back(one->objects[0]);
    }
    return scene;
  }

private:
  static constexpr int materials = 3;

  void write_surroundings() {
    text_ << "format = 1\n[image]\nwidth = " << count(1, 6) << "\nheight = " << count(1, 4);
    text_ << "\n[camera]\neye = " << point() << "\ntarget = " << point() << "\nup = " << direction();
    text_ << "\nfov = "
          << (chance(8) ? fuzz_.PickValueInArray({1e-60, 1e-7, 0.01, 179.0, 179.999999999}) : 50.0);
    text_ << "\n[background]\ncolor = " << radiance() << "\n[ambient]\ncolor = " << radiance();
    text_ << "\n[trace]\ndepth = " << count(1, 4) << "\ncutoff = " << fuzz_.PickValueInArray({0.01, 0.0, 1.0})
          << "\nfacets = " << count(3, 12) << '\n';
    for (int k = count(0, 2); k > 0; --k)
      text_ << "[[light]]\nposition = " << point() << "\ncolor = " << radiance() << '\n';
  }

  static std::ostringstream exact_text() {
    std::ostringstream text;
    text << std::setprecision(17);
    return text;
  }

  bool chance(int of) { return fuzz_.ConsumeIntegralInRange(0, of - 1) == 1; } // not where bytes have run out
  int count(int least, int most) { return fuzz_.ConsumeIntegralInRange(least, most); }

  double number() {
    switch (fuzz_.ConsumeIntegralInRange(0, 15)) {
    case 0:
      return fuzz_.ConsumeIntegral<std::int16_t>() / 4096.0;
    case 1: // a little off
      return count(-4, 4) / 2.0 * (1 + std::ldexp(count(-2, 2), -count(20, 53)));
    case 2: // far off
      return std::ldexp(count(-4, 4), count(-60, 60));
    case 3: // that no product may underflow or overflow
      return fuzz_.PickValueInArray({1e-300, -1e-170, 1e-90, 1e59, -1e50}) / unit_;
    default:
      return count(-4, 4) / 2.0;
    }
  }
  std::string vector(double by) {
    std::ostringstream vector = exact_text();
    vector << '[' << number() * by << ", " << number() * by << ", " << number() * by << ']';
    return vector.str();
  }
  std::string point() { return vector(unit_); }
  std::string direction() { return chance(2) ? vector(1) : "[0, 0, 1]"; }
  double length() {
    const double size = std::abs(number());
    return (size > 0 ? size : 1) * unit_;
  }

  const char* albedo() {
    return fuzz_.PickValueInArray({"[0.5, 0.6, 0.7]", "[0, 0, 0]", "[1, 1, 1]", "[1, 0, 1e-60]"});
  }
  const char* radiance() {
    if (chance(32)) return "[1e60, 1, 1e-60]"; // slow: no pixel is ever good enough
    return fuzz_.PickValueInArray({"[0.3, 0.2, 0.1]", "[0, 0, 0]", "[1, 1, 1]"});
  }

  void write_material(int k) {
    text_ << "[material.m" << k << "]\n";
    if (chance(2)) text_ << "diffuse = " << albedo() << '\n';
    if (chance(2))
      text_ << "specular = " << radiance()
            << "\nshininess = " << fuzz_.PickValueInArray({20.0, 0.0, 1e-60, 1e60, 1e16}) << '\n';
    if (chance(3))
      text_ << "ior = " << fuzz_.PickValueInArray({1.5, 1.0, 0.7, 1 + 0x1p-52, 1e60, 1e-60, 1e8})
            << "\nabsorption = " << radiance() << '\n';
    else if (chance(3))
      text_ << "mirror = " << albedo() << '\n';
    if (chance(3))
      text_ << "checker = { color = " << albedo() << ", size = " << length() << ", axes = \""
            << fuzz_.PickValueInArray({"xy", "yz", "zx"}) << "\" }\n";
  }

  void write_object() {
    const int kind = count(0, 7);
    text_ << "[[object]]\nmaterial = \"m" << count(0, materials - 1) << "\"\n";
    if (chance(3)) text_ << "trace = " << fuzz_.PickValueInArray({"\"always\"", "\"never\""}) << '\n';
    if (chance(4)) text_ << "scale = " << length() / unit_ << '\n';
    if (chance(4))
      text_ << "rotate = [" << 45 * count(-4, 4) << ", " << 45 * count(-4, 4) << ", " << number() << "]\n";
    if (chance(4)) text_ << "translate = " << point() << '\n';
    switch (kind) {
    case 0:
      text_ << "shape = \"sphere\"\ncenter = " << point() << "\nradius = " << length();
      break;
    case 1:
      text_ << "shape = \"cylinder\"\nbase = " << point() << "\ntop = " << point()
            << "\nradius = " << length();
      break;
    case 2:
      text_ << "shape = \"cone\"\nbase = " << point() << "\napex = " << point() << "\nradius = " << length();
      break;
    case 3:
      text_ << "shape = \"frustum\"\nbase = " << point() << "\ntop = " << point()
            << "\nbase_radius = " << length() << "\ntop_radius = " << length();
      break;
    case 4:
      text_ << "shape = \"prism\"\nbase = " << point() << "\ntop = " << point() << "\nradius = " << length()
            << "\nsides = " << count(3, 12);
      break;
    case 5:
      text_ << "shape = \"polyhedron\"\nvertices = [" << point() << ", " << point() << ", " << point() << ", "
            << point() << "]\nfaces = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]";
      break;
    case 6:
      text_ << "shape = \"polygon\"\nvertices = [" << point() << ", " << point() << ", " << point() << ']';
      break;
    default:
      write_box();
    }
    text_ << '\n';
  }

  void write_box() {
    text_ << "shape = \"box\"\n";
    std::ostringstream max = exact_text();
    text_ << "min = [";
    for (int axis = 0; axis < 3; ++axis) {
      const double a = number() * unit_, b = number() * unit_;
      text_ << (axis > 0 ? ", " : "") << std::min(a, b);
      max << (axis > 0 ? ", " : "") << std::max(a, b);
    }
    text_ << "]\nmax = [" << max.str() << ']';
  }

  FuzzedDataProvider fuzz_;
  std::ostringstream text_ = exact_text();
  double unit_ = 1;
};

} // namespace halftone::fuzz
