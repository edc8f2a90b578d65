// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace app {

/// What a person is doing when a digit is pressed outside fields.
struct DigitPlace {
    bool question = false;     ///< a question of a lesson is open
    bool gesture = false;      ///< something is drawn, dragged or panned
    bool numbers = false;      ///< the gesture, the finished step or the next point takes numbers
    bool draws = false;        ///< the workspace is Draw
    bool windowChosen = false; ///< of all things that can be chosen, it is a clip window
};

enum class DigitUse : std::uint8_t {
    Nothing,
    Number,    ///< begins a number of the gesture or of the finished step
    Algorithm, ///< chooses the algorithm
    Answer     ///< answers the question
};

/// The one rule for digits. A gesture takes them as its numbers, and no digit leaves it. Outside
/// gestures a digit answers an open question; otherwise it chooses the algorithm if a clip window
/// is chosen or the workspace is not Draw. What remains are numbers in Draw: those of what was just
/// drawn or transformed, and of the first point of what is drawn next.
constexpr DigitUse digitUse(const DigitPlace& place)
{
    if (place.gesture)
        return place.numbers ? DigitUse::Number : DigitUse::Nothing;
    if (place.question)
        return DigitUse::Answer;
    if (place.windowChosen || !place.draws)
        return DigitUse::Algorithm;
    return place.numbers ? DigitUse::Number : DigitUse::Nothing;
}

} // namespace app
