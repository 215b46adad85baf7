#include "render_report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace halftone::cli {

namespace {

std::uint64_t bytes_an_object(const render::Statistics& statistics) {
  return statistics.prepared_bytes / std::max<std::uint64_t>(1, statistics.objects);
}

} // namespace

std::string for_people(const RenderReport& report) {
  const render::Statistics& statistics = report.statistics;
  std::ostringstream text;
  text << report.width << " x " << report.height << " pixels, mode " << render::name(statistics.mode);
  if (statistics.samples_per_side > 0)
    text << " with " << statistics.samples_per_side << " x " << statistics.samples_per_side
         << " samples a pixel";
  if (statistics.lines > 0)
    text << " with " << statistics.lines
         << (statistics.lines == 1 ? " virtual scanline" : " virtual scanlines") << " a row";
  text << ", " << statistics.threads << (statistics.threads == 1 ? " thread, " : " threads, ")
       << core::name(statistics.simd) << '\n';

  text << std::fixed << std::setprecision(3);
  text << "seconds        prepare " << statistics.prepare_seconds << ", render " << statistics.render_seconds
       << ", device " << report.device_seconds << '\n';
  text << "rays           eye " << statistics.rays.eye << ", reflected " << statistics.rays.reflected
       << ", refracted " << statistics.rays.refracted << ", shadow " << statistics.rays.shadow << '\n';
  text << "virtual lines  " << statistics.virtual_lines << '\n';
  text << "intervals      " << statistics.intervals << '\n';
  text << "samples        " << statistics.samples << '\n';
  text << "traced pixels  " << statistics.traced_pixels << '\n';
  text << "comparisons    " << statistics.comparisons << '\n';
  text << "memory         " << statistics.prepared_bytes << " bytes prepared, " << bytes_an_object(statistics)
       << " an object\n";
  text << "skipped        lights " << statistics.skipped.lights << ", objects " << statistics.skipped.objects
       << ", hidden faces " << statistics.skipped.faces << ", casters " << statistics.skipped.casters
       << ", branches " << statistics.skipped.branches << ", pixels with one sample "
       << statistics.skipped.samples << '\n';
  return text.str();
}

std::string as_json(const RenderReport& report) {
  const render::Statistics& statistics = report.statistics;
  const nlohmann::ordered_json object = {
      {"width", report.width},
      {"height", report.height},
      {"mode", render::name(statistics.mode)},
      {"threads", statistics.threads},
      {"simd", core::name(statistics.simd)},
      {"samples_per_side", statistics.samples_per_side},
      {"lines", statistics.lines},
      {"prepare_seconds", statistics.prepare_seconds},
      {"render_seconds", statistics.render_seconds},
      {"device_seconds", report.device_seconds},
      {"rays",
       {{"eye", statistics.rays.eye},
        {"reflected", statistics.rays.reflected},
        {"refracted", statistics.rays.refracted},
        {"shadow", statistics.rays.shadow}}},
      {"virtual_lines", statistics.virtual_lines},
      {"intervals", statistics.intervals},
      {"samples", statistics.samples},
      {"traced_pixels", statistics.traced_pixels},
      {"comparisons", statistics.comparisons},
      {"memory",
       {{"prepared_bytes", statistics.prepared_bytes}, {"bytes_an_object", bytes_an_object(statistics)}}},
      {"skipped",
       {{"lights", statistics.skipped.lights},
        {"objects", statistics.skipped.objects},
        {"faces", statistics.skipped.faces},
        {"casters", statistics.skipped.casters},
        {"branches", statistics.skipped.branches},
        {"samples", statistics.skipped.samples}}},
  };
  return object.dump(2) + "\n";
}

} // namespace halftone::cli
