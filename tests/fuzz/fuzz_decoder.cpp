// Any stream, in any pieces, is taken apart as the naive decoder takes it apart whole; and a good item
// encoded again is the bytes that it was made of.

#include "stream.h"

#include "../protocol/naive_codec.h"

#include <halftone/protocol/decoder.h>

#include <cstdlib>
#include <string>

using namespace halftone;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  FuzzedDataProvider fuzz(bytes, size);
  const auto places = fuzz.ConsumeBytes<std::uint8_t>(32);
  FuzzedDataProvider cuts(places.data(), places.size());
  const fuzz::Bytes stream = fuzz::make_stream(fuzz);

  protocol::Decoder decoder(protocol::Direction::to_device);
  std::vector<std::string> items;
  const auto keep = [&](const protocol::Item& item) {
    items.push_back(test::describe(item));
    if (const auto* message = std::get_if<protocol::Message>(&item.content)) {
      fuzz::Bytes again;
      append(again, *message);
      if (!std::ranges::equal(again, std::span(stream).subspan(item.offset, item.size))) std::abort();
    }
  };
  fuzz::in_pieces(cuts, stream, [&](std::span<const std::uint8_t> piece) {
    while (const auto item = decoder.next(piece)) keep(*item);
  });
  while (const auto item = decoder.drain()) keep(*item);
  if (items != test::naive_decode(stream, protocol::Direction::to_device)) std::abort();
  return 0;
}
