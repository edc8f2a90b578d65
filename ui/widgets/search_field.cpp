// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/search_field.h"

#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QAction>
#include <QKeyEvent>
#include <QLabel>

namespace ui {

SearchField::SearchField(const QString& what, QWidget* parent)
    : QLineEdit(parent), result_(new QLabel(this))
{
    setPlaceholderText(what);
    setAccessibleName(what);
    auto* sign = new QAction(icon("zoom"), what, this);
    sign->setEnabled(false);
    addAction(sign, QLineEdit::LeadingPosition);
    result_->setFont(captionFont(font()));
    result_->setForegroundRole(QPalette::PlaceholderText);
    result_->setAttribute(Qt::WA_TransparentForMouseEvents);
    result_->hide();
}

void SearchField::showResult(const QString& count)
{
    result_->setText(count);
    result_->setVisible(!count.isEmpty());
    // Screen readers read a new description of what has the focus.
    setAccessibleDescription(count.isEmpty() ? QString() : Text::tr("found: %1").arg(count));
    place();
}

void SearchField::place()
{
    constexpr int gap = 6;
    const QSize size = result_->sizeHint();
    result_->setGeometry(width() - size.width() - gap, 0, size.width(), height());
    setTextMargins(0, 0, result_->isHidden() ? 0 : size.width() + gap, 0);
}

void SearchField::resizeEvent(QResizeEvent* event)
{
    QLineEdit::resizeEvent(event);
    place();
}

void SearchField::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Escape:
        if (text().isEmpty())
            return event->ignore();
        return clear();
    case Qt::Key_Down:
    case Qt::Key_Return:
    case Qt::Key_Enter:
        emit left();
        return;
    default:
        QLineEdit::keyPressEvent(event);
    }
}

} // namespace ui

#include "moc_search_field.cpp"
