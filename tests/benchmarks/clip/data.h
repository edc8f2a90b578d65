// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"
#include "clipping/batch/kernels.h"
#include "clipping/chunks.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>

#include "tests/clipping/scenes.h"

/// A scene, what it is clipped into (its pages touched), and the boxes of its chunks.
template <class T>
struct Data {
    using S = clipping::BasicSegment<T>;
    Scene<T> scene;
    std::vector<clipping::BasicClipped<S>> out;
    clipping::BasicChunks<T> chunks;

    explicit Data(Scene<T> of) : scene(std::move(of)), out(scene.segments.size()), chunks(in())
    {
        std::ranges::fill(std::as_writable_bytes(std::span(out)), std::byte{1});
    }
    std::span<const S> in() const { return scene.segments; }
    clipping::Batch<T> batch(std::size_t begin, std::size_t end)
    {
        return {scene.segments.data(), begin, end, scene.window, out.data()};
    }
    /// The same in double, which is what the peers are made from.
    std::vector<clipping::Segment> doubles() const
    {
        std::vector<clipping::Segment> result;
        for (const S& s : scene.segments)
            result.push_back({s.a, s.b});
        return result;
    }
    clipping::Window doubleWindow() const { return {scene.window.min, scene.window.max}; }
};

template <class T>
constexpr const char* numbers = sizeof(T) == sizeof(double) ? "double" : "float";

template <class T>
clipping::BatchResult clipWith(const clipping::InstructionSet& set, const clipping::Batch<T>& batch)
{
    if constexpr (sizeof(T) == sizeof(double))
        return set.clip(batch);
    else
        return set.clipSingle(batch);
}

template <class T>
const clipping::Functions<clipping::BasicSegment<T>, clipping::BasicWindow<T>>*
usesFor(const clipping::Algorithm& algorithm)
{
    if constexpr (sizeof(T) == sizeof(double))
        return &algorithm.corrected;
    else
        return algorithm.floats;
}

inline std::string nameOf(const clipping::InstructionSet& set)
{
    return "exact, " + std::string(set.name);
}
inline const clipping::InstructionSet& fastestSet()
{
    const auto* fastest = &clipping::instructionSets().front(); // the portable one
    for (const auto& set : clipping::instructionSets())
        if (set.available)
            fastest = &set;
    return *fastest;
}
