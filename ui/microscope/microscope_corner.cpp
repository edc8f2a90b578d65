// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/differences_at.h"
#include "app/teaching/quiet_corner.h"
#include "ui/look/text.h"
#include "ui/microscope/microscope_page.h"
#include "ui/microscope/microscope_view.h"
#include "ui/microscope/overview.h"
#include "ui/widgets/link_button.h"

#include <QLabel>

// What lies over the microscope's view: the overview, the line's place and links, in a corner.

namespace ui {

namespace {

constexpr QSize overviewSize(172, 130), smallOverview(116, 88), leastForOverview(400, 260);

/// Gives a label the size of its text, in more lines if it is wider than that.
void wrap(QLabel& label, int width)
{
    label.setWordWrap(false);
    const QSize whole = label.sizeHint();
    label.setWordWrap(whole.width() > width);
    label.resize(label.wordWrap() ? QSize(width, label.heightForWidth(width)) : whole);
}

} // namespace

void MicroscopePage::showPlace()
{
    const app::TracedLine& traced = session_.microscope.tracedLine();
    QStringList lines(drawn_.changed() ? Text::tr("%1, changed").arg(traced.origin)
                                       : traced.origin);
    const QString at =
        drawn_.line() ? app::atText({traced.window, traced.windowIsPage}) : QString();
    if (!at.isEmpty())
        lines << at;
    place_->setText(lines.join(u'\n'));
    place_->setVisible(!side_);
    back_->setVisible(drawn_.changed());
    placeOverview();
}

/// In a small view it would hide the line.
bool MicroscopePage::hasRoomForOverview() const
{
    return view_->width() >= leastForOverview.width()
           && view_->height() >= leastForOverview.height();
}

/// The widgets over the view, from top to bottom, below the overview.
QList<QWidget*> MicroscopePage::corner() const { return {leave_, place_, back_, fit_}; }

/// Places the widgets over the view in the corner where they hide least.
void MicroscopePage::placeOverview()
{
    overview_->setVisible(drawn_.line().has_value() && !side_ && hasRoomForOverview());
    const bool small = view_->width() < 560 || view_->height() < 360;
    const QSize size = overview_->isHidden() ? QSize(0, 0) : small ? smallOverview : overviewSize;
    fit_->setVisible(!view_->fitted());
    int width = size.width(), height = size.height();
    for (QWidget* part : corner()) {
        part == place_ ? wrap(*place_, overviewSize.width()) : part->adjustSize();
        if (part->isHidden())
            continue;
        width = std::max(width, part->width());
        height += part->height() + 4;
    }
    const QRect all = cornerFor({width, height});
    const bool atRight = corner_ == Qt::TopRightCorner || corner_ == Qt::BottomRightCorner;
    const auto left = [&](int partWidth) {
        return atRight ? all.left() + all.width() - partWidth : all.left();
    };
    overview_->setGeometry(QRect({left(size.width()), all.top()}, size));
    int y = all.top() + size.height() + 4;
    for (QWidget* part : corner()) {
        part->move(left(part->width()), y);
        y += part->isHidden() ? 0 : part->height() + 4;
    }
    if (QRectF(all) != view_->frame().reserved)
        view_->reserve(all);
    overview_->showStage(view_->frame().seen);
}

/// Keeps the current corner while the line is not there, in a gesture and in a view that was moved.
/// A fitted view depends on nothing that was before. What leaves a lesson is always at the same
/// place.
QRect MicroscopePage::cornerFor(const QSize& size)
{
    const app::Microscope& microscope = session_.microscope;
    const auto& traced = microscope.tracedLine();
    const auto& frame = view_->frame();
    if (side_)
        corner_ = Qt::TopRightCorner;
    app::CornerPlace place = app::placeIn(corner_, size, traced, microscope.narration(), frame);
    const bool stays = !view_->fitted() || view_->drags();
    if (!side_ && (!stays || place.covered >= app::hidesLine))
        place = app::quietCorner(size, traced, microscope.narration(), frame);
    corner_ = place.corner;
    return {place.box.topLeft().toPoint(), size};
}

} // namespace ui
