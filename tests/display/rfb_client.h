#pragma once
// The other side of a VNC server: so much of RFB (RFC 6143) as it takes to see which pixels arrive.

#include <halftone/display/display.h>
#include <halftone/file/descriptor.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::test {

class RfbClient {
public:
  struct Rectangle {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool operator==(const Rectangle&) const = default;
  };

  /// Connects to "HOST:PORT". What it waits for comes of `serve`, which is called again and again; a test
  /// fails where it does not come.
  RfbClient(const std::string& address, std::function<void()> serve);

  /// To the point where pictures can be asked for.
  void shake_hands();

  const std::string& title() const { return title_; }

  /// Asks for the whole screen: all of it, or what has changed since the last time.
  void ask(bool is_incremental);

  /// The rectangles that come next; what is in them is in the picture.
  std::vector<Rectangle> take_update();

  /// Rows of 512 pixels of 3 bytes, as Frame has them.
  const std::vector<std::uint8_t>& rgb() const { return rgb_; }

  void send(std::string_view bytes) const;

  /// Whether anything comes, be it the end, in this many milliseconds.
  bool hears_something(int milliseconds) const;
  /// Whether the server has closed the connection.
  bool is_closed();

private:
  std::vector<std::uint8_t> take(std::size_t count);
  std::uint32_t number(std::size_t bytes);

  file::Descriptor socket_;
  std::function<void()> serve_;
  std::string title_;
  std::vector<std::uint8_t> rgb_;
};

} // namespace halftone::test
