#pragma once
// Commands out, answers in, over a link that may lose or damage either.

#include <halftone/link/link.h>
#include <halftone/protocol/decoder.h>
#include <halftone/protocol/message.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace halftone::driver {

/// What a reply brought to the one who asked.
enum class Progress { none, some, complete };

class Conversation {
public:
  Conversation(link::Link& link, std::chrono::milliseconds timeout);

  /// The questions from here on, up to the next step, may take step_limit (driver.h) times the timeout in
  /// all.
  void begin_step();

  /// Sends commands, in one piece; their sequence numbers are given here.
  void tell(std::span<const protocol::Message> commands);

  using Take = std::function<Progress(const protocol::Message& reply)>;

  /// Sends a query and hands its replies to `take` until they are complete. Repeats the query when the link
  /// falls silent before, so take may see a reply twice. Throws link::Timeout when nothing came for `timeout`
  /// that take calls progress, or when the time of the step is over.
  void ask(const protocol::Message& query, const Take& take);

  /// The one reply to a query that has one, without its data.
  protocol::Message ask(const protocol::Message& query);

  /// The same after commands, in one piece with them: what others send over the link comes before or after
  /// all of it. Of what is repeated, only the query.
  protocol::Message ask_after(std::span<const protocol::Message> commands, const protocol::Message& query);

private:
  using Clock = std::chrono::steady_clock;
  struct Question;
  std::vector<std::uint8_t> numbered(std::span<const protocol::Message> commands);
  void ask(std::vector<std::uint8_t> before, const protocol::Message& query, const Take& take);
  Progress listen(Question& question, Clock::duration patience);
  Progress consider(const protocol::Item& item, Question& question) const;

  link::Link& link_;
  std::chrono::milliseconds timeout_;
  Clock::time_point step_end_;
  protocol::Decoder decoder_{protocol::Direction::to_host};
  std::uint32_t sequence_ = 0; ///< of the last message sent
};

} // namespace halftone::driver
