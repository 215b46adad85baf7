#include "libpng.h"

#include <halftone/png/png.h>

#include <cerrno>
#include <cstddef>
#include <random>
#include <string>
#include <system_error>

namespace halftone::png {

namespace {

constexpr std::size_t channels = 3;

WriteError failure(const std::filesystem::path& file, const std::string& reason) {
  return WriteError(file.string() + ": " + reason);
}

std::string reason_of(int error_number) { return std::generic_category().message(error_number); }

struct Writer {
  ErrorText error;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &error, on_error, on_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;

  Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { png_destroy_write_struct(&png, &info); }
};

/// A new file beside `file`, removed unless it takes that file's place.
class Temporary {
public:
  explicit Temporary(const std::filesystem::path& file) {
    // The name may be taken by another program that writes the same picture: try another one.
    std::random_device random;
    do {
      path_ = file;
      path_ += "." + std::to_string(random()) + ".tmp";
      stream_.reset(std::fopen(path_.c_str(), "wbx"));
    } while (!stream_ && errno == EEXIST);
    if (!stream_) throw failure(file, "cannot be written: " + reason_of(errno));
  }

  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  ~Temporary() {
    if (path_.empty()) return;
    stream_.reset();
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }

  std::FILE* stream() const { return stream_.get(); }

  void replace(const std::filesystem::path& file) {
    // The last bytes are written when the stream is closed, so that it may fail.
    if (std::fclose(stream_.release()) != 0) throw failure(file, reason_of(errno));
    std::error_code error;
    std::filesystem::rename(path_, file, error);
    if (error) throw failure(file, "cannot be replaced: " + error.message());
    path_.clear();
  }

private:
  std::filesystem::path path_;
  File stream_;
};

void encode(std::FILE* stream, const Picture& picture, Encoding encoding, const std::filesystem::path& file) {
  Writer writer;
  if (writer.info == nullptr) throw failure(file, "libpng could not start");
  const auto width = static_cast<png_uint_32>(picture.width);
  const auto height = static_cast<png_uint_32>(picture.height);
  const bool done = succeeds(writer.png, [&] {
    png_init_io(writer.png, stream);
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
}

/// A device or a pipe would be replaced by a file.
void refuse_what_is_no_file(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  if (std::filesystem::is_directory(status)) throw failure(file, "is a folder");
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    throw failure(file, "is not a regular file, so that a picture cannot take its place");
  }
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
  refuse_what_is_no_file(file);
  Temporary temporary(file);
  encode(temporary.stream(), picture, encoding, file);
  temporary.replace(file);
}

} // namespace halftone::png
