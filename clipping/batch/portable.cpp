// SPDX-License-Identifier: MIT
#include "clipping/algorithm.h"
#include "clipping/batch/sets.h"
#include "clipping/describe.h"

#include <algorithm>
#include <cmath>

namespace clipping {
namespace {

template <class T>
bool mayMeet(const BasicSegment<T>& s, const Box<T>& box)
{
    const auto& [min, max] = box.window;
    const bool beyond = (s.a.x < min.x && s.b.x < min.x) | (s.a.x > max.x && s.b.x > max.x)
                        | (s.a.y < min.y && s.b.y < min.y) | (s.a.y > max.y && s.b.y > max.y);
    const T dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
    const T p = (s.a.x - box.centreX) * dy, q = (s.a.y - box.centreY) * dx;
    const T reach = box.halfWidth * std::abs(dy) + box.halfHeight * std::abs(dx);
    const T bound = (reach + std::abs(p) + std::abs(q)) * missBound<T> + missTiny<T>;
    return !beyond & !(std::abs(p - q) > reach + bound);
}

template <class T>
BatchResult clipPortably(const Batch<T>& batch)
{
    if (!legal(batch.window))
        return {};
    const Box<T> box = boxOf(batch.window);
    std::uint32_t survivors[blockSize];
    std::size_t pieces = 0;
    for (std::size_t first = batch.begin; first < batch.end; first += blockSize) {
        const std::size_t last = std::min(first + blockSize, batch.end);
        std::size_t count = 0;
        for (std::size_t i = first; i < last; ++i) {
            survivors[count] = static_cast<std::uint32_t>(i);
            count += mayMeet(batch.segments[i], box);
        }
        pieces += clipOneByOne(batch.segments, survivors, count, batch.window, batch.out + pieces);
    }
    return {pieces, 0};
}

} // namespace

const InstructionSet portableSet{"portable", true, clipPortably<double>, clipPortably<float>};

template <class T>
bool legal(const BasicWindow<T>& window)
{
    return withinContract(BasicSegment<T>{}, window);
}
template bool legal(const BasicWindow<double>&);
template bool legal(const BasicWindow<float>&);

template <class T>
Box<T> boxOf(const BasicWindow<T>& w)
{
    const auto centre = [](T low, T high) { return low / 2 + high / 2; };
    const auto half = [](T low, T high, T middle) {
        const T larger = std::max(high - middle, middle - low);
        return std::nextafter(larger, std::numeric_limits<T>::infinity());
    };
    const T x = centre(w.min.x, w.max.x), y = centre(w.min.y, w.max.y);
    return {w, x, y, half(w.min.x, w.max.x, x), half(w.min.y, w.max.y, y)};
}
template Box<double> boxOf(const BasicWindow<double>&);
template Box<float> boxOf(const BasicWindow<float>&);

} // namespace clipping
