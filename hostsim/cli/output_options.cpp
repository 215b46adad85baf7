#include "output_options.h"

#include "pfm.h"

#include <halftone/file/write.h>
#include <halftone/png/png.h>

namespace halftone::cli {

void add_output_options(Arguments command, OutputOptions& options, const std::string& picture_help) {
  command.add_option("-o,--output", options.picture, picture_help).type_name("OUT.png");
  command.add_option("--screen", options.screen, "The whole 512 x 512 screen as shown").type_name("OUT.png");
  command
      .add_option("--float", options.radiance,
                  "Radiance before exposure and rounding, as a portable float map")
      .type_name("OUT.pfm");
  command.add_option("--record", options.recording, "What is sent to the device, as a trace for m508")
      .type_name("T.m508");
  command.add_flag("--stats", options.statistics, "Print counts and times");
  command.add_flag("--json", options.json, "Print counts and times as one JSON object");
}

void write(const PictureFiles& files, const scene::Image& image, const Pictures& pictures) {
  const auto encoding = image.transfer == scene::Transfer::srgb ? png::Encoding::srgb : png::Encoding::linear;
  if (!files.picture.empty())
    png::write(files.picture, {image.width, image.height, pictures.picture}, encoding);
  if (!files.screen.empty()) png::write(files.screen, {512, 512, pictures.screen}, encoding);
  if (!files.radiance.empty()) {
    const std::string map = encode_pfm(image.width, image.height, pictures.radiance);
    file::write_whole(files.radiance, std::as_bytes(std::span(map)));
  }
}

} // namespace halftone::cli
