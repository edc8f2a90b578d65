// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/lesson.h"

#include <span>
#include <variant>

namespace app {

/// A question of a lesson. The library computes every answer from the page's traced line, so that
/// none can be wrong.
struct Question {
    QString prompt;
    QStringList choices; ///< three to five, all different, so that two tries are no guarantee
    int right = 0;       ///< index into the choices
    QString reason;      ///< why it is right, shown after the answer
    QString hint;        ///< shown after a wrong first answer: the way to the answer
    /// The part of the figure that each choice is: an edge of the window, or a piece of the line.
    /// Empty: the choices are no parts of the figure.
    std::vector<std::variant<clipping::Edge, clipping::Segment>> parts{};
    /// The hint on a page that shows no pseudo-code or no variables; empty: the same.
    QString hintWithoutCode{};
};

/// The steps that would reveal the answer and are hidden while the question is open.
enum class Covered : std::uint8_t { AllSteps, LaterSteps };

/// One kind of question: a file in questions/ and a line in questions/catalogue.cpp.
struct QuestionKind {
    std::string_view key; ///< as written in lessons: "region"
    /// Empty if this page does not allow such a question, or if the words are wrong.
    std::optional<Question> (*ask)(const TracedLine& tracedLine, const Narration& narration,
                                   std::size_t step, const QStringList& words);
    Covered covered;   ///< LaterSteps: the steps after the current one
    int choices;       ///< how many the question has
    const char* needs; ///< what `ask` needs, to follow "needs": "a line …"; to be translated
};
std::span<const QuestionKind> questionKinds();

std::optional<Question> questionOf(const LessonPage& page, const Narration& narration,
                                   std::size_t step);
/// The number of choices of a question; 0 if there is no question of its kind.
int choicesOf(const QuestionSpec& question);
/// What a question of its kind needs to be asked, to follow "needs"; empty if there is no such
/// kind.
QString needOf(const QuestionSpec& question);
/// The number of steps that are visible while the page's question is open.
std::size_t stepsShown(const LessonPage& page, std::size_t step);

/// Puts the choices in an order that does not reveal the right one, but is always the same.
Question shuffled(Question question);

} // namespace app
