#pragma once
// The device's screen in a window, by SDL2.

#include "keys.h"
#include "lettering.h"
#include "video.h"

#include <halftone/display/display.h>

#include <SDL_events.h>
#include <SDL_render.h>
#include <SDL_video.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace halftone::display {

class Window final : public Display {
public:
  Window();
  ~Window() override;
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  bool is_operated() const override { return true; }
  void show(const Frame& frame) override;
  void say(const Words& words) override;
  std::vector<Event> poll() override;

private:
  struct WindowEnd {
    void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
  };
  struct RendererEnd {
    void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
  };

  /// Where the picture is: in pixels of the renderer's output, and how many of them are a unit of the
  /// mouse's.
  struct Place {
    SDL_Rect picture;
    int scale = 1;
    double density = 1;
  };
  struct Point {
    int x = 0;
    int y = 0;
  };

  /// Throws DisplayError where the X server has gone.
  void require_server() const;
  Place place() const;
  Point on_screen(int x, int y) const;
  void take(const SDL_Event& event, std::vector<Event>& events);
  void take_key(const SDL_Keysym& key, std::vector<Event>& events);
  void take_motion(const SDL_MouseMotionEvent& motion, std::vector<Event>& events);
  void take_release(const SDL_MouseButtonEvent& button, std::vector<Event>& events);
  void take_wheel(const SDL_MouseWheelEvent& wheel, std::vector<Event>& events);
  Event scrub_to(int x) const;
  void act(Own own, std::vector<Event>& events);
  void draw();
  void draw_words(const Place& place);
  void draw_asked(const Place& here);
  void draw_bar(const SDL_Rect& picture, int dot);

  Video video_;
  std::unique_ptr<SDL_Window, WindowEnd> window_;
  std::unique_ptr<SDL_Renderer, RendererEnd> renderer_;
  Texture picture_;
  Lettering lettering_;
  Words words_;
  bool shows_help_ = false;
  bool shows_status_ = true;
  bool is_stale_ = true;         ///< what is on the monitor
  std::optional<Point> pressed_; ///< where the left button went down and is held
  bool is_dragging_ = false;
  Point asked_; ///< where the last click was
};

} // namespace halftone::display
