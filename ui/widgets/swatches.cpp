// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/swatches.h"

#include "app/session/recent_colours.h"
#include "ui/widgets/spoken_role.h"
#include "ui/widgets/swatch.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>

namespace ui {
namespace {

constexpr int pitch = 24, swatchSide = 18,
              swatchInset = (pitch - swatchSide) / 2; // logical pixels

} // namespace

Swatches::Swatches(const QString& name, int columns, int rows, QWidget* parent)
    : QWidget(parent), name_(name), columns_(columns), rows_(rows)
{
    setSpokenRole(*this, QAccessible::ColorChooser);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(name);
}

void Swatches::setRows(int rows)
{
    rows_ = rows;
    updateGeometry();
}

void Swatches::setColours(std::vector<app::Colour> colours)
{
    colours.resize(std::min(colours.size(), std::size_t(columns_) * std::size_t(rows_)));
    if (colours == colours_)
        return;
    colours_ = std::move(colours);
    marked_.reset();
    at_ = 0;
    setFocusPolicy(colours_.empty() ? Qt::NoFocus : Qt::StrongFocus);
    tell();
}

void Swatches::mark(const std::optional<app::Colour>& colour)
{
    const auto found = colour ? std::ranges::find(colours_, *colour) : colours_.end();
    marked_.reset();
    if (found != colours_.end())
        at_ = *(marked_ = std::size_t(found - colours_.begin()));
    tell();
}

bool Swatches::has(const app::Colour& colour) const
{
    return std::ranges::find(colours_, colour) != colours_.end();
}

QRect Swatches::squareOf(std::size_t colour) const
{
    const int row = int(colour) / columns_, column = int(colour) % columns_;
    return {column * pitch + swatchInset, row * pitch + swatchInset, swatchSide, swatchSide};
}

QSize Swatches::sizeHint() const { return {columns_ * pitch, rows_ * pitch}; }

std::optional<std::size_t> Swatches::colourAt(const QPointF& place) const
{
    const int column = int(place.x()) / pitch, row = int(place.y()) / pitch;
    const auto colour = std::size_t(row * columns_ + column);
    if (!rect().contains(place.toPoint()) || column >= columns_ || colour >= colours_.size())
        return std::nullopt;
    return colour;
}

void Swatches::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    for (std::size_t i = 0; i < colours_.size(); ++i) {
        const QRect square = squareOf(i);
        paintSwatch(painter, square, colours_[i], look);
        const bool focused = hasFocus() && i == at_;
        if (!focused && i != marked_)
            continue;
        painter.setPen(QPen(look.selection, focused ? 2 : 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(focused ? square.adjusted(-2, -2, 2, 2) : square.adjusted(-2, -2, 1, 1));
    }
}

void Swatches::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    if (const auto colour = colourAt(event->position())) {
        goTo(*colour);
        emit picked(app::Colour(colours_[*colour]));
    }
}

void Swatches::goTo(std::size_t colour)
{
    at_ = colour;
    tell();
}

/// While it has the keyboard, its name tells the colour that Enter picks.
void Swatches::tell()
{
    const bool chooses = hasFocus() && at_ < colours_.size();
    setAccessibleName(chooses ? QStringLiteral("%1: %2").arg(name_, app::hexText(colours_[at_]))
                              : name_);
    update();
}

void Swatches::keyPressEvent(QKeyEvent* event)
{
    if (colours_.empty())
        return QWidget::keyPressEvent(event);
    const int key = event->key(), last = int(colours_.size()) - 1;
    const auto go = [&](int by) {
        const int to = int(at_) + by;
        if (to >= 0 && to <= last)
            goTo(std::size_t(to));
    };
    if (key == Qt::Key_Left || key == Qt::Key_Right)
        go(key == Qt::Key_Left ? -1 : 1);
    else if (key == Qt::Key_Up || key == Qt::Key_Down)
        go(key == Qt::Key_Up ? -columns_ : columns_);
    else if (key == Qt::Key_Home || key == Qt::Key_End)
        goTo(std::size_t(key == Qt::Key_Home ? 0 : last));
    else if (key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space)
        emit picked(app::Colour(colours_[at_]));
    else
        QWidget::keyPressEvent(event);
}

void Swatches::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    tell();
}

void Swatches::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    tell();
}

bool Swatches::event(QEvent* event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto& help = static_cast<const QHelpEvent&>(*event);
    const auto colour = colourAt(help.pos());
    QToolTip::showText(help.globalPos(), colour ? app::hexText(colours_[*colour]) : QString(),
                       this);
    return true;
}

} // namespace ui

#include "moc_swatches.cpp"
