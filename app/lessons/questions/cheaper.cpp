// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/lessons/question.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

struct Operation {
    const char* word; ///< as written in lessons
    const char* name;
    std::uint64_t clipping::OperationCounts::*count;
};
constexpr std::array operations{Operation{"divisions", QT_TRANSLATE_NOOP("Text", "divisions"),
                                          &clipping::OperationCounts::divisions},
                                Operation{"multiplications",
                                          QT_TRANSLATE_NOOP("Text", "multiplications"),
                                          &clipping::OperationCounts::multiplications},
                                Operation{"comparisons", QT_TRANSLATE_NOOP("Text", "comparisons"),
                                          &clipping::OperationCounts::comparisons},
                                Operation{"additions", QT_TRANSLATE_NOOP("Text", "additions"),
                                          &clipping::OperationCounts::additions}};

/// "ask cheaper divisions cs nln": which of two algorithms needs fewer of these operations for the
/// line.
std::optional<Question> askCheaper(const TracedLine& tracedLine, const Narration&, std::size_t,
                                   const QStringList& words)
{
    if (words.size() != 3)
        return std::nullopt;
    const auto operation = std::ranges::find_if(
        operations, [&](const Operation& o) { return words[0] == QLatin1StringView(o.word); });
    const auto one = findVariant(words[1]), other = findVariant(words[2]);
    if (operation == operations.end() || !one || !other)
        return std::nullopt;
    const auto count = [&](const Variant& variant) {
        return functionsOf(variant).count({&tracedLine.line, 1}, tracedLine.window)
               .*(operation->count);
    };
    const auto ofOne = count(*one), ofOther = count(*other);
    const QString what = Text::tr(operation->name);
    return Question{
        Text::tr("Which algorithm needs fewer %1 for this line?").arg(what),
        {nameOf(*one), nameOf(*other), Text::tr("Both need the same number, at least one"),
         Text::tr("Neither needs any")},
        ofOne < ofOther   ? 0
        : ofOther < ofOne ? 1
        : ofOne > 0       ? 2
                          : 3,
        Text::tr("Number of %5: %1 %2, %3 %4.")
            .arg(nameOf(*one))
            .arg(ofOne)
            .arg(nameOf(*other))
            .arg(ofOther)
            .arg(what),
        Text::tr("What must each algorithm compute before it can decide about this line? "
                 "Count these operations.")};
}

} // namespace

extern const QuestionKind cheaperQuestion;
const QuestionKind cheaperQuestion{
    "cheaper", askCheaper, Covered::AllSteps, 4,
    QT_TRANSLATE_NOOP("Text", "an operation and two algorithms, such as “divisions cs nln”")};

} // namespace app
