// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/question.h"

#include <array>

namespace app {

// Each is defined in the file of its kind.
extern const QuestionKind partQuestion;
extern const QuestionKind visibleQuestion;
extern const QuestionKind regionQuestion;
extern const QuestionKind nextQuestion;
extern const QuestionKind edgeQuestion;
extern const QuestionKind edgesQuestion;
extern const QuestionKind cornersQuestion;
extern const QuestionKind cheaperQuestion;
extern const QuestionKind rightQuestion;

// THE CATALOGUE. To add a kind of question: write its file here, and add its line.
std::span<const QuestionKind> questionKinds()
{
    // clang-format off
    static const std::array all{
        partQuestion,
        visibleQuestion,
        regionQuestion,
        nextQuestion,
        edgeQuestion,
        edgesQuestion,
        cornersQuestion,
        cheaperQuestion,
        rightQuestion,
    };
    // clang-format on
    return all;
}

} // namespace app
