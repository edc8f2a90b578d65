// SPDX-License-Identifier: MIT
#include "clipping/chunks.h"

#include "clipping/batch/sets.h"
#include "clipping/ieee_numbers.h"
#include "clipping/limits.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace clipping {
namespace {

/// The smallest box around these segments. If one of their numbers is not finite, the box consists
/// of NaNs, for which every comparison is false.
template <class T>
BasicWindow<T> boxAround(std::span<const BasicSegment<T>> segments)
{
    constexpr T infinity = std::numeric_limits<T>::infinity();
    BasicWindow<T> box{{infinity, infinity}, {-infinity, -infinity}};
    T zero{};
    for (const auto& [a, b] : segments) {
        box.min = {std::min({box.min.x, a.x, b.x}), std::min({box.min.y, a.y, b.y})};
        box.max = {std::max({box.max.x, a.x, b.x}), std::max({box.max.y, a.y, b.y})};
        zero += (a.x - a.x) + (a.y - a.y) + (b.x - b.x) + (b.y - b.y);
    }
    box.min += glm::vec<2, T>(zero);
    return box;
}

/// The end of the run that begins at `begin`.
template <class T>
std::size_t endOfRun(std::span<const BasicSegment<T>> segments, std::size_t begin)
{
    const std::size_t last = std::min(begin + BasicChunks<T>::longest, segments.size());
    for (std::size_t i = begin + BasicChunks<T>::shortest; i < last; ++i)
        if (segments[i].a != segments[i - 1].b)
            return i;
    return last;
}

enum class Place : std::uint8_t { Outside, Inside, Across };

template <class T>
Place placeOf(const BasicWindow<T>& box, const BasicWindow<T>& w)
{
    if (box.max.x < w.min.x || box.min.x > w.max.x || box.max.y < w.min.y || box.min.y > w.max.y)
        return Place::Outside;
    const bool inside = box.min.x >= w.min.x && box.max.x <= w.max.x && box.min.y >= w.min.y
                        && box.max.y <= w.max.y;
    return inside ? Place::Inside : Place::Across;
}

} // namespace

template <class T>
BasicChunks<T>::BasicChunks(std::span<const BasicSegment<T>> segments)
{
    update(segments, 0, segments.size());
}

template <class T>
void BasicChunks<T>::update(std::span<const BasicSegment<T>> segments, std::size_t first,
                            std::size_t last)
{
    assert(first <= last && last <= segments.size());
    auto chunk = std::ranges::upper_bound(chunks_, first, {}, &Chunk::end);
    std::size_t begin = chunk == chunks_.begin() ? 0 : chunk[-1].end;
    if (!chunks_.empty() && chunks_.back().end == segments.size()) {
        for (; begin < last; begin = chunk++->end)
            chunk->box = boxAround(segments.subspan(begin, chunk->end - begin));
        return;
    }
    chunks_.erase(chunk, chunks_.end());
    while (begin < segments.size()) {
        const std::size_t end = endOfRun(segments, begin);
        chunks_.push_back({boxAround(segments.subspan(begin, end - begin)), end});
        begin = end;
    }
}

template <class T>
std::size_t BasicChunks<T>::clipAll(std::span<const BasicSegment<T>> segments,
                                    const BasicWindow<T>& window,
                                    std::span<BasicClipped<BasicSegment<T>>> out) const noexcept
{
    requireRoom(segments.size(), out.size());
    assert(segments.size() == (chunks_.empty() ? 0 : chunks_.back().end));
    if (!canShow(window))
        return 0;
    std::size_t pieces = 0, begin = 0;
    for (auto chunk = chunks_.begin(); chunk != chunks_.end(); ++chunk) {
        const Place place = placeOf(chunk->box, window);
        while (chunk + 1 != chunks_.end() && placeOf(chunk[1].box, window) == place)
            ++chunk;
        if (place == Place::Inside)
            for (std::size_t i = begin; i < chunk->end; ++i)
                out[pieces++] = {segments[i], static_cast<std::uint32_t>(i), 0};
        else if (place == Place::Across)
            pieces +=
                clipBatch(Batch<T>{segments.data(), begin, chunk->end, window, out.data() + pieces})
                    .pieces;
        begin = chunk->end;
    }
    return pieces;
}

template class BasicChunks<double>;
template class BasicChunks<float>;

} // namespace clipping
