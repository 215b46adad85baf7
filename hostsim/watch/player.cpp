#include <halftone/watch/player.h>

#include <halftone/protocol/decoder.h>

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>
#include <variant>

namespace halftone::watch {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t most_snapshots = 48;
constexpr std::uint64_t first_spacing = 32;

// Work at a time: little beside what a person notices.
constexpr auto slice = 8ms;

/// The time that a step takes, on a clock of its own.
void pass(device::Clock& clock, const recording::Step& step) {
  clock.transfer(step.item.size);
  const auto* command = std::get_if<protocol::Message>(&step.item.content);
  if (command == nullptr) return;
  clock.execute(*command);
  if (command->opcode == protocol::Opcode::wait) clock.wait(command->operands[0]);
}

void execute(std::span<const std::uint8_t> commands, device::Device& device) {
  protocol::Decoder decoder(protocol::Direction::to_device);
  while (const auto item = decoder.next(commands)) device.execute(*item);
}

Player::Time due(const device::Clock& played, Player::Time since) {
  return since + std::chrono::nanoseconds(played.picoseconds / 1000);
}

} // namespace

Player::Player(recording::Trace trace, recording::Trail trail, Past past)
    : trace_(std::move(trace)),
      trail_(trail),
      past_(past),
      head_(trace_, recording::States::passed_by, trail),
      spacing_(first_spacing) {
  assert(past == Past::kept || trail == recording::Trail::grows);
  if (past == Past::kept) snapshots_.emplace(0, head_);
  if (trail == recording::Trail::ends) look_from(0);
}

void Player::extend(std::vector<recording::Record> records) {
  std::ranges::move(records, std::back_inserter(trace_.records));
}

bool Player::advance(Time now) {
  const bool grew = play_head(std::chrono::steady_clock::now() + slice);
  const bool has_changed = is_following() ? grew : play_view(now);
  if (past_ == Past::forgotten) forget();
  return has_changed;
}

void Player::forget() {
  const std::size_t passed = view_ ? std::min(view_->passed(), head_.passed()) : head_.passed();
  // What is left moves up: not each time, where the view is far behind.
  if (passed <= trace_.records.size() / 2) return;
  trace_.records.erase(trace_.records.begin(), trace_.records.begin() + static_cast<std::ptrdiff_t>(passed));
  head_.forget(passed);
  if (view_) view_->forget(passed);
}

/// Whether there was anything to play.
bool Player::play_head(Time until) {
  const std::uint64_t before = length_;
  while (head_.next()) {
    head_.execute();
    ++length_;
    if (past_ == Past::kept && length_ % spacing_ == 0) leave_snapshot();
    if (std::chrono::steady_clock::now() >= until) break;
  }
  return length_ != before;
}

void Player::leave_snapshot() {
  snapshots_.emplace(length_, head_);
  if (snapshots_.size() <= most_snapshots) return;
  spacing_ *= 2;
  std::erase_if(snapshots_, [&](const auto& snapshot) { return snapshot.first % spacing_ != 0; });
}

/// Whether the view went on.
bool Player::play_view(Time now) {
  if (is_paused_) return false;
  const std::uint64_t before = position_;
  const std::uint64_t last = hold_ && position_ <= *hold_ ? std::min(length_, *hold_) : length_;
  const Time end = std::chrono::steady_clock::now() + slice;
  while (position_ < last && std::chrono::steady_clock::now() < end) {
    if (!is_under_way_) {
      const auto step = view_->next();
      if (!step) break;
      pass(played_, *step);
      is_under_way_ = true;
    }
    if (bus_ && due(played_, since_) > now) break;
    view_->execute();
    is_under_way_ = false;
    ++position_;
  }
  // A pace that waited for the stream does not run to make up for it.
  if (position_ == last && bus_ && due(played_, since_) < now) {
    played_.picoseconds = 0;
    since_ = now;
  }
  if (position_ == before) return false;
  update_shown();
  return true;
}

void Player::interpose(std::span<const std::uint8_t> commands) {
  interposed_.insert(interposed_.end(), commands.begin(), commands.end());
  execute(commands, shown_);
}

void Player::update_shown() {
  shown_ = view_->device();
  execute(interposed_, shown_);
}

void Player::follow() {
  is_paused_ = false;
  bus_.reset();
  if (trail_ == recording::Trail::ends) return look_from(length_);
  view_.reset();
  interposed_.clear();
}

void Player::seek(std::uint64_t commands) {
  is_paused_ = true;
  look_from(std::min(commands, length_));
}

void Player::look_from(std::uint64_t commands) {
  // What is under way cannot be taken back, but the view can be taken from a snapshot.
  if (!view_ || is_under_way_ || commands < position_ || commands - position_ > spacing_) {
    if (commands == length_) {
      view_.emplace(head_);
      position_ = length_;
    } else {
      assert(past_ == Past::kept);
      const auto snapshot = std::prev(snapshots_.upper_bound(commands));
      view_.emplace(snapshot->second);
      position_ = snapshot->first;
    }
    is_under_way_ = false;
  }
  while (position_ < commands && view_->next()) {
    view_->execute();
    ++position_;
  }
  update_shown();
}

void Player::pause() {
  is_paused_ = true;
  if (is_following()) look_from(length_);
}

void Player::play(const std::optional<device::Bus>& bus, Time now) {
  if (is_following() && !bus) return;
  look_from(position());
  is_paused_ = false;
  bus_ = bus;
  played_ = {};
  if (bus) played_.bus = *bus;
  since_ = now;
}

} // namespace halftone::watch
