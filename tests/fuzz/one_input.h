// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/common.hpp>

#include <array>
#include <cmath>

#include "tests/clipping/contract.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/target.h"

// One segment and one window of two or three dimensions, and what every form must keep there.

template <glm::length_t N>
using FormUses =
    clipping::Functions<clipping::BasicSegment<double, N>, clipping::BasicWindow<double, N>>;

template <glm::length_t N>
glm::vec<N, double> pointOf(Bytes& bytes)
{
    glm::vec<N, double> p;
    for (glm::length_t i = 0; i < N; ++i)
        p[i] = bytes.number();
    return p;
}

template <glm::length_t N>
BasicInput<N> inputOf(Bytes bytes)
{
    const auto p = pointOf<N>(bytes), q = pointOf<N>(bytes);
    const auto a = pointOf<N>(bytes), b = pointOf<N>(bytes);
    if (bytes.byte() == 1) // rarely inside out
        return {{a, b}, {p, q}};
    return {{a, b}, {glm::min(p, q), glm::max(p, q)}};
}

/// Whether the contract promises anything for it; asked in another way than the library does.
template <glm::length_t N>
bool legalInput(const BasicInput<N>& input)
{
    const auto& [s, w] = input;
    bool legal = true;
    for (glm::length_t i = 0; i < N; ++i)
        legal = legal && std::isfinite(s.a[i]) && std::isfinite(s.b[i]) && std::isfinite(w.min[i])
                && std::isfinite(w.max[i]) && w.min[i] <= w.max[i];
    return legal;
}

/// The three ways to ask for one say the same, in the order of a and b.
template <glm::length_t N, class S>
void agree(const clipping::Functions<S, clipping::BasicWindow<double, N>,
                                     clipping::BasicSegment<double, N>>& uses,
           const S& segment, const BasicInput<N>& input, const std::string& who)
{
    using Piece = clipping::BasicSegment<double, N>;
    const auto same = [](const std::optional<Piece>& s, const std::optional<Piece>& t) {
        return s.has_value() == t.has_value() && (!s || sameBits(*s, *t));
    };
    const auto one = uses.clip(segment, input.window);
    std::array<clipping::BasicClipped<Piece>, 1> out;
    const bool seen = uses.clipAll({&segment, 1}, input.window, out) != 0;
    if (!same(one, seen ? std::optional(out[0].segment) : std::nullopt))
        found(who + ": clipAll differs from clip for " + exactly<N>(input));
    const auto trace = uses.trace(segment, input.window);
    const bool traced = trace.outcome == clipping::Outcome::Visible;
    if (!same(one, traced ? std::optional(trace.visible) : std::nullopt))
        found(who + ": the trace differs from clip for " + exactly<N>(input));
}

/// A corrected form keeps its contract, wherever that promises anything.
template <glm::length_t N>
void keepContract(const FormUses<N>& uses, const BasicInput<N>& input, const Truth<N>& truth,
                  double ulps, const std::string& who)
{
    agree<N>(uses, input.segment, input, who);
    const auto result = uses.clip(input.segment, input.window);
    if (!legalInput<N>(input)) {
        if (result)
            found(who + ": seen where the contract says nothing for " + exactly<N>(input));
        return;
    }
    if (const auto wrong = fault<N>(result, input, truth, ulps); !wrong.empty())
        found(who + ": " + wrong + " for " + exactly<N>(input));
}
