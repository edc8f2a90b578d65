// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/properties/style_popup.h"

#include "app/base/numbers.h"
#include "app/session/session.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>

namespace ui {
namespace {

QString titleFor(const app::ObjectRanges& selection)
{
    return selection.empty() ? Text::tr("Style of new objects")
           : selection.size() == 1
               ? Text::tr("Style of 1 object")
               : Text::tr("Style of %1 objects").arg(app::countText(selection.size()));
}

} // namespace

StylePopup::StylePopup(app::Session& session, Canvas& canvas, QWidget* parent)
    : Popup(Text::tr("Style"), parent), session_(session), canvas_(canvas), title_(new QLabel),
      panel_(new StylePanel(session, canvas))
{
    setObjectName(QStringLiteral("style-popup"));
    title_->setFont(semiBold(font()));
    title_->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin, 0);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->setSizeConstraint(QLayout::SetFixedSize);
    column->addWidget(title_);
    column->addWidget(panel_);
    connect(panel_, &StylePanel::eyedropperStarted, this, &QWidget::close);
}

void StylePopup::open(QWidget& below)
{
    title_->setText(titleFor(session_.selection()));
    panel_->follow(); // so that it opens in its size
    openBelow(below);
    panel_->focusFirst();
}

void StylePopup::keyPressEvent(QKeyEvent* event)
{
    // A bare X server has no bindings for standard keys.
    const bool control = event->modifiers() & Qt::ControlModifier;
    const bool shift = event->modifiers() & Qt::ShiftModifier;
    if (control && !shift && event->key() == Qt::Key_Z)
        canvas_.undo();
    else if (control && (event->key() == Qt::Key_Z || event->key() == Qt::Key_Y))
        canvas_.redo();
    else
        Popup::keyPressEvent(event);
}

void StylePopup::closeEvent(QCloseEvent* event)
{
    Popup::closeEvent(event);
    canvas_.setFocus();
}

} // namespace ui

#include "moc_style_popup.cpp"
