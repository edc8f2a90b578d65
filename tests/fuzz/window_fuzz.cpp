// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the catalogue, in every form for a window, against the oracle.
#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/clipping/contract.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/target.h"

using namespace clipping;

namespace {

Input inputOf(Bytes bytes)
{
    double n[8];
    for (double& x : n)
        x = bytes.number();
    Window w{{n[0], n[1]}, {n[2], n[3]}};
    if (bytes.byte() != 1) // mostly in order
        w = {glm::min(w.min, w.max), glm::max(w.min, w.max)};
    return {{{n[4], n[5]}, {n[6], n[7]}}, w};
}

bool legal(const Input& input)
{
    const auto& [s, w] = input;
    const std::array all{s.a.x, s.a.y, s.b.x, s.b.y, w.min.x, w.min.y, w.max.x, w.max.y};
    return std::ranges::all_of(all, [](double x) { return std::isfinite(x); }) && w.min.x <= w.max.x
           && w.min.y <= w.max.y;
}

bool same(const std::optional<Segment>& s, const std::optional<Segment>& t)
{
    return s.has_value() == t.has_value() && (!s || sameBits(*s, *t));
}

/// Whether the three ways to ask for one segment say the same.
void agree(const Uses<Segment, Window>& uses, const Input& input, const std::string& who)
{
    const auto one = uses.clip(input.segment, input.window);
    std::array<Clipped, 1> out;
    const auto many = uses.clipAll({&input.segment, 1}, input.window, out) != 0
                          ? std::optional(out[0].segment)
                          : std::nullopt;
    if (!same(one, many))
        found(who + ": clipAll differs from clip for " + exactly(input));
    const Trace trace = uses.trace(input.segment, input.window);
    const bool seen = trace.outcome == Outcome::Visible;
    if (!same(one, seen ? std::optional(trace.visible) : std::nullopt))
        found(who + ": the trace differs from clip for " + exactly(input));
}

void keepContract(const Algorithm& a, const Input& input, const std::optional<oracle::Part>& truth)
{
    const std::string who(a.key);
    const auto result = a.corrected.clip(input.segment, input.window);
    if (const auto wrong = fault(result, input, truth, a.ulps); !wrong.empty())
        found(who + ": " + wrong + " for " + exactly(input));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const Input input = inputOf({data, size});
    const bool inContract = legal(input);
    const auto truth = inContract ? truthOf(input) : std::nullopt;
    for (const Algorithm& a : algorithms()) {
        agree(a.corrected, input, std::string(a.key));
        if (inContract)
            keepContract(a, input, truth);
        else if (a.corrected.clip(input.segment, input.window))
            found(std::string(a.key) + ": seen without numbers for " + exactly(input));
        if (a.published) // it must only come back
            a.published->clip(input.segment, input.window);
    }
    return 0;
}
