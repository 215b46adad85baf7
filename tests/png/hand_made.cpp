#include "hand_made.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

namespace halftone::test {

namespace {

void put(Bytes& bytes, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

void join(Bytes& all, const Bytes& more) { std::ranges::copy(more, std::back_inserter(all)); }

std::size_t channels_of(ColorType type) {
  switch (type) {
  case ColorType::grey:
  case ColorType::palette:
    return 1;
  case ColorType::grey_alpha:
    return 2;
  case ColorType::rgb:
    return 3;
  case ColorType::rgb_alpha:
    break;
  }
  return 4;
}

struct Pass {
  std::uint32_t x, y, dx, dy;
};
constexpr std::array<Pass, 1> plain{{{0, 0, 1, 1}}};
constexpr std::array<Pass, 7> adam7{
    {{0, 0, 8, 8}, {4, 0, 8, 8}, {0, 4, 4, 8}, {2, 0, 4, 4}, {0, 2, 2, 4}, {1, 0, 2, 2}, {0, 1, 1, 2}}};

/// The rows of a pass, packed, each with filter 0 before it.
Bytes packed(const HandMade& picture, const Pass& pass) {
  const std::size_t channels = channels_of(picture.type);
  Bytes bytes;
  if (pass.x >= picture.width) return bytes;
  for (std::uint32_t y = pass.y; y < picture.height; y += pass.dy) {
    bytes.push_back(0);
    std::uint32_t bits = 0;
    int count = 0;
    for (std::uint32_t x = pass.x; x < picture.width; x += pass.dx) {
      for (std::size_t channel = 0; channel < channels; ++channel) {
        bits = bits << picture.depth |
               picture.samples.at((std::size_t{y} * picture.width + x) * channels + channel);
        count += picture.depth;
        for (; count >= 8; count -= 8) bytes.push_back(static_cast<std::uint8_t>(bits >> (count - 8)));
      }
    }
    if (count > 0) bytes.push_back(static_cast<std::uint8_t>(bits << (8 - count)));
  }
  return bytes;
}

Bytes compressed(const Bytes& bytes) {
  uLongf size = compressBound(bytes.size());
  Bytes result(size);
  compress(result.data(), &size, bytes.data(), bytes.size());
  result.resize(size);
  return result;
}

} // namespace

Bytes chunk(const std::string& name, const Bytes& data) {
  Bytes checked(name.begin(), name.end());
  join(checked, data);
  Bytes bytes;
  put(bytes, static_cast<std::uint32_t>(data.size()));
  join(bytes, checked);
  put(bytes, static_cast<std::uint32_t>(crc32_z(0, checked.data(), checked.size())));
  return bytes;
}

Bytes encode(const HandMade& picture) {
  Bytes header;
  put(header, picture.width);
  put(header, picture.height);
  join(header, {picture.depth, static_cast<std::uint8_t>(picture.type), 0, 0, picture.interlaced});
  Bytes rows;
  if (!picture.samples.empty()) {
    if (picture.interlaced) {
      for (const Pass& pass : adam7) join(rows, packed(picture, pass));
    } else {
      join(rows, packed(picture, plain[0]));
    }
  }
  Bytes file{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
  join(file, chunk("IHDR", header));
  if (!picture.gamma.empty()) join(file, chunk("gAMA", picture.gamma));
  if (!picture.palette.empty()) join(file, chunk("PLTE", picture.palette));
  if (!picture.transparency.empty()) join(file, chunk("tRNS", picture.transparency));
  join(file, chunk("IDAT", compressed(rows)));
  join(file, chunk("IEND", {}));
  return file;
}

void save(const std::filesystem::path& file, const Bytes& bytes) {
  std::ofstream stream(file, std::ios::binary);
  std::copy(bytes.begin(), bytes.end(), std::ostreambuf_iterator<char>(stream));
}

Bytes load(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace halftone::test
