// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/line_field.h"

#include "app/teaching/line_text.h"
#include "ui/look/text.h"

#include <QKeyEvent>

namespace ui {

LineField::LineField(QWidget* parent) : QLineEdit(parent)
{
    setAccessibleName(Text::tr("Line"));
    setTextMargins(6, 0, 4, 0);
    setToolTip(Text::tr("Type a line as x1, y1 to x2, y2"));
    connect(this, &QLineEdit::returnPressed, this, &LineField::read);
}

void LineField::show(const clipping::Segment& line)
{
    line_ = line;
    if (hasFocus() && isModified())
        return; // the user is typing
    setText(app::lineText(line));
    setCursorPosition(0);
}

void LineField::read()
{
    if (!isModified())
        return;
    const auto line = app::lineFrom(text());
    if (!line) {
        emit refused(
            Text::tr("Line: \"%1\" is not a line. Type four numbers, such as 10, 20 to 70, 130.")
                .arg(text().trimmed()));
        selectAll();
        return;
    }
    setModified(false);
    emit typed(*line);
    show(*line);
    emit done();
}

/// The field handles Esc while its text is changed.
bool LineField::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress)
        if (static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && isModified()) {
            if (event->type() == QEvent::KeyPress) {
                setModified(false);
                show(line_);
                selectAll();
            }
            event->accept();
            return true;
        }
    return QLineEdit::event(event);
}

void LineField::focusOutEvent(QFocusEvent* event)
{
    QLineEdit::focusOutEvent(event);
    if (event->reason() == Qt::PopupFocusReason)
        return;
    setModified(false);
    show(line_);
}

} // namespace ui

#include "moc_line_field.cpp"
