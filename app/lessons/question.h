// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/lessons/lesson.h"

#include <span>

namespace app {

/// A question that a lesson asks. Every answer is computed by the library from what the page
/// shows, so that none can be wrong.
struct Question {
    QString prompt;
    QStringList choices; ///< three to five, all different, so that a second try is no gift
    int right = 0;       ///< index into the choices
    QString reason;      ///< why it is right, said after the answer
    QString hint;        ///< said after a first wrong answer: how to find it, not what it is
};

/// Which steps would answer a question, and are covered while it is open.
enum class Covered : std::uint8_t { AllSteps, LaterSteps };

/// One kind of question: a file in questions/, and a line in questions/catalogue.cpp.
struct QuestionKind {
    std::string_view key; ///< as lessons write it: "region"
    /// Nothing: this page gives no such question, or the words are wrong.
    std::optional<Question> (*ask)(const Specimen& specimen, const Walk& walk, std::size_t step,
                                   const QStringList& words);
    Covered covered; ///< LaterSteps: those after the one that is looked at
};
std::span<const QuestionKind> questionKinds();

std::optional<Question> questionOf(const LessonPage& page, const Walk& walk, std::size_t step);
/// How many steps of the walk can be seen while the page's question is open.
std::size_t stepsShown(const LessonPage& page, std::size_t step);

/// Choices in an order that does not tell which is right, but is always the same.
Question shuffled(Question question);

} // namespace app
