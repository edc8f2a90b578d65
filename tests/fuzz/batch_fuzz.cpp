// SPDX-License-Identifier: GPL-3.0-or-later
// The vector kernels and the chunk boxes, bit for bit against `exact` on one segment at a time.
#include "clipping/algorithm.h"
#include "clipping/batch/kernels.h"
#include "clipping/chunks.h"

#include <glm/common.hpp>

#include "tests/clipping/same_bits.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/target.h"

using namespace clipping;

namespace {

constexpr std::size_t most = 100; // some vectors, and chunks, of either number

template <class T>
using Pieces = std::vector<BasicClipped<BasicSegment<T>>>;

template <class T>
const Functions<BasicSegment<T>, BasicWindow<T>>& exactUses()
{
    static const Algorithm& exact = *findAlgorithm("exact");
    if constexpr (sizeof(T) == sizeof(double))
        return exact.corrected;
    else
        return *exact.floats;
}

template <class T>
auto kernelOf(const InstructionSet& set)
{
    if constexpr (sizeof(T) == sizeof(double))
        return set.clip;
    else
        return set.clipSingle;
}

template <class T>
void compare(const Pieces<T>& pieces, const std::vector<BasicSegment<T>>& segments,
             const BasicWindow<T>& window, const std::string& who)
{
    std::size_t next = 0;
    for (std::size_t i = 0; i < segments.size(); ++i)
        if (const auto piece = exactUses<T>().clip(segments[i], window)) {
            if (next == pieces.size() || pieces[next].source != i
                || !sameBits(pieces[next].segment, *piece))
                found(who + " differs from one by one at segment " + std::to_string(i));
            ++next;
        }
    if (next != pieces.size())
        found(who + " sees more than one by one");
}

template <class T>
void tryAll(const std::vector<BasicSegment<T>>& segments, const BasicWindow<T>& window)
{
    for (const InstructionSet& set : instructionSets()) {
        if (!set.available)
            continue;
        Pieces<T> pieces(segments.size());
        const auto result =
            kernelOf<T>(set)({segments.data(), 0, segments.size(), window, pieces.data()});
        pieces.resize(result.pieces);
        compare(pieces, segments, window, std::string(set.name) + std::to_string(sizeof(T)));
    }
    Pieces<T> pieces(segments.size());
    const BasicChunks<T> chunks(segments);
    pieces.resize(chunks.clipAll(segments, window, pieces));
    compare(pieces, segments, window, "chunks " + std::to_string(sizeof(T)));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    Bytes bytes(data, size);
    const auto point = [&] {
        const double x = bytes.number();
        return glm::dvec2(x, bytes.number());
    };
    const glm::dvec2 p = point(), q = point();
    const Window window{glm::min(p, q), glm::max(p, q)};
    std::vector<Segment> segments;
    std::vector<BasicSegment<float>> single;
    while (!bytes.ended() && segments.size() < most) {
        const glm::dvec2 a = point(), b = point();
        segments.push_back({a, b});
        single.push_back({glm::vec2(a), glm::vec2(b)});
    }
    tryAll(segments, window);
    tryAll(single, {glm::vec2(window.min), glm::vec2(window.max)});
    return 0;
}
