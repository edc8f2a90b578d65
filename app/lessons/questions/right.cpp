// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/comparison/difference.h"
#include "app/lessons/question.h"

#include <array>

namespace app {

namespace {

/// One verdict on the result of a form: the text of the choice, and the reason.
struct Verdict {
    const char* choice;
    const char* reason; ///< %1: the error in ulps
};
constexpr std::array verdicts{
    Verdict{
        QT_TRANSLATE_NOOP("Text", "Yes, apart from rounding"),
        QT_TRANSLATE_NOOP("Text", "Apart from rounding, its result is that of exact arithmetic.")},
    Verdict{QT_TRANSLATE_NOOP("Text", "No, it shows too much"),
            QT_TRANSLATE_NOOP(
                "Text", "It shows a part, although no point of the line is inside the window.")},
    Verdict{QT_TRANSLATE_NOOP("Text", "No, it shows nothing, but a part is visible"),
            QT_TRANSLATE_NOOP("Text",
                              "It shows nothing, although part of the line is inside the window.")},
    Verdict{QT_TRANSLATE_NOOP("Text", "No, an end is in the wrong place"),
            QT_TRANSLATE_NOOP(
                "Text", "One end of its result is off by %1 ulps of the largest coordinate.")},
    Verdict{QT_TRANSLATE_NOOP("Text", "No, it never ends"),
            QT_TRANSLATE_NOOP("Text",
                              "It repeats the same cuts forever. The program had to stop it.")}};

/// The index of the verdict.
int verdictOn(const Narration& narration, const std::vector<Difference>& found)
{
    if (narration.outcome == clipping::Outcome::DidNotEnd)
        return 4;
    if (found.empty())
        return 0;
    return found[0].kind == Difference::Kind::OnlyA   ? 1
           : found[0].kind == Difference::Kind::OnlyB ? 2
                                                      : 3;
}

QString promptFor(const Variant& variant)
{
    const QString name = latin(variant.algorithm->abbreviation);
    return variant.form == clipping::Form::Published
               ? Text::tr("Does the published %1 get this line right?").arg(name)
               : Text::tr("Does the corrected %1 get this line right?").arg(name);
}

/// "ask right": whether the result of this form is correct within the ulps of its contract.
std::optional<Question> askRight(const TracedLine& tracedLine, const Narration& narration,
                                 std::size_t, const QStringList&)
{
    const Variant exact = exactVariant();
    const double ulps = contractUlps(tracedLine.variant, exact);
    const auto found =
        differences({&tracedLine.line, 1}, tracedLine.window, tracedLine.variant, exact, ulps);
    const int verdict = verdictOn(narration, found);
    QString reason = Text::tr(verdicts[std::size_t(verdict)].reason);
    if (!found.empty())
        reason.replace(QStringLiteral("%1"), shortText(found[0].ulps));
    QStringList choices;
    for (const Verdict& row : verdicts)
        choices << Text::tr(row.choice);
    return Question{promptFor(tracedLine.variant), choices, verdict, reason,
                    Text::tr("Which decisions use a number that was rounded before? What happens "
                             "if that number is slightly too large or too small?")};
}

} // namespace

extern const QuestionKind rightQuestion;
const QuestionKind rightQuestion{"right", askRight, Covered::AllSteps, 5,
                                 QT_TRANSLATE_NOOP("Text", "a line that can be clipped")};

} // namespace app
