// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

class QThreadPool;

namespace app {

/// How many threads are worth taking part in `inParallel`.
std::size_t workersOf(const QThreadPool& pool);

/// Calls work(item, worker) once for each item below `items`, on the calling thread (worker 0) and
/// on those of `pool` that are free. Items are begun in order; no two calls at the same time have
/// the same worker, which is below `workers`. Returns when all calls have; it waits for no thread
/// that has not begun, so it may itself be called on the pool. After an exception no other item is
/// begun; the first one is thrown again. Fewer threads take part where memory is short.
void inParallel(QThreadPool& pool, std::size_t workers, std::size_t items,
                const std::function<void(std::size_t item, std::size_t worker)>& work);

} // namespace app
