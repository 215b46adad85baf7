// Measures latency.sh: from a command that is sent to a device until the window has its pixel, and from a key
// until the window has what it does. Looks at one pixel of the window, again and again, as fast as the X
// server answers.

#include "support/messages.h"

#include <halftone/link/link.h>

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>
#include <X11/keysym.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

using namespace halftone;
using Clock = std::chrono::steady_clock;

namespace {

unsigned long pixel_at(Display* x, Window window, int column, int row) {
  XImage* const image = XGetImage(x, window, column, row, 1, 1, AllPlanes, ZPixmap);
  const unsigned long pixel = XGetPixel(image, 0, 0) & 0xFFFFFF;
  XDestroyImage(image);
  return pixel;
}

/// Milliseconds until the pixel is another one than it was, after `act`.
template<typename Act>
double milliseconds_to_change(Display* x, Window window, const Act& act) {
  const unsigned long before = pixel_at(x, window, 512, 512);
  const auto start = Clock::now();
  act();
  while (pixel_at(x, window, 512, 512) == before)
    if (Clock::now() - start > std::chrono::seconds(5)) std::exit(1);
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void print(const char* what, std::vector<double> times) {
  std::ranges::sort(times);
  std::printf("%s: median %.1f ms, worst of %zu %.1f ms\n", what, times[times.size() / 2], times.size(),
              times.back());
}

} // namespace

int main(int, char** arguments) {
  const auto link = link::open(std::string(arguments[1]));
  const Window window = std::strtoul(arguments[2], nullptr, 10);
  Display* const x = XOpenDisplay(nullptr);
  std::vector<double> rows, keys;
  for (std::uint32_t i = 1; i <= 40; ++i) {
    std::this_thread::sleep_for(
        std::chrono::milliseconds(50 + i % 7 * 3)); // at any moment of the window's own time
    const auto row = test::bytes_of({{protocol::Opcode::fill, i, {0, 256, 512, 1, i * 5, 40, 90}, {}}});
    rows.push_back(milliseconds_to_change(x, window, [&] { link->send(row); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(50 + i % 7 * 3));
    const KeyCode key = XKeysymToKeycode(x, i % 2 == 1 ? XK_2 : XK_1); // negative, linear
    keys.push_back(milliseconds_to_change(x, window, [&] {
      XTestFakeKeyEvent(x, key, True, CurrentTime);
      XTestFakeKeyEvent(x, key, False, CurrentTime);
      XFlush(x);
    }));
  }
  print("row to window", rows);
  print("key to window", keys);
  return 0;
}
