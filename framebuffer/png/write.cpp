#include "libpng.h"

#include <halftone/file/write.h>
#include <halftone/png/png.h>

#include <cstddef>
#include <new>
#include <span>
#include <string>
#include <vector>

namespace halftone::png {

namespace {

constexpr std::size_t channels = 3;

file::WriteError failure(const std::filesystem::path& file, const std::string& reason) {
  return file::WriteError(file.string() + ": " + reason);
}

struct Writer {
  ErrorText error;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, on_error, on_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;

  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

/// What libpng writes to. It is C, which no exception may pass through, and png_error leaves by longjmp.
void append(png_structp png, png_bytep bytes, png_size_t size) {
  bool is_there = true;
  try {
    auto* const whole = static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
    whole->insert(whole->end(), bytes, bytes + size);
  } catch (const std::bad_alloc&) {
    is_there = false;
  }
  if (!is_there) png_error(png, "there is not enough memory");
}

void flush(png_structp) {}

std::vector<std::uint8_t> encode(const Picture& picture, Encoding encoding,
                                 const std::filesystem::path& file) {
  std::vector<std::uint8_t> whole;
  Writer writer;
  if (writer.info == nullptr) throw failure(file, "libpng could not start");
  const auto width = static_cast<png_uint_32>(picture.width);
  const auto height = static_cast<png_uint_32>(picture.height);
  const bool done = succeeds(writer.png, [&] {
    png_set_write_fn(writer.png, &whole, append, flush);
    png_set_IHDR(writer.png, writer.info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (encoding == Encoding::srgb) {
      png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    } else {
      png_set_gAMA_fixed(writer.png, writer.info, PNG_FP_1);
    }
    png_write_info(writer.png, writer.info);
    for (std::size_t y = 0; y < height; ++y) png_write_row(writer.png, &picture.rgb[y * width * channels]);
    png_write_end(writer.png, nullptr);
  });
  if (!done) throw failure(file, writer.error.text);
  return whole;
}

bool is_writable(const Picture& picture) {
  const auto fits = [](int side) { return side >= 1 && side <= longest_side; };
  return fits(picture.width) && fits(picture.height) &&
         picture.rgb.size() == static_cast<std::size_t>(picture.width) * picture.height * channels;
}

} // namespace

void write(const std::filesystem::path& file, const Picture& picture, Encoding encoding) {
  if (!is_writable(picture))
    throw failure(file, "a picture must have sides from 1 to " + std::to_string(longest_side) +
                            " and all its pixels");
  const std::vector<std::uint8_t> bytes = encode(picture, encoding, file);
  file::write_whole(file, std::as_bytes(std::span(bytes)));
}

} // namespace halftone::png
