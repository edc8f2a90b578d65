// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/style_popup.h"

#include "ui/look/look.h"
#include "ui/widgets/popup_place.h"

#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>

namespace ui {

StylePopup::StylePopup(app::Session& session, Canvas& canvas, QWidget& below)
    : QFrame(&below, Qt::Popup), canvas_(canvas), below_(below),
      panel_(new StylePanel(session, canvas))
{
    setObjectName(QStringLiteral("style-popup"));
    setAccessibleName(tr("Style"));
    setFrameShape(QFrame::StyledPanel);
    auto* title = new QLabel;
    title->setFont(semiBold(font()));
    title->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin, 0);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->setSizeConstraint(QLayout::SetFixedSize);
    column->addWidget(title);
    column->addWidget(panel_);
    connect(panel_, &StylePanel::titled, title,
            [title](const QString& remark) { title->setText(tr("Style %1").arg(remark)); });
    connect(panel_, &StylePanel::eyedropperStarted, this, &QWidget::close);
}

void StylePopup::open()
{
    move(placeBelow(below_, sizeHint()));
    show();
    panel_->focusFirst();
}

void StylePopup::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape)
        close();
    else
        QFrame::keyPressEvent(event);
}

void StylePopup::closeEvent(QCloseEvent* event)
{
    QFrame::closeEvent(event);
    canvas_.setFocus();
}

} // namespace ui
