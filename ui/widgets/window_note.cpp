// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/window_note.h"

#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QPainter>

namespace ui {

namespace {

constexpr int accentWidth = 4;

} // namespace

WindowNote::WindowNote(const app::Session& session) : session_(session)
{
    setContentsMargins(12, 8, 12, 8);
    setWordWrap(true);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred); // it must not widen the window
    connect(&session.document, &app::EditedDocument::changed, this,
            [this](const app::DocumentChange& change) {
                if (change.windows && !change.everything && isVisible())
                    emit learnt();
            });
    connect(&session, &app::Session::previewChanged, this, &WindowNote::follow);
    connect(&session, &app::Session::loaded, this, &WindowNote::follow);
    follow();
}

void WindowNote::follow()
{
    const QString first =
        session_.clipWindow()
            ? Text::tr("<b>Drag the clip window,</b> or draw one (W).")
            : Text::tr("<b>Draw a clip window (W),</b> or press <i>Lay window on page</i>.");
    setText(first + u' ' + Text::tr("What it removes is cut at every frame."));
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

#include "moc_window_note.cpp"
