// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/properties/stroke_row.h"

#include "app/drawing/dash_patterns.h"
#include "app/session/selected_texts.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/properties/dash_list.h"
#include "ui/tools/end_drag.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/length_field.h"

#include <QHBoxLayout>

namespace ui {

StrokeRow::StrokeRow(app::Session& session, Canvas& canvas, Frame frame, QWidget* parent)
    : QWidget(parent), session_(session), canvas_(canvas),
      colour_(new ColourChoice(session, canvas, &app::Style::stroke)),
      width_(new LengthField(Text::tr("Stroke width"), LengthField::Range::NotNegative,
                             LengthField::Suffix::Unit)),
      dashes_(new DashList)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(space::labelToField);
    row->addWidget(colour_);
    if (frame == Frame::Plain)
        addFill();
    addWidth(frame);
    addDashes(frame);
    connect(&session, &app::Session::selectionChanged, this, [this] {
        width_->discardTyped(); // it was for other objects
        follow();
    });
    connect(&session, &app::Session::displayChanged, this, &StrokeRow::follow);
    connect(&session, &app::Session::loaded, this, &StrokeRow::follow, Qt::QueuedConnection);
    connect(&session.document, &app::EditedDocument::changed, this, &StrokeRow::follow,
            Qt::QueuedConnection); // the selection may not be updated yet
}

void StrokeRow::addFill()
{
    fill_ = new ColourChoice(session_, canvas_, &app::Style::fill);
    colour_->setSwatch(Swatch::Ring);
    layout()->addWidget(fill_);
}

void StrokeRow::showParts()
{
    if (!fill_)
        return;
    const bool ofTexts = !app::selectedTexts(session_).empty();
    fill_->setVisible(!lineWithHandles(session_));
    width_->setVisible(!ofTexts);
    dashes_->setVisible(!ofTexts);
}

void StrokeRow::addWidth(Frame frame)
{
    width_->setToolTip(Text::tr("Stroke width"));
    const bool isPlain = frame == Frame::Plain;
    if (isPlain) {
        width_->setButtonSymbols(QAbstractSpinBox::NoButtons);
        width_->setFrame(false);
    }
    new RoomForText(*width_, QStringLiteral("00.000 mm"), isPlain ? 10 : 28);
    layout()->addWidget(width_);
    connect(width_, &LengthField::entered, this, [this] { canvas_.setFocus(); });
    connect(width_, &LengthField::edited, this, [this](double width, app::Merging merging) {
        app::restyle(
            session_, [width](app::Style& style) { app::setWidth(style, width); },
            Text::tr("Stroke width"), merging);
        follow();
    });
}

void StrokeRow::addDashes(Frame frame)
{
    dashes_->setFixedWidth(72);
    dashes_->setFrame(frame == Frame::Fields);
    layout()->addWidget(dashes_);
    connect(dashes_, &ToolList::done, this, [this] { canvas_.setFocus(); });
    connect(dashes_, &DashList::picked, this, [this](const auto& pattern) {
        app::restyle(session_, pattern, Text::tr("Dashes"), app::Merging::WithLast);
        follow();
    });
}

void StrokeRow::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    follow();
}

/// Asks nothing while it is hidden: there may be a million selected objects.
void StrokeRow::follow()
{
    if (!isVisible())
        return;
    showParts();
    const std::vector<app::Style> styles = app::shownStyles(session_);
    const app::Page& page = session_.now().page();
    const app::Unit unit = page.paperUnit(session_.display().unit);
    const double size = page.millimetresPerUnit();
    if (!width_->isBeingTyped()) {
        if (app::common(styles, &app::Style::width))
            width_->show(styles.front().width, unit, size);
        else
            width_->showMixed(styles.front().width, unit, size);
    }
    dashes_->follow(styles);
}

} // namespace ui

#include "moc_stroke_row.cpp"
