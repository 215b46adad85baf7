#include "rows.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

namespace halftone::render {

void for_each_row(RowSource& source, int height, int threads,
                  const std::function<void(int, const DrawnRow&)>& deliver, const std::stop_token& stop) {
  std::mutex mutex; // guards rows, failure and stopping
  std::condition_variable changed;
  std::vector<std::optional<DrawnRow>> rows(height);
  std::exception_ptr failure;
  const int together = source.rows_together();
  std::atomic<int> next = 0; // band
  bool is_stopping = false;
  std::stop_source workers_stop; // for `stop` and for what is thrown
  const std::stop_callback on_stop(stop, [&] {
    workers_stop.request_stop();
    const std::lock_guard lock(mutex);
    is_stopping = true;
    changed.notify_one();
  });

  const auto work = [&](int worker) {
    try {
      for (int top = together * next++; top < height && !workers_stop.stop_requested();
           top = together * next++) {
        std::vector<DrawnRow> drawn =
            source.draw(worker, top, std::min(together, height - top), workers_stop.get_token());
        if (workers_stop.stop_requested()) break;
        const std::lock_guard lock(mutex);
        std::move(drawn.begin(), drawn.end(), rows.begin() + top);
        changed.notify_one();
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
      changed.notify_one();
    }
  };

  std::vector<std::jthread> workers;
  try {
    for (int worker = 0; worker < threads; ++worker) workers.emplace_back(work, worker);
    for (int y = 0; y < height; ++y) {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return rows[y] || failure || is_stopping; });
      if (failure) std::rethrow_exception(failure);
      if (is_stopping) break;
      const DrawnRow row = *std::move(rows[y]);
      rows[y].reset();
      lock.unlock();
      deliver(y, row);
    }
  } catch (...) {
    workers_stop.request_stop();
    throw; // the workers are joined on the way out
  }
}

} // namespace halftone::render
