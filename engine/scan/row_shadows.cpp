#include "row_shadows.h"

#include <algorithm>
#include <numeric>

namespace halftone::scan {

namespace {

/// Up to this number the shadows of a row are looked through one by one, beyond it those of a block of
/// columns.
constexpr std::size_t few_shadows = 8;
constexpr int narrow_block = 2;

} // namespace

void RowShadows::find(const FaceShadows::OnFace& on_face, int y, int width, std::uint64_t& comparisons) {
  all_.clear();
  on_face.rows.meeting(row_bounds(y), [&](int number) {
    ++comparisons;
    const FaceShadow& shadow = on_face.all[number];
    if (!(shadow.outline.top < y + 1 && shadow.outline.bottom > y)) return;
    RowOutline row = shadow.outline.in_row(y);
    if (!row.touched.is_empty()) all_.push_back({&shadow, std::move(row)});
  });
  // Where a light is dark, nothing else matters to it.
  std::sort(all_.begin(), all_.end(), [](const RowShadow& a, const RowShadow& b) {
    return a.shadow->dark != b.shadow->dark ? a.shadow->dark : a.shadow < b.shadow;
  });
  list_in_blocks(width);
}

void RowShadows::list_in_blocks(int width) {
  block_width_ = all_.size() > few_shadows ? narrow_block : width;
  const auto blocks_of = [&](const RowShadow& shadow) {
    const PixelRange& touched = shadow.row.touched;
    return PixelRange{std::max(touched.begin, 0) / block_width_,
                      (std::min(touched.end, width) - 1) / block_width_ + 1};
  };
  ends_.assign((width - 1) / block_width_ + 1, 0);
  std::size_t listed = 0;
  for (const RowShadow& shadow : all_) {
    const PixelRange blocks = blocks_of(shadow);
    for (int b = blocks.begin; b < blocks.end; ++b, ++listed) ++ends_[b];
  }
  // Each block's end is its beginning, until its list is written.
  std::exclusive_scan(ends_.begin(), ends_.end(), ends_.begin(), 0);
  listed_.resize(listed);
  for (int k = 0; k < static_cast<int>(all_.size()); ++k) {
    const PixelRange blocks = blocks_of(all_[k]);
    for (int b = blocks.begin; b < blocks.end; ++b) listed_[ends_[b]++] = k;
  }
}

} // namespace halftone::scan
