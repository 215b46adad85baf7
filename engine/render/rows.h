#pragma once
// Rows drawn by several threads and delivered in order.

#include "row_source.h"

#include <functional>
#include <stop_token>

namespace halftone::render {

/// Calls source.draw(worker, top, count) once for each band of rows, on `threads` threads, and deliver(y,
/// row) from the top row to the bottom one, on the calling thread, while others are being drawn. An exception
/// from either stops all and is rethrown here; so does `stop`, without one.
void for_each_row(RowSource& source, int height, int threads,
                  const std::function<void(int, const DrawnRow&)>& deliver, const std::stop_token& stop);

} // namespace halftone::render
