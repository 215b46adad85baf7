#pragma once
// Commands of a recording, as they are told to people.

#include <halftone/recording/walk.h>

#include <halftone/device/device.h>

#include <cstdint>
#include <string>

namespace halftone::inspect {

/// Owns what it says.
struct Reference {
  std::uint64_t number = 0; ///< in the recording; the first is 1, and rejected ones count
  std::uint64_t offset = 0; ///< of its first byte in all data of the recording
  std::uint64_t session = 0;
  std::uint32_t sequence = 0;
  std::string text;    ///< as the disassembler writes it, long data cut off; or what is wrong with it;
                       ///< of a restart of the device: that it is one
  std::string section; ///< the last mark before it, or that it is; empty where there is none

  bool operator==(const Reference&) const = default;
};

/// Follows the marks of a recording, so that commands can be told with the section that they are in.
class Sections {
public:
  /// To be called with every step, before it is referred to.
  void follow(const recording::Step& step);
  Reference refer_to(const recording::Step& step) const;

private:
  std::string section_;
};

/// The message, null if the command was rejected. It is the step's.
const protocol::Message* message_of(const recording::Step& step);

/// Whether it asks something, and so changes nothing but the clock.
bool is_query(const protocol::Message& message);

/// Whether the write mask lets no bit of what the command would write through.
bool is_masked_out(const device::Registers& registers, const protocol::Message& message);

} // namespace halftone::inspect
