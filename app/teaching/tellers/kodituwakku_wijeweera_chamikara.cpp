// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/tellers/ends.h"

#include <QCoreApplication>

namespace app {

using clipping::Edge;

namespace {

QString tr(const char* text)
{
    return QCoreApplication::translate("kodituwakku-wijeweera-chamikara", text);
}

bool isPublished(const Telling& telling)
{
    return telling.specimen.clipper.form == clipping::Form::Published;
}
int endNamed(const Telling& telling) { return telling.value("i") == 2.0 ? 2 : 1; }

QString direction(const Telling& telling)
{
    const auto& [a, b] = telling.specimen.line;
    if (telling.step.line == 1)
        return telling.holds()
                   ? tr("The line is vertical (x1 = x2 = %1): y = mx + c cannot say it.")
                         .arg(words::number(a.x))
                   : tr("The line is not vertical (%1).").arg(words::compared(a.x, b.x));
    return telling.holds() ? tr("The line is horizontal (y1 = y2 = %1).").arg(words::number(a.y))
                           : tr("The line is not horizontal (%1).").arg(words::compared(a.y, b.y));
}

/// Whether a horizontal or vertical line, or a point, lies between the edges.
QString between(const Telling& telling)
{
    const auto& [a, b] = telling.specimen.line;
    const auto& [min, max] = telling.specimen.window;
    const glm::length_t axis = telling.step.line == 31 ? 0 : 1;
    if (telling.step.line == 40)
        return telling.holds()
                   ? tr("The line is a single point, %1, and it counts as outside.")
                         .arg(words::point(a))
                   : tr("The line is a single point, %1, and it is inside.").arg(words::point(a));
    const QString ground =
        axis == 0 ? tr("x1 = %1, xmin = %2, xmax = %3") : tr("y1 = %1, ymin = %2, ymax = %3");
    const QString numbers =
        ground.arg(words::number(a[axis]), words::number(min[axis]), words::number(max[axis]));
    if (!telling.holds())
        return tr("The line runs between the two edges (%1).").arg(numbers);
    const bool onEdge = a[axis] == min[axis] || a[axis] == max[axis];
    return onEdge ? tr("The line runs along an edge (%1); as published, that counts as outside.")
                        .arg(numbers)
                  : tr("The line runs outside, beside the window (%1).").arg(numbers);
}

QString tooShort(const Telling& telling)
{
    const auto& [a, b] = telling.step.segment;
    const bool vertical = telling.step.line == 39;
    const double length = vertical ? std::abs(a.y - b.y) : std::abs(a.x - b.x);
    const QString name =
        vertical ? QStringLiteral("|y1 \u2212 y2|") : QStringLiteral("|x1 \u2212 x2|");
    if (std::isnan(length))
        return tr("Now %1 is no number, which no comparison calls less than 1: the line is drawn.")
            .arg(name);
    return telling.holds()
               ? tr("Now %1 = %2, less than 1. The authors take that for a line that has shrunk to "
                    "a "
                    "point, because it misses the window.")
                     .arg(name, words::number(length))
               : tr("Now %1 = %2, not less than 1: the line has not shrunk to a point, so it meets "
                    "the window.")
                     .arg(name, words::number(length));
}

QString other(const Telling& telling)
{
    return telling.holds()
               ? tr("The other end lies %1, too.")
                     .arg(words::beyond(telling.edge(), telling.specimen.y))
               : tr("The other end does not lie %1: the line crosses %2.")
                     .arg(words::beyond(telling.edge(), telling.specimen.y), telling.edgeText());
}

/// Whether an end must be pushed. After a first push the corrected form asks how far it has gone.
QString push(const Telling& telling)
{
    const int end = endNamed(telling);
    if (telling.value("gap")) {
        const QString name = telling.holds() ? tr("%1 has come to lie %2 (%3)")
                                             : tr("%1 has not come to lie %2 (%3)");
        return tr("%1.").arg(
            name.arg(words::end(end), words::beyond(telling.edge(), telling.specimen.y),
                     words::compared(*telling.value("rise"), *telling.value("gap"))));
    }
    return telling.holds() ? tr("%1, so it is pushed to %2.")
                                 .arg(words::whetherBeyond(telling, end), telling.edgeText())
                           : tr("%1.").arg(words::whetherBeyond(telling, end));
}

QString test(const Telling& telling)
{
    switch (telling.step.line) {
    case 1:
    case 2:
        return direction(telling);
    case 21:
    case 31:
    case 40:
        return between(telling);
    case 19:
    case 29:
    case 39:
        return tooShort(telling);
    default:
        return telling.value("i") ? push(telling) : other(telling);
    }
}

QString cut(const Telling& telling)
{
    const int end = endNamed(telling);
    return tr("%1 moves along the line to %2, to %3.")
        .arg(words::end(end), telling.edgeText(), words::point(words::endOf(end, telling)));
}

QString number(const Telling& telling)
{
    const auto& name = telling.step.name;
    if (name == "m")
        return tr("The slope of the line: m = %1.").arg(words::value(telling, "m"));
    if (name == "c")
        return tr("Where the line meets the y axis: c = %1. From here on the line is y = mx + c.")
            .arg(words::value(telling, "c"));
    if (name == "dx, dy")
        return tr("The slope stays a fraction: dy = %2 over dx = %1, so that nothing is rounded "
                  "yet.")
            .arg(words::value(telling, "dx"), words::value(telling, "dy"));
    if (name == "rise")
        return tr("On its way to %1 the end moves by %2 in y.")
            .arg(telling.edgeText(), words::value(telling, "rise"));
    return tr("On its way to %1 the end moves by %2 in x.")
        .arg(telling.edgeText(), words::value(telling, "run"));
}

QString reject(const Telling& telling)
{
    if (telling.edge() != Edge::None)
        return tr("Both ends would have to be pushed to %1 from outside: the line misses the "
                  "window.")
            .arg(telling.edgeText());
    return tr("The line is rejected: nothing of it is taken for visible.") + words::lost(telling);
}

QString sentence(const Telling& telling)
{
    const auto what = telling.step.what;
    if (what == clipping::What::Test)
        return test(telling);
    if (what == clipping::What::Cut)
        return cut(telling);
    if (what == clipping::What::Reject)
        return isPublished(telling) || telling.edge() != Edge::None
                   ? reject(telling)
                   : tr("Nothing of the line is visible.");
    if (what == clipping::What::Accept)
        return words::acceptedIfInside(telling);
    return number(telling);
}

} // namespace

extern const Teller kodituwakkuWijeweeraChamikaraTeller;
const Teller kodituwakkuWijeweeraChamikaraTeller{"kodituwakku-wijeweera-chamikara", sentence};

} // namespace app
