// SPDX-License-Identifier: GPL-3.0-or-later
// Every row's form for float data against the oracle.
#include "tests/fuzz/one_input.h"

using namespace clipping;

namespace {

using S = BasicSegment<float>;
using W = BasicWindow<float>;

S inFloat(const Segment& s) { return {glm::vec2(s.a), glm::vec2(s.b)}; }
W inFloat(const Window& w) { return {glm::vec2(w.min), glm::vec2(w.max)}; }
std::optional<Segment> inDouble(const std::optional<S>& s)
{
    return s ? std::optional(Segment{glm::dvec2(s->a), glm::dvec2(s->b)}) : std::nullopt;
}

/// The bytes' numbers, rounded to floats.
Input rounded(const Input& input)
{
    const W w = inFloat(input.window);
    return {inDouble(inFloat(input.segment)), {glm::dvec2(w.min), glm::dvec2(w.max)}};
}

/// Whether the three ways to ask for one segment say the same.
bool seesTheSame(const Functions<S, W>& uses, const S& s, const W& w)
{
    const auto one = inDouble(uses.clip(s, w));
    const auto same = [&one](bool seen, const Segment& piece) {
        return seen == one.has_value() && (!one || sameBits(*one, piece));
    };
    std::array<BasicClipped<S>, 1> out{};
    const bool seen = uses.clipAll({&s, 1}, w, out) != 0;
    const Trace trace = uses.trace(s, w);
    return same(seen, inDouble(out[0].segment))
           && same(trace.outcome == Outcome::Visible, trace.visible);
}

/// How a row breaks its contract; empty if it keeps it.
std::string faultOf(const Algorithm& a, const Input& input, const Truth<2>& truth)
{
    const S s = inFloat(input.segment);
    const W w = inFloat(input.window);
    if (!seesTheSame(*a.floats, s, w))
        return "clip, clipAll and the trace differ";
    const auto result = inDouble(a.floats->clip(s, w));
    if (!legalInput<2>(input))
        return result ? "seen where the contract says nothing" : "";
    return fault<2>(result, input, truth, a.ulps, oracle::Number::Single);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto input = rounded(inputOf<2>({data, size}));
    const auto truth = legalInput<2>(input) ? truthOf(input) : std::nullopt;
    for (const Algorithm& a : algorithms())
        if (a.floats)
            if (const auto wrong = faultOf(a, input, truth); !wrong.empty())
                found(std::string(a.key) + " in float: " + wrong + " for " + exactly(input));
    return 0;
}
