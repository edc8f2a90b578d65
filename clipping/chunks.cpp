// SPDX-License-Identifier: MIT
#include "clipping/chunks.h"

#include "clipping/batch/sets.h"

#include <algorithm>
#include <cassert>
#include <limits>

namespace clipping {
namespace {

/// The smallest box around these segments; of NaNs, which no comparison places anywhere, if one of
/// their numbers is not finite.
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
    assert(last <= segments.size());
    const std::size_t chunks = (segments.size() + size - 1) / size;
    // What moved because something before it was inserted or removed is new as well.
    const bool resized = chunks != boxes_.size() || last == segments.size();
    boxes_.resize(chunks);
    const std::size_t end = resized ? chunks : std::min((last + size - 1) / size, chunks);
    for (std::size_t i = first / size; i < end; ++i)
        boxes_[i] =
            boxAround(segments.subspan(i * size, std::min(size, segments.size() - i * size)));
}

template <class T>
std::size_t BasicChunks<T>::clipAll(std::span<const BasicSegment<T>> segments,
                                    const BasicWindow<T>& window,
                                    std::span<BasicClipped<BasicSegment<T>>> out) const
{
    assert(out.size() >= segments.size() && boxes_.size() == (segments.size() + size - 1) / size);
    if (!legal(window))
        return 0;
    std::size_t pieces = 0;
    for (std::size_t i = 0; i < boxes_.size();) {
        const Place place = placeOf(boxes_[i], window);
        const std::size_t begin = i * size;
        do
            ++i;
        while (place != Place::Outside && i < boxes_.size() && placeOf(boxes_[i], window) == place);
        const std::size_t end = std::min(i * size, segments.size());
        if (place == Place::Inside)
            for (std::size_t j = begin; j < end; ++j)
                out[pieces++] = {segments[j], static_cast<std::uint32_t>(j), 0};
        else if (place == Place::Across)
            pieces += clipBatch(Batch<T>{segments.data(), begin, end, window, out.data() + pieces})
                          .pieces;
    }
    return pieces;
}

template class BasicChunks<double>;
template class BasicChunks<float>;

} // namespace clipping
