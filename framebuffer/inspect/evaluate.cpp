#include <halftone/inspect/check.h>

#include "evaluate.h"

#include <halftone/inspect/reference.h>

#include <halftone/recording/walk.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace halftone::inspect {

namespace {

/// Whether the check is due after this step; those at the end never are.
bool is_due(const Moment& moment, const recording::Step& step) {
  if (const auto* number = std::get_if<std::uint64_t>(&moment)) return *number == step.number;
  const auto* name = std::get_if<std::string>(&moment);
  const protocol::Message* message = message_of(step);
  if (name == nullptr || message == nullptr || message->opcode != protocol::Opcode::mark) return false;
  return std::string_view(*name) ==
         std::string_view(reinterpret_cast<const char*>(message->data.data()), message->data.size());
}

/// The first of a stream's marks, of which there may be millions.
class Marks {
public:
  void add(std::string_view mark) {
    if (count_++ < most) text_ += (count_ == 1 ? "\"" : ", \"") + std::string(mark) + '"';
  }

  bool is_empty() const { return count_ == 0; }

  std::string text() const {
    return count_ > most ? text_ + " and " + std::to_string(count_ - most) + " more" : text_;
  }

private:
  static constexpr std::uint64_t most = 10;
  std::uint64_t count_ = 0;
  std::string text_;
};

/// Why a check was never due.
std::string missed(const Moment& moment, std::uint64_t commands, const Marks& marks) {
  if (std::holds_alternative<std::uint64_t>(moment))
    return "the recording ends after command " + std::to_string(commands);
  const std::string problem = "the recording has no mark \"" + std::get<std::string>(moment) + '"';
  return problem + (marks.is_empty() ? ", nor any other" : "; it has " + marks.text());
}

} // namespace

std::vector<Verdict> evaluate(const recording::Trace& trace, const std::vector<Check>& checks) {
  recording::Walk walk(trace);
  std::vector<Verdict> verdicts(checks.size());
  Counts counts;
  std::uint64_t number = 0;
  Marks marks;
  const auto judge_now = [&](std::size_t i) {
    verdicts[i] = judge(checks[i], walk.device(), counts);
    verdicts[i].number = number;
  };
  const auto judge_those_due = [&](const auto& is_now) {
    for (std::size_t i = 0; i < checks.size(); ++i)
      if (!verdicts[i].number && is_now(checks[i].at)) judge_now(i);
  };
  judge_those_due([](const Moment& at) {
    const auto* command = std::get_if<std::uint64_t>(&at);
    return command != nullptr && *command == 0;
  });
  while (const auto step = walk.next()) {
    number = step->number;
    count(*step, counts);
    const protocol::Message* message = message_of(*step);
    if (message != nullptr && message->opcode == protocol::Opcode::mark)
      marks.add({reinterpret_cast<const char*>(message->data.data()), message->data.size()});
    walk.execute();
    judge_those_due([&](const Moment& at) { return is_due(at, *step); });
  }
  judge_those_due([](const Moment& at) { return std::holds_alternative<AtEnd>(at); });
  for (std::size_t i = 0; i < checks.size(); ++i)
    if (!verdicts[i].number) verdicts[i].message = missed(checks[i].at, number, marks);
  return verdicts;
}

std::optional<std::size_t> numbers_of_setting(std::string_view name) {
  for (const Setting& setting : settings({}))
    if (setting.name == name) return setting.values.size();
  return std::nullopt;
}

bool is_counted(std::string_view name) {
  if (name == "commands" || name == "queries" || name == "errors") return true;
  const protocol::OpcodeEntry* entry = protocol::find(name);
  return entry != nullptr && entry->direction == protocol::Direction::to_device;
}

} // namespace halftone::inspect
