// Drawn by SDL's own renderer in memory and not by a graphics card: a picture of 512 x 512 whose pixels
// become whole squares asks for nothing more, its pixels are the same on every machine, and no driver's
// threads and buffers come between a row and the eye.

#include "window.h"

#include "failure.h"

#include <halftone/display/module.h>

#include <SDL.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace halftone::display {

namespace {

// Units of the mouse that it may move between press and release of a click.
constexpr int click_slack = 3;

/// The largest whole multiple of the screen that the monitor has room for beside title and panels.
int first_size() {
  SDL_Rect usable{0, 0, screen_width, screen_height};
  SDL_GetDisplayUsableBounds(0, &usable);
  constexpr int frame = 40;
  return std::max(1, std::min(usable.w, usable.h - frame) / screen_width) * screen_width;
}

} // namespace

Window::Window()
    : window_(SDL_CreateWindow("m508", SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, first_size(),
                               first_size(), SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI)),
      renderer_((require(window_ != nullptr), SDL_CreateRenderer(window_.get(), -1, SDL_RENDERER_SOFTWARE))),
      picture_((require(renderer_ != nullptr),
                SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_RGB888, SDL_TEXTUREACCESS_STREAMING,
                                  screen_width, screen_height))),
      lettering_((require(picture_ != nullptr), renderer_.get())) {
  SDL_SetWindowMinimumSize(window_.get(), screen_width, screen_height);
  video_.outlive_server_of(window_.get());
}

Window::~Window() {
  if (!video_.has_lost_server()) return;
  renderer_.release();
  window_.release();
}

void Window::require_server() const {
  if (video_.has_lost_server()) throw DisplayError("display window: the X server has gone");
}

void Window::show(const Frame& frame) {
  const SDL_Rect rows{0, frame.changed.first, screen_width, frame.changed.count};
  const std::uint8_t* rgb = &frame.rgb[static_cast<std::size_t>(frame.changed.first) * screen_width * 3];
  // As the monitor has them: pixels of 3 bytes would be converted whenever they are drawn, all of them.
  std::vector<std::uint32_t> pixels(static_cast<std::size_t>(frame.changed.count) * screen_width);
  for (std::uint32_t& pixel : pixels) {
    pixel = std::uint32_t{rgb[0]} << 16 | std::uint32_t{rgb[1]} << 8 | rgb[2];
    rgb += 3;
  }
  require(SDL_UpdateTexture(picture_.get(), &rows, pixels.data(), screen_width * 4) == 0);
  draw();
  require_server();
}

void Window::say(const Words& words) {
  if (words.title != words_.title) SDL_SetWindowTitle(window_.get(), words.title.c_str());
  const bool is_seen =
      words.status != words_.status || words.place != words_.place || words.probed != words_.probed;
  words_ = words;
  if (is_seen) is_stale_ = true;
  require_server();
}

std::vector<Event> Window::poll() {
  std::vector<Event> events;
  for (SDL_Event event; SDL_PollEvent(&event) != 0;) take(event, events);
  require_server();
  if (is_stale_) draw();
  require_server();
  return events;
}

void Window::take(const SDL_Event& event, std::vector<Event>& events) {
  switch (event.type) {
  case SDL_QUIT:
    events.emplace_back(Quit{});
    break;
  case SDL_WINDOWEVENT:
    is_stale_ = true;
    break;
  case SDL_KEYDOWN:
    take_key(event.key.keysym, events);
    break;
  case SDL_MOUSEBUTTONDOWN:
    if (event.button.button == SDL_BUTTON_LEFT) pressed_ = Point{event.button.x, event.button.y};
    if (event.button.button == SDL_BUTTON_RIGHT) events.push_back(scrub_to(event.button.x));
    break;
  case SDL_MOUSEMOTION:
    take_motion(event.motion, events);
    break;
  case SDL_MOUSEBUTTONUP:
    take_release(event.button, events);
    break;
  case SDL_MOUSEWHEEL:
    take_wheel(event.wheel, events);
    break;
  default:
    break;
  }
}

void Window::take_key(const SDL_Keysym& key, std::vector<Event>& events) {
  const auto action = action_of(key);
  if (!action) return;
  if (const auto* event = std::get_if<Event>(&*action))
    events.push_back(*event);
  else
    act(std::get<Own>(*action), events);
}

void Window::act(Own own, std::vector<Event>& events) {
  is_stale_ = true;
  switch (own) {
  case Own::help:
    shows_help_ = !shows_help_;
    break;
  case Own::status:
    shows_status_ = !shows_status_;
    break;
  case Own::full_screen: {
    const bool is_full = (SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0;
    SDL_SetWindowFullscreen(window_.get(), is_full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP);
    break;
  }
  case Own::close_words:
    shows_help_ = false;
    events.emplace_back(EndProbe{});
    break;
  }
}

void Window::take_motion(const SDL_MouseMotionEvent& motion, std::vector<Event>& events) {
  if ((motion.state & SDL_BUTTON_RMASK) != 0) events.push_back(scrub_to(motion.x));
  if (!pressed_) return;
  const int moved = std::max(std::abs(motion.x - pressed_->x), std::abs(motion.y - pressed_->y));
  if (!is_dragging_ && moved <= click_slack) return;
  if (!is_dragging_) {
    is_dragging_ = true;
    const Point from = on_screen(pressed_->x, pressed_->y);
    events.emplace_back(Drag{true, from.x, from.y});
  }
  const Point to = on_screen(motion.x, motion.y);
  events.emplace_back(Drag{false, to.x, to.y});
}

void Window::take_release(const SDL_MouseButtonEvent& button, std::vector<Event>& events) {
  if (button.button != SDL_BUTTON_LEFT || !pressed_) return;
  const Point at = on_screen(button.x, button.y);
  const bool is_inside = at.x >= 0 && at.x < screen_width && at.y >= 0 && at.y < screen_height;
  if (!is_dragging_ && is_inside) {
    events.emplace_back(Probe{at.x, at.y});
    asked_ = at;
  }
  pressed_.reset();
  is_dragging_ = false;
}

void Window::take_wheel(const SDL_MouseWheelEvent& wheel, std::vector<Event>& events) {
  if (wheel.y == 0) return;
  const Point at = on_screen(wheel.mouseX, wheel.mouseY);
  events.emplace_back(Zoom{wheel.y > 0 ? 1 : -1, std::clamp(at.x, 0, screen_width - 1),
                           std::clamp(at.y, 0, screen_height - 1)});
}

Event Window::scrub_to(int x) const {
  const Place here = place();
  const double along = (x * here.density - here.picture.x) / here.picture.w;
  return Scrub{Scrub::By::place, std::clamp(along, 0.0, 1.0)};
}

Window::Place Window::place() const {
  int width = screen_width, height = screen_height, units = screen_width;
  SDL_GetRendererOutputSize(renderer_.get(), &width, &height);
  SDL_GetWindowSize(window_.get(), &units, nullptr);
  const int scale = std::max(1, std::min(width / screen_width, height / screen_height));
  const int size = scale * screen_width;
  return {{(width - size) / 2, (height - size) / 2, size, size}, scale, static_cast<double>(width) / units};
}

/// A place of the device's screen, from one in the window; beyond the screen where it is outside the picture.
Window::Point Window::on_screen(int x, int y) const {
  const Place here = place();
  const auto along = [&](int unit, int start) {
    return static_cast<int>(std::floor((unit * here.density - start) / here.scale));
  };
  return {along(x, here.picture.x), along(y, here.picture.y)};
}

void Window::draw() {
  const Place here = place();
  SDL_SetRenderDrawBlendMode(renderer_.get(), SDL_BLENDMODE_NONE);
  SDL_SetRenderDrawColor(renderer_.get(), 24, 24, 24, 255);
  require(SDL_RenderClear(renderer_.get()) == 0);
  require(SDL_RenderCopy(renderer_.get(), picture_.get(), nullptr, &here.picture) == 0);
  draw_words(here);
  SDL_RenderPresent(renderer_.get());
  is_stale_ = false;
}

void Window::draw_words(const Place& here) {
  const int dot = 2 * std::max(1, static_cast<int>(std::lround(here.density)));
  const SDL_Rect& picture = here.picture;
  const std::size_t fitting = Lettering::fitting(picture.w, dot);
  if (shows_help_) {
    std::vector<std::string> lines;
    for (const Line& line : help_lines()) {
      std::string keys(line.keys);
      keys.resize(11, ' ');
      const std::vector<std::string> meaning = wrapped({std::string(line.meaning)}, fitting - keys.size());
      for (const std::string& part : meaning) {
        lines.push_back(keys + part);
        keys.assign(keys.size(), ' ');
      }
    }
    lettering_.draw(lines, picture.x, picture.y, dot);
  } else if (!words_.probed.empty()) {
    draw_asked(here);
    lettering_.draw(wrapped(words_.probed, fitting), picture.x, picture.y, dot);
  }
  if (!shows_status_ || words_.status.empty()) return;
  const std::vector<std::string> status = wrapped({words_.status}, fitting);
  lettering_.draw(status, picture.x,
                  picture.y + picture.h - 2 * dot - Lettering::height_of(status.size(), dot), dot);
  draw_bar(picture, dot);
}

/// A frame around the pixel that the words are about, light on dark so that it is seen on both.
void Window::draw_asked(const Place& here) {
  SDL_Rect frame{here.picture.x + asked_.x * here.scale - 1, here.picture.y + asked_.y * here.scale - 1,
                 here.scale + 2, here.scale + 2};
  for (const std::uint8_t shade : std::array<std::uint8_t, 3>{255, 0, 255}) {
    SDL_SetRenderDrawColor(renderer_.get(), shade, shade, shade, 255);
    SDL_RenderDrawRect(renderer_.get(), &frame);
    frame = {frame.x - 1, frame.y - 1, frame.w + 2, frame.h + 2};
  }
}

/// Where in the stream the picture is.
void Window::draw_bar(const SDL_Rect& picture, int dot) {
  const SDL_Rect ground{picture.x, picture.y + picture.h - 2 * dot, picture.w, 2 * dot};
  SDL_SetRenderDrawColor(renderer_.get(), 0, 0, 0, 210);
  SDL_RenderFillRect(renderer_.get(), &ground);
  const SDL_Rect done{ground.x, ground.y, static_cast<int>(std::lround(ground.w * words_.place)), ground.h};
  SDL_SetRenderDrawColor(renderer_.get(), 255, 176, 0, 255);
  SDL_RenderFillRect(renderer_.get(), &done);
}

} // namespace halftone::display

halftone::display::Display* halftone_open_display_2(const char*) { return new halftone::display::Window(); }
