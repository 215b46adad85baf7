#include "table_receiver.h"

#include "document.h"

#include <halftone/protocol/message.h>

#include <algorithm>
#include <span>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace halftone::test {

namespace {

std::size_t number_at(const Bytes& bytes, std::size_t at, std::size_t size) {
  std::size_t number = 0;
  for (std::size_t i = at; i < at + size; ++i) number = number * 256 + bytes[i];
  return number;
}

} // namespace

std::vector<Transition> documented_transitions() {
  std::vector<Transition> table;
  std::istringstream lines(section_of_document("receiver"));
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> cells;
    for (std::size_t bar = line.find("| "), end; (end = line.find(" |", bar)) != std::string::npos;
         bar = end + 1)
      cells.push_back(line.substr(bar + 2, end - bar - 2));
    if (cells.size() == 4 && cells[0] != "in state")
      table.push_back({cells[0], cells[1], cells[2], cells[3]});
  }
  return table;
}

std::vector<std::string> TableReceiver::take(std::uint8_t byte) {
  coming_.push_back(byte);
  take_all();
  return std::exchange(reports_, {});
}

std::vector<std::string> TableReceiver::end() {
  do {
    byte_.reset();
    follow("the end");
    take_all();
  } while (state_ != "idle");
  return std::exchange(reports_, {});
}

void TableReceiver::take_all() {
  while (!coming_.empty()) {
    byte_ = coming_.front();
    coming_.pop_front();
    ++position_;
    follow(event_of(*byte_));
  }
}

std::string TableReceiver::event_of(std::uint8_t byte) const {
  if (state_ == "idle" && byte == 0) return "the byte `00`";
  if (state_ == "idle" || state_ == "damage") return byte == 0x4D ? "the byte `4D`" : "any other byte";
  Bytes bytes = kept_;
  bytes.push_back(byte);
  if (bytes.size() < 9) return "a byte before the ninth";
  const std::size_t length = number_at(bytes, 7, 2);
  if (bytes.size() == 9)
    return number_at(bytes, 0, 2) == 0x4D35 && length <= 4096
               ? "the ninth, sync word right and length at most 4096"
               : "the ninth, sync word wrong or length beyond";
  if (bytes.size() < 9 + length + 4) return "a byte before the last";
  const std::span<const std::uint8_t> checked = std::span(bytes).first(9 + length);
  return number_at(bytes, 9 + length, 4) == naive_checksum(checked) ? "the last, checksum right"
                                                                    : "the last, checksum wrong";
}

void TableReceiver::follow(const std::string& event) {
  const auto row = std::ranges::find_if(
      table_, [&](const Transition& t) { return t.state == state_ && t.event == event; });
  if (row == table_.end()) throw std::logic_error("no row for \"" + event + "\" in state " + state_);
  ++row->taken;
  act(row->action);
  state_ = row->next;
}

void TableReceiver::act(const std::string& action) {
  if (action == "nothing") return;
  if (action == "keeps it") {
    kept_.push_back(*byte_);
  } else if (action == "counts it") {
    ++damaged_;
  } else if (action == "reports the damage") {
    report_damage(position_);
  } else if (action == "reports the damage if there is any, then the frame") {
    kept_.push_back(*byte_);
    const std::size_t begin = position_ - kept_.size();
    if (damaged_ != 0) report_damage(begin);
    last_sequence_ = static_cast<std::uint32_t>(number_at(kept_, 3, 4));
    const protocol::Frame frame{kept_[2], last_sequence_, std::span(kept_).subspan(9, kept_.size() - 13)};
    reports_.push_back(describe({begin, kept_.size(), parse(frame, protocol::Direction::to_device)}));
    kept_.clear();
  } else if (action == "goes back") {
    if (byte_) kept_.push_back(*byte_);
    ++damaged_;
    coming_.insert(coming_.begin(), kept_.begin() + 1, kept_.end());
    position_ -= kept_.size() - 1;
    kept_.clear();
  } else {
    throw std::logic_error("unknown action: " + action);
  }
}

void TableReceiver::report_damage(std::size_t end) {
  reports_.push_back(
      describe({end - damaged_, damaged_, protocol::Rejection{protocol::Fault::damaged, last_sequence_, 0}}));
  damaged_ = 0;
}

} // namespace halftone::test
