// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/question.h"

#include <QCoreApplication>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("questions", text); }

/// "ask direction": whether x grows from End 1 to End 2.
std::optional<Question> ask(const TracedLine& tracedLine, const Narration&, std::size_t,
                            const QStringList& words)
{
    const double dx = tracedLine.line.b.x - tracedLine.line.a.x;
    if (!words.isEmpty())
        return std::nullopt;
    return Question{tr("How does x change from End 1 to End 2?"),
                    {tr("It grows"), tr("It shrinks"), tr("It stays the same")},
                    dx > 0   ? 0
                    : dx < 0 ? 1
                             : 2,
                    tr("x2 - x1 is %1.").arg(dx),
                    tr("Compare x1 and x2.")};
}

} // namespace

extern const QuestionKind directionQuestion;
const QuestionKind directionQuestion{"direction", ask, Covered::AllSteps};

} // namespace app
