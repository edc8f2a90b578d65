// SPDX-License-Identifier: GPL-3.0-or-later
// Rotated rectangles (clipping/turned_window.h) with every row: clipping many segments and the
// trace agree with one, for all numbers; and the bound on the error against fractions, where the
// numbers are not too far apart.
#include <array>

#include "tests/clipping/turned_contract.h"
#include "tests/fuzz/one_input.h"

using namespace clipping;
using turned_contract::described;

namespace {

struct TurnedInput {
    Segment segment;
    TurnedWindow window;
};

TurnedInput turnedInputOf(Bytes bytes)
{
    const glm::dvec2 a = pointOf<2>(bytes), b = pointOf<2>(bytes);
    const glm::dvec2 centre = pointOf<2>(bytes), half = pointOf<2>(bytes);
    const int kind = bytes.byte();
    const double degrees = kind % 4 == 0 ? 45.0 * (kind / 4) : bytes.number();
    return {{a, b}, {centre, kind % 8 == 1 ? half : glm::abs(half), degrees}};
}

bool isFinite(const TurnedInput& input)
{
    const auto& [s, w] = input;
    bool finite = std::isfinite(w.degrees);
    for (const auto& p : {s.a, s.b, w.centre, w.half})
        finite = finite && std::isfinite(p.x) && std::isfinite(p.y);
    return finite;
}

/// Whether fractions of these numbers have few enough digits.
bool isNarrow(const TurnedInput& input)
{
    const auto& [s, w] = input;
    bool narrow = isFinite(input) && std::abs(w.degrees) < 1e6;
    for (const auto& p : {s.a, s.b, w.centre, w.half})
        for (const double x : {p.x, p.y})
            narrow = narrow && (x == 0 || (std::abs(x) > 0x1p-60 && std::abs(x) < 0x1p60));
    return narrow;
}

void checkAny(const Functions<Segment, Window>& form, const TurnedInput& input,
              std::string_view key)
{
    const auto& [s, w] = input;
    const std::string what = std::string(key) + " for " + described(s, w);
    const auto one = clipTurned(form, s, w);
    std::array<Clipped, 1> out;
    const bool isSeen = clipAllTurned(form, {&s, 1}, w, out) != 0;
    if (isSeen != one.has_value() || (one && !sameBits(out[0].segment, *one)))
        found("clipAllTurned differs: " + what);
    if ((traceTurned(form, s, w).outcome == Outcome::Visible) != isSeen)
        found("the trace differs: " + what);
    if (!one)
        return;
    if (!isFinite(input) || w.half.x < 0 || w.half.y < 0)
        found("seen where there is nothing: " + what);
    for (const auto& p : {one->a, one->b})
        if (!std::isfinite(p.x) || !std::isfinite(p.y))
            found("not finite: " + what);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const TurnedInput input = turnedInputOf(Bytes(data, size));
    const bool narrow = isNarrow(input);
    for (const Algorithm& row : algorithms()) {
        checkAny(row.corrected, input, row.key);
        if (!narrow)
            continue;
        const auto wrong = turned_contract::turnedFault(row, input.segment, input.window);
        if (!wrong.empty())
            found(std::string(row.key) + ": " + wrong + " for "
                  + described(input.segment, input.window));
    }
    return 0;
}
