#pragma once
// The shadows that touch a row of a face, looked up by column.

#include "face_shadows.h"

#include <span>
#include <vector>

namespace halftone::scan {

struct RowShadow {
  const FaceShadow* shadow;
  RowOutline row;
};

/// Of one row at a time; keeps its memory from row to row.
class RowShadows {
public:
  /// All in row y of a picture of so many columns; dark ones first. on_face must live as long as they are
  /// asked for. Adds to the number of outlines that the row was compared with.
  void find(const FaceShadows::OnFace& on_face, int y, int width, std::uint64_t& comparisons);

  const RowShadow& operator[](int k) const { return all_[k]; }

  /// Those that may touch pixel x, ascending.
  std::span<const int> at(int x) const {
    const int block = x / block_width_, first = block == 0 ? 0 : ends_[block - 1];
    return std::span(listed_).subspan(first, ends_[block] - first);
  }

  /// The pixels with the same list as x.
  PixelRange block_of(int x) const {
    const int begin = x / block_width_ * block_width_;
    return {begin, begin + block_width_};
  }

private:
  void list_in_blocks(int width);

  std::vector<RowShadow> all_;
  int block_width_ = 1;
  std::vector<int> ends_;   ///< of each block in listed_
  std::vector<int> listed_; ///< indices into all_, block by block
};

} // namespace halftone::scan
