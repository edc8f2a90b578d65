// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/window_note.h"

#include "ui/look.h"

#include <QPainter>

namespace ui {

namespace {

constexpr int accentWidth = 4;

} // namespace

WindowNote::WindowNote(const app::Session& session)
{
    setText(tr("<b>Drag the clip window,</b> or draw one (W). What it leaves out is cut, at every "
               "frame."));
    setContentsMargins(12, 8, 12, 8);
    setWordWrap(true);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // it makes no window wider
    connect(&session.document, &app::EditedDocument::changed, this,
            [this](const app::DocumentChange& change) {
                if (change.windows && !change.everything && isVisible())
                    emit learnt();
            });
}

void WindowNote::paintEvent(QPaintEvent* event)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    painter.fillRect(rect(), look.base);
    painter.fillRect(0, 0, accentWidth, height(), look.accent);
    painter.fillRect(0, height() - 1, width(), 1, look.rule);
    painter.end();
    QLabel::paintEvent(event);
}

} // namespace ui
