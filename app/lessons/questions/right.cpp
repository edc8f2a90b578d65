// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/difference.h"
#include "app/lessons/question.h"

#include <QCoreApplication>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("questions", text); }

/// "ask right": whether what this form finds is what there is, within the contract's ulps.
std::optional<Question> ask(const Specimen& specimen, const Walk& walk, std::size_t,
                            const QStringList&)
{
    const Clipper exact = exactClipper();
    const double ulps = contractUlps(specimen.clipper, exact);
    const auto found =
        differences({&specimen.line, 1}, specimen.window, specimen.clipper, exact, ulps);
    QString reason = tr("It finds what exact arithmetic finds, but for rounding.");
    if (walk.outcome == clipping::Outcome::DidNotEnd)
        reason = tr("It goes round for ever; the program had to stop it.");
    else if (!found.empty() && found[0].kind == Difference::Kind::OnlyA)
        reason = tr("It shows a piece, although no point of the line is inside the window.");
    else if (!found.empty() && found[0].kind == Difference::Kind::OnlyB)
        reason = tr("It shows nothing, although part of the line is inside the window.");
    else if (!found.empty())
        reason = tr("An end that it finds is off by %1 units in the last place.")
                     .arg(shortText(found[0].ulps));
    return Question{tr("Will what %1 finds be right?").arg(nameOf(specimen.clipper)),
                    {tr("Yes, but for rounding"), tr("No")},
                    found.empty() && walk.outcome != clipping::Outcome::DidNotEnd ? 0 : 1,
                    reason};
}

} // namespace

extern const QuestionKind rightQuestion;
const QuestionKind rightQuestion{"right", ask};

} // namespace app
