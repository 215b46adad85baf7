#include "conversation.h"
#include "rows.h"

#include <halftone/driver/driver.h>

#include <halftone/protocol/checksum.h>
#include <halftone/protocol/fault.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <string>
#include <string_view>

namespace halftone::driver {

namespace {

using protocol::channels;
using protocol::index_of;
using protocol::Message;
using protocol::Opcode;

constexpr int screen_width = protocol::screen_width;
constexpr int screen_height = protocol::screen_height;

// How often rows that differ are sent again, and the reset is. On a link that loses every second row, one row
// in 65,536 is given up.
constexpr int repair_limit = 16;

// How often the picture is read when what comes back is not what was sent: a device that restarts more often
// than this while it is read is no use.
constexpr int read_limit = 4;

// Rows asked for at once: enough that waiting for answers does not count, few enough that a repeated
// question is cheap.
constexpr int rows_of_a_question = 32;

std::array<std::uint32_t, protocol::operand_limit> operands(const Placement& area) {
  const auto operand = [](int value) { return static_cast<std::uint32_t>(value); };
  return {operand(area.left), operand(area.top), operand(area.width), operand(area.height)};
}

Message window(const Placement& area) { return {Opcode::window, 0, operands(area), {}}; }

Message pixels(std::span<const std::uint8_t> rgb) { return {Opcode::pixels, 0, {}, rgb}; }

std::size_t offset_of(int x, int y) {
  return (static_cast<std::size_t>(y) * screen_width + static_cast<std::size_t>(x)) * channels;
}

std::span<const std::uint8_t> screen_row(const std::vector<std::uint8_t>& screen, int y) {
  return std::span(screen).subspan(offset_of(0, y), screen_width * channels);
}

/// Rows of the picture that the device was not seen to hold.
std::string may_be_missing(const std::vector<bool>& verified, const Placement& picture) {
  const std::vector<int> rows = rows_without(verified, picture.top, picture.height);
  return rows.empty() ? "no row of the picture is missing" : name(rows) + " of the picture may be missing";
}

class Stopwatch {
public:
  explicit Stopwatch(double& seconds) : seconds_(seconds) {}
  ~Stopwatch() { seconds_ += std::chrono::duration<double>(Clock::now() - start_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

private:
  using Clock = std::chrono::steady_clock;
  double& seconds_;
  Clock::time_point start_ = Clock::now();
};

void require_this_device(const Message& identity) {
  struct Requirement {
    std::string_view what;
    std::size_t operand;
    std::uint32_t wanted;
  };
  constexpr std::array requirements{
      Requirement{"command set", index_of(Opcode::identity, "profile"), protocol::reconstructed_profile},
      Requirement{"protocol version", index_of(Opcode::identity, "version"), protocol::protocol_version},
      Requirement{"screen width", index_of(Opcode::identity, "width"), protocol::screen_width},
      Requirement{"screen height", index_of(Opcode::identity, "height"), protocol::screen_height},
  };
  for (const Requirement& requirement : requirements) {
    const std::uint32_t found = identity.operands[requirement.operand];
    if (found == requirement.wanted) continue;
    throw link::DeviceError("the device has " + std::string(requirement.what) + " " + std::to_string(found) +
                            " where this program needs " + std::to_string(requirement.wanted));
  }
}

/// Damage on the way is no failure: checksums find what it did. Any other error in the device's status means
/// that it refused a command that arrived as it was sent.
void require_no_refusal(const Message& state) {
  const std::uint32_t error = state.operands[index_of(Opcode::state, "error")];
  if (error == static_cast<std::uint32_t>(protocol::Fault::none) ||
      error == static_cast<std::uint32_t>(protocol::Fault::damaged)) {
    return;
  }
  std::string text = "the device refused command ";
  text += std::to_string(state.operands[index_of(Opcode::state, "error_sequence")]);
  text += ": ";
  text += error < protocol::fault_table.size() ? protocol::fault_table[error].name : "unknown error";
  throw link::DeviceError(text);
}

/// Makes the rows of the device's screen from first to before last those of `screen` where they differ, found
/// by halves. Marks the rows that do not differ as verified, and returns those that it sent again.
std::vector<int> repair(Conversation& conversation, const std::vector<std::uint8_t>& screen, int first,
                        int last, std::vector<bool>& verified) {
  const Placement rows{0, first, screen_width, last - first};
  const std::uint32_t wanted = protocol::checksum(
      std::span(screen).subspan(offset_of(0, first), offset_of(0, last) - offset_of(0, first)));
  const Message sum = conversation.ask({Opcode::checksum, 0, operands(rows), {}});
  if (sum.operands[index_of(Opcode::sum, "checksum")] == wanted) {
    std::fill(verified.begin() + first, verified.begin() + last, true);
    return {};
  }
  if (last - first == 1) {
    conversation.tell(std::array{window(rows), pixels(screen_row(screen, first))});
    return {first};
  }
  const int middle = (first + last) / 2;
  std::vector<int> sent = repair(conversation, screen, first, middle, verified);
  const std::vector<int> below = repair(conversation, screen, middle, last, verified);
  sent.insert(sent.end(), below.begin(), below.end());
  return sent;
}

/// Runs a task; when the link fails in it, the failure also tells what is missing.
template<typename Task, typename Missing>
auto naming(const Missing& missing, const Task& task) {
  try {
    return task();
  } catch (const link::DeviceError& error) {
    throw link::DeviceError(std::string(error.what()) + "; " + missing());
  } catch (const link::Timeout& error) {
    throw link::Timeout(std::string(error.what()) + "; " + missing());
  }
}

/// The pixels of `area` as the device holds or shows them.
std::vector<std::uint8_t> read_back(Conversation& conversation, Opcode query, const Placement& area) {
  const std::size_t row_size = static_cast<std::size_t>(area.width) * channels;
  std::vector<std::uint8_t> rgb(row_size * static_cast<std::size_t>(area.height));
  std::vector<bool> here(static_cast<std::size_t>(area.height));
  const auto missing = [&] { return name(rows_without(here, 0, area.height)) + " were not read back"; };
  return naming(missing, [&] {
    for (int first = 0; first < area.height; first += rows_of_a_question) {
      const int count = std::min(rows_of_a_question, area.height - first);
      const Placement band{area.left, area.top + first, area.width, count};
      int left = count;
      conversation.ask({query, 0, operands(band), {}}, [&](const Message& reply) {
        const int row = static_cast<int>(reply.operands[index_of(Opcode::row, "y")]) - band.top;
        const bool in_band = row >= 0 && row < count && reply.data.size() == row_size;
        if (!in_band || here[static_cast<std::size_t>(first + row)]) return Progress::none;
        here[static_cast<std::size_t>(first + row)] = true;
        std::ranges::copy(reply.data, rgb.begin() + static_cast<std::ptrdiff_t>(row_size) * (first + row));
        return --left == 0 ? Progress::complete : Progress::some;
      });
    }
    return rgb;
  });
}

} // namespace

Placement centred(int width, int height) {
  return {(screen_width - width) / 2, (screen_height - height) / 2, width, height};
}

Driver::Driver(link::Link& link, std::chrono::milliseconds timeout)
    : conversation_(std::make_unique<Conversation>(link, timeout)),
      has_way_back_(link.has_way_back()),
      screen_(offset_of(0, screen_height)),
      verified_(screen_height) {}

Driver::~Driver() = default;

void Driver::begin(int width, int height) {
  assert(width >= 1 && width <= screen_width && height >= 1 && height <= screen_height);
  const Stopwatch stopwatch(seconds_);
  conversation_->begin_step();
  picture_ = centred(width, height);
  next_row_ = 0;
  std::ranges::fill(screen_, std::uint8_t{0});
  verified_.assign(screen_height, false);
  const auto nothing_sent = [] { return "no row of the picture was sent"; };
  const std::array reset{Message{Opcode::reset, 0, {}, {}}, window(picture_)};
  if (!has_way_back_) return naming(nothing_sent, [&] { conversation_->tell(reset); });

  require_this_device(naming(nothing_sent, [&] {
    return conversation_->ask({Opcode::identify, 0, {}, {}});
  }));
  for (int attempt = 0; attempt < repair_limit; ++attempt) {
    const Message state = naming(nothing_sent, [&] {
      return conversation_->ask_after(reset, {Opcode::status, 0, {}, {}});
    });
    // The window is the one command that a device counts which has just been reset.
    if (state.operands[index_of(Opcode::state, "commands")] == 1) return;
  }
  throw link::DeviceError("the device did not take a reset, sent " + std::to_string(repair_limit) + " times");
}

void Driver::send_row(int y, std::span<const std::uint8_t> rgb) {
  assert(y >= 0 && y < picture_.height);
  assert(rgb.size() == static_cast<std::size_t>(picture_.width) * channels);
  const Stopwatch stopwatch(seconds_);
  const int top = picture_.top + y;
  std::ranges::copy(rgb, screen_.begin() + static_cast<std::ptrdiff_t>(offset_of(picture_.left, top)));
  verified_[static_cast<std::size_t>(top)] = false;
  naming([&] { return may_be_missing(verified_, picture_); },
         [&] {
           if (y == next_row_) return conversation_->tell(std::array{pixels(rgb)});
           const Placement from_here{picture_.left, top, picture_.width, picture_.height - y};
           conversation_->tell(std::array{window(from_here), pixels(rgb)});
         });
  next_row_ = y + 1;
}

bool Driver::holds(int y, std::span<const std::uint8_t> rgb) const {
  const auto row = std::span(screen_).subspan(offset_of(picture_.left, picture_.top + y), rgb.size());
  return std::ranges::equal(rgb, row);
}

void Driver::finish() {
  const Stopwatch stopwatch(seconds_);
  conversation_->begin_step();
  if (!has_way_back_) return; // nothing is held back here, and there is nobody to ask
  require_no_refusal(naming([&] { return may_be_missing(verified_, picture_); },
                            [&] {
                              return conversation_->ask({Opcode::status, 0, {}, {}});
                            }));
  verify();
}

void Driver::verify() {
  next_row_ = picture_.height; // repairs move the window: the next row has to set it
  std::vector<int> differing;
  for (int round = 0; round <= repair_limit; ++round) {
    verified_.assign(screen_height, false); // a repair that lost its window may have hit any row
    differing = naming([&] { return may_be_missing(verified_, picture_); },
                       [&] { return repair(*conversation_, screen_, 0, screen_height, verified_); });
    if (differing.empty()) return;
  }
  throw link::DeviceError("the device does not hold what was sent to it: " + name(differing) +
                          " of the screen differ after " + std::to_string(repair_limit) + " repeats");
}

std::vector<std::uint8_t> Driver::read_picture() {
  const Stopwatch stopwatch(seconds_);
  conversation_->begin_step();
  return read(Opcode::read, picture_);
}

std::vector<std::uint8_t> Driver::read_screen() {
  const Stopwatch stopwatch(seconds_);
  conversation_->begin_step();
  return read(Opcode::read_screen, {0, 0, screen_width, screen_height});
}

std::vector<std::uint8_t> Driver::read_shown() {
  const Stopwatch stopwatch(seconds_);
  assert(has_way_back_);
  conversation_->begin_step();
  return read_back(*conversation_, Opcode::read_screen, {0, 0, screen_width, screen_height});
}

/// What comes back is compared with what was sent, for the device may have lost it since it was verified. The
/// screen shows the image as it is, since begin resets all that could change it on the way.
std::vector<std::uint8_t> Driver::read(Opcode query, const Placement& area) {
  assert(has_way_back_);
  std::vector<int> differing;
  for (int round = 0; round < read_limit; ++round) {
    std::vector<std::uint8_t> rgb = read_back(*conversation_, query, area);
    differing = differing_rows(rgb, area);
    if (differing.empty()) return rgb;
    verify();
  }
  throw link::DeviceError("the device does not give back what was sent to it: " + name(differing) +
                          " of the screen differ, read " + std::to_string(read_limit) + " times");
}

/// Rows of the screen in which `rgb`, read from `area`, is not what the device should hold.
std::vector<int> Driver::differing_rows(std::span<const std::uint8_t> rgb, const Placement& area) const {
  const std::size_t row_size = static_cast<std::size_t>(area.width) * channels;
  std::vector<int> rows;
  for (int y = area.top; y < area.top + area.height; ++y, rgb = rgb.subspan(row_size)) {
    if (!std::ranges::equal(rgb.first(row_size),
                            std::span(screen_).subspan(offset_of(area.left, y), row_size)))
      rows.push_back(y);
  }
  return rows;
}

double Driver::seconds() const { return seconds_; }

} // namespace halftone::driver
