// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/hard_cases/case_picture_view.h"

#include "ui/look/look.h"

#include <QPainter>

namespace ui {

namespace {

constexpr int usualHeight = 250;
constexpr double stroke = 1.2; // factor of a thumbnail's stroke width

} // namespace

app::CasePictureColours casePictureColours(const QPalette& palette)
{
    const Look& look = lookOf(palette);
    return {look.paper, look.text, look.muted, look.accent, look.selection, look.differs};
}

CasePictureView::CasePictureView(QWidget* parent) : QWidget(parent) { setFixedHeight(usualHeight); }

void CasePictureView::show(const app::HardCase& hard, const std::optional<app::CaseAnswer>& answer)
{
    hard_ = &hard;
    answer_ = answer;
    update();
}

void CasePictureView::paintEvent(QPaintEvent*)
{
    if (!hard_)
        return;
    QPainter painter(this);
    painter.setFont(captionFont(font()));
    paintCasePicture(painter, rect().adjusted(1, 1, -1, -1), *hard_,
                     {casePictureColours(palette()), stroke}, answer_ ? &*answer_ : nullptr);
    painter.setPen(lookOf(palette()).rule);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

} // namespace ui

#include "moc_case_picture_view.cpp"
