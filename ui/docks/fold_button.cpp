// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/fold_button.h"

#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QKeyEvent>

namespace ui {

FoldButton::FoldButton()
{
    setAutoRaise(true);
    setIconSize({16, 16});
    setFixedSize(20, 22);
    connect(this, &QToolButton::clicked, this, &FoldButton::press);
}

void FoldButton::show(bool folded, const QString& section)
{
    folded_ = folded;
    setIcon(ui::icon(folded ? "chevron-right" : "chevron-down"));
    setToolTip((folded ? Text::tr("Unfold %1") : Text::tr("Fold %1")).arg(section));
    setAccessibleName(toolTip()); // which says the state, too
}

void FoldButton::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
        return press();
    case Qt::Key_Left:
    case Qt::Key_Right:
        if (folded_ == (event->key() == Qt::Key_Right))
            press();
        return;
    default:
        QToolButton::keyPressEvent(event);
    }
}

} // namespace ui

#include "moc_fold_button.cpp"
