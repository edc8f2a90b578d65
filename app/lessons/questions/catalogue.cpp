// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/question.h"

#include <array>

namespace app {

// Each is defined in the file of its kind.
extern const QuestionKind visibleQuestion, regionQuestion, nextQuestion, edgeQuestion,
    cheaperQuestion, rightQuestion;

// THE CATALOGUE. To add a kind of question: write its file here, and add its line.
std::span<const QuestionKind> questionKinds()
{
    static const std::array all{visibleQuestion, regionQuestion,  nextQuestion,
                                edgeQuestion,    cheaperQuestion, rightQuestion};
    return all;
}

} // namespace app
