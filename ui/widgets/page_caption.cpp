// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/page_caption.h"

#include "app/comparison/at_text.h"
#include "app/session/compared_text.h"
#include "ui/look/look.h"

namespace ui {

PageCaption::PageCaption(const app::Session& session, Elsewhere elsewhere, QWidget* parent)
    : QLabel(parent), session_(session), elsewhere_(elsewhere)
{
    setFont(captionFont(font()));
    setForegroundRole(QPalette::PlaceholderText);
    setContentsMargins(space::dockMargin, 0, space::dockMargin, 0);
    setWordWrap(true);
    connect(&session, &app::Session::previewChanged, this, &PageCaption::follow);
    follow();
}

void PageCaption::follow()
{
    setText(elsewhere_ == Elsewhere::AtThePage ? app::atText(session_.compared())
                                               : app::comparedText(session_));
    setHidden(text().isEmpty());
}

} // namespace ui

#include "moc_page_caption.cpp"
