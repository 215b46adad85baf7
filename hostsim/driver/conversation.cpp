#include "conversation.h"

#include <halftone/driver/driver.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace halftone::driver {

namespace {

// A query is sent up to six times. The first silence that is taken for a loss is short, since most answers
// come at once, and each further one twice as long; together they are the timeout.
constexpr int attempt_limit = 6;
constexpr int patience_parts = (1 << attempt_limit) - 1;

} // namespace

struct Conversation::Question {
  const Take& take;
  protocol::Opcode answer;
  std::uint32_t sequence;
  Clock::time_point give_up;
};

Conversation::Conversation(link::Link& link, std::chrono::milliseconds timeout)
    : link_(link),
      timeout_(timeout) {
  begin_step();
}

void Conversation::begin_step() { step_end_ = Clock::now() + step_limit * timeout_; }

/// As bytes, with sequence numbers.
std::vector<std::uint8_t> Conversation::numbered(std::span<const protocol::Message> commands) {
  std::vector<std::uint8_t> bytes;
  for (protocol::Message command : commands) {
    command.sequence = ++sequence_;
    append(bytes, command);
  }
  return bytes;
}

void Conversation::tell(std::span<const protocol::Message> commands) { link_.send(numbered(commands)); }

void Conversation::ask(const protocol::Message& query, const Take& take) { ask({}, query, take); }

void Conversation::ask(std::vector<std::uint8_t> before, const protocol::Message& query, const Take& take) {
  const protocol::OpcodeEntry& entry = protocol::entry_of(query.opcode);
  std::vector<std::uint8_t> bytes = numbered({&query, 1});
  before.insert(before.end(), bytes.begin(), bytes.end());

  Question question{take, *entry.answer, sequence_, std::min(Clock::now() + timeout_, step_end_)};
  Clock::duration patience = Clock::duration(timeout_) / patience_parts;
  for (int attempt = 0; attempt < attempt_limit && Clock::now() < question.give_up;) {
    link_.send(before.empty() ? bytes : std::exchange(before, {}));
    const Progress progress = listen(question, patience);
    if (progress == Progress::complete) return;
    if (progress == Progress::none) {
      ++attempt;
      patience *= 2;
    }
    // Repeated with the same number, so that a late answer serves as well. Before it as many zeros as a frame
    // can have: a decoder that waits for the rest of a frame that was cut off gets to its end.
    if (bytes.size() < protocol::frame_limit)
      bytes.insert(bytes.begin(), protocol::frame_limit, std::uint8_t{0});
  }
  if (Clock::now() >= step_end_)
    throw link::Timeout("the link is too bad: questions and repeats took longer than " +
                        std::to_string((step_limit * timeout_).count()) + " ms");
  throw link::Timeout("the device did not answer \"" + std::string(entry.name) + "\" within " +
                      std::to_string(timeout_.count()) + " ms");
}

protocol::Message Conversation::ask(const protocol::Message& query) { return ask_after({}, query); }

protocol::Message Conversation::ask_after(std::span<const protocol::Message> commands,
                                          const protocol::Message& query) {
  protocol::Message answer;
  ask(numbered(commands), query, [&](const protocol::Message& reply) {
    answer = reply;
    answer.data = {};
    return Progress::complete;
  });
  return answer;
}

/// Hands over replies until they are complete or nothing has come for as long as patience lasts.
Progress Conversation::listen(Question& question, Clock::duration patience) {
  Progress best = Progress::none;
  std::array<std::uint8_t, 1 << 16> buffer;
  for (auto now = Clock::now(); now < question.give_up; now = Clock::now()) {
    const auto wait =
        std::chrono::ceil<std::chrono::milliseconds>(std::min(patience, question.give_up - now));
    std::span<const std::uint8_t> received;
    try {
      received = std::span(buffer).first(link_.receive(buffer, wait));
    } catch (const link::Timeout&) {
      break;
    }
    while (const auto item = decoder_.next(received)) {
      const Progress progress = consider(*item, question);
      if (progress == Progress::some) question.give_up = std::min(Clock::now() + timeout_, step_end_);
      best = std::max(best, progress);
    }
    if (best == Progress::complete) return best;
  }
  // Silence: what the decoder still waits for was lost, but whole replies may be behind it.
  while (const auto item = decoder_.drain()) best = std::max(best, consider(*item, question));
  return best;
}

Progress Conversation::consider(const protocol::Item& item, Question& question) const {
  const auto* reply = std::get_if<protocol::Message>(&item.content);
  if (reply == nullptr || reply->opcode != question.answer || reply->sequence != question.sequence) {
    return Progress::none; // damaged, or a late answer to an earlier question
  }
  return question.take(*reply);
}

} // namespace halftone::driver
