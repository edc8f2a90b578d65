// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/question.h"
#include "app/teaching/line_text.h"

#include <QCoreApplication>

#include <glm/geometric.hpp>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("questions", text); }

/// "ask visible": is anything left of the line? What `exact` says.
std::optional<Question> ask(const Specimen& specimen, const Walk&, std::size_t, const QStringList&)
{
    const auto piece = clipped(exactClipper(), specimen.line, specimen.window);
    const QString reason =
        !piece ? tr("No point of the line lies inside the window.")
        : *piece == specimen.line
            ? tr("Both ends lie inside, and a window is convex: the whole line does.")
            : tr("What is left runs from %1 to %2.")
                  .arg(pairText(shortText(piece->a.x), shortText(piece->a.y)),
                       pairText(shortText(piece->b.x), shortText(piece->b.y)));
    return Question{tr("Is any part of this line visible in the window?"),
                    {tr("Yes, some or all of it"), tr("No, nothing")},
                    piece ? 0 : 1,
                    reason};
}

} // namespace

extern const QuestionKind visibleQuestion;
const QuestionKind visibleQuestion{"visible", ask};

} // namespace app
