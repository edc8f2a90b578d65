// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/error_histogram.h"

#include "app/base/numbers.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/algorithm_marker.h"

#include <QPainter>

#include <algorithm>

namespace ui {

namespace {

constexpr int row = 18, besideBar = 8, barThickness = 11, leastBar = 2;

} // namespace

ErrorHistogram::ErrorHistogram(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(Text::tr("Errors"));
}

void ErrorHistogram::show(const app::ErrorCounts& counts)
{
    counts_ = counts;
    QStringList texts;
    for (std::size_t i = 0; i < counts.classes.size(); ++i)
        texts << QStringLiteral("%1: %2").arg(app::errorClasses()[i].name,
                                              app::countText(counts.classes[i]));
    setAccessibleDescription(texts.join(Text::tr(", ")));
    update();
}

QSize ErrorHistogram::sizeHint() const { return {280, row * int(app::errorClasses().size())}; }

void ErrorHistogram::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    painter.setFont(captionFont(font()));
    const QFontMetrics metrics(painter.font());
    const auto classes = app::errorClasses();
    const auto count = [&](std::size_t i) {
        return i < counts_.classes.size() ? counts_.classes[i] : 0;
    };
    int names = 0, numbers = 0;
    std::size_t most = 1;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        names = std::max(names, metrics.horizontalAdvance(classes[i].name));
        numbers = std::max(numbers, metrics.horizontalAdvance(app::countText(count(i))));
        most = std::max(most, count(i));
    }
    const int left = names + besideBar, room = width() - left - besideBar - numbers;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const int top = int(i) * row;
        painter.setPen(count(i) > 0 ? look.text : look.muted);
        painter.drawText(QRect(0, top, names, row), Qt::AlignRight | Qt::AlignVCenter,
                         classes[i].name);
        int bar = int(double(room) * double(count(i)) / double(most));
        bar = count(i) > 0 ? std::max(bar, leastBar) : 0;
        const QRect place(left, top + (row - barThickness) / 2, std::max(bar, 1), barThickness);
        painter.fillRect(place, bar > 0 ? app::errorColour(i, groundOf(palette()), look.differs)
                                        : look.rule);
        painter.drawText(QRect(left + bar + besideBar, top, numbers, row),
                         Qt::AlignLeft | Qt::AlignVCenter, app::countText(count(i)));
    }
}

} // namespace ui

#include "moc_error_histogram.cpp"
