// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <unordered_map>

namespace app {

using StyleIndex = std::uint32_t; ///< of a style in its document's table

/// The styles of a document, each once: styles whose numbers differ in a bit are two. It only
/// grows, and what is in it stays where it is, so that any threads may read it while others add to
/// it. A thread may look up an index that it found, or that was handed to it, after the style was
/// added.
class StyleTable {
public:
    StyleTable() = default;
    StyleTable(const StyleTable& other); ///< the same styles by the same numbers
    StyleTable& operator=(const StyleTable&) = delete;
    ~StyleTable();

    StyleIndex indexOf(const Style& style); ///< adds it if it is new
    const Style& operator[](StyleIndex index) const;
    std::size_t size() const { return size_.load(std::memory_order_acquire); }

private:
    // Step k has room for 256 * 2^k styles, and never moves.
    std::array<std::atomic<Style*>, 24> steps_{};
    std::atomic<std::size_t> size_{0}; // published last
    std::mutex adding_;
    std::unordered_multimap<std::size_t, StyleIndex> found_; // by the hash of a style
};

} // namespace app
