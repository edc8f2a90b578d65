// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tiles/tiles_bar.h"

#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/icon_sign.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/segments.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QPushButton>

namespace ui {

TilesBar::TilesBar(QWidget* parent)
    : QWidget(parent),
      show_(new Segments(Text::tr("Show"), {Text::tr("In place"), Text::tr("Sheets apart")})),
      overlap_(new Segments(Text::tr("Overlap"), {Text::tr("Tinted"), Text::tr("Plain")}))
{
    setFixedHeight(space::optionsHeight);
    auto* sign = new IconSign("tiles", 18);
    auto* title = new QLabel(Text::tr("Tiles"));
    title->setFont(semiBold(font()));
    show_->setObjectName(QStringLiteral("tiles-arrangement"));
    overlap_->setObjectName(QStringLiteral("tiles-overlap"));
    auto* fit = new QPushButton(icon("page"), Text::tr("Fit"));
    fit->setIconSize({16, 16});
    fit->setToolTip(Text::tr("Fit all sheets into the view (double click)"));
    fit->setFocusPolicy(Qt::TabFocus);
    fit->setObjectName(QStringLiteral("fit-sheets"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(space::dockMargin, 0, space::dockMargin, 0);
    row->setSpacing(space::labelToField);
    for (QWidget* widget : std::initializer_list<QWidget*>{sign, title})
        row->addWidget(widget);
    row->addSpacing(space::betweenGroups);
    for (QWidget* widget : std::initializer_list<QWidget*>{quietLabel(Text::tr("Show")), show_})
        row->addWidget(widget);
    row->addSpacing(space::betweenGroups);
    for (QWidget* widget :
         std::initializer_list<QWidget*>{quietLabel(Text::tr("Overlap")), overlap_})
        row->addWidget(widget);
    row->addSpacing(space::betweenGroups);
    row->addWidget(fit);
    row->addStretch();
    connect(show_, &Segments::picked, this,
            [this](int chosen) { emit arranged(app::SheetArrangement(chosen)); });
    connect(overlap_, &Segments::picked, this, [this](int chosen) { emit tinted(chosen == 0); });
    connect(fit, &QPushButton::clicked, this, &TilesBar::fitWanted);
}

void TilesBar::show(app::SheetArrangement arrangement, bool tinted)
{
    show_->choose(int(arrangement));
    overlap_->choose(tinted ? 0 : 1);
}

void TilesBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), palette().window());
    painter.fillRect(0, height() - 1, width(), 1, lookOf(palette()).rule);
}

} // namespace ui

#include "moc_tiles_bar.cpp"
