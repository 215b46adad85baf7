#include "file_link.h"

#include <halftone/file/write.h>

#include <vector>

namespace halftone::link {

namespace {

class FileLink final : public Link {
public:
  explicit FileLink(const std::string& path) : path_(path) {}

  void send(std::span<const std::uint8_t> bytes) override {
    sent_.insert(sent_.end(), bytes.begin(), bytes.end());
  }

  std::size_t receive(std::span<std::uint8_t>, std::chrono::milliseconds) override {
    throw DeviceError(path_ + " has no way back");
  }

  bool has_way_back() const override { return false; }

  void finish() override { file::write_whole(path_, std::as_bytes(std::span(sent_))); }

private:
  std::string path_;
  std::vector<std::uint8_t> sent_; ///< a picture is less than a megabyte
};

} // namespace

std::unique_ptr<Link> open_file_link(const std::string& path) {
  file::check_writable(path);
  return std::make_unique<FileLink>(path);
}

} // namespace halftone::link
