// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_strip.h"

#include "app/session/session.h"
#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include <utility>

namespace ui {

MessageStrip::MessageStrip(QWidget* parent)
    : QFrame(parent), text_(new QLabel), button_(new QPushButton)
{
    setAccessibleName(Text::tr("Message"));
    auto* close = new QToolButton;
    close->setIcon(icon("close"));
    close->setAutoRaise(true);
    close->setToolTip(Text::tr("Close this message"));
    close->setAccessibleName(close->toolTip());
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(36, 4, 8, 4);
    row->addWidget(text_, 1);
    row->addWidget(button_);
    row->addWidget(close);
    connect(close, &QToolButton::clicked, this, [this] { under_ ? withdrawRefusal() : hide(); });
    connect(button_, &QPushButton::clicked, this, [this] {
        hide();
        if (const auto action = message_.action)
            action();
    });
    hide();
}

void MessageStrip::tell(Message message)
{
    under_.reset();
    put(std::move(message));
}

void MessageStrip::refuse(const QString& sentence)
{
    const Message before = !under_ && !isHidden() ? message_ : under_.value_or(Message{});
    put({Message::Kind::Warning, sentence});
    under_ = before;
}

void MessageStrip::withdrawRefusal()
{
    if (under_)
        put(*std::exchange(under_, std::nullopt));
}

void MessageStrip::put(Message message)
{
    message_ = std::move(message);
    text_->setText(message_.sentence);
    button_->setText(message_.button);
    button_->setVisible(!message_.button.isEmpty());
    setVisible(!message_.sentence.isEmpty());
    QAccessibleEvent event(text_, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
    update();
}

void MessageStrip::closeDone()
{
    if (under_ && under_->kind == Message::Kind::Done)
        under_ = Message{};
    if (message_.kind == Message::Kind::Done)
        hide();
}

void MessageStrip::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    const bool warning = message_.kind == Message::Kind::Warning;
    QPainter painter(this);
    painter.fillRect(rect(), warning ? look.warningGround : look.panel);
    painter.fillRect(0, height() - 1, width(), 1, look.rule);
    QPalette textPalette = text_->palette();
    textPalette.setColor(QPalette::WindowText, warning ? look.warning : look.text);
    if (textPalette != text_->palette())
        text_->setPalette(textPalette);
    icon(warning ? "warning" : "tick").paint(&painter, QRect(10, (height() - 18) / 2, 18, 18));
}

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
    followKeys(*this, [this] { follow(); });
}

void WindowNote::follow()
{
    const QString first =
        session_.clipWindow()
            ? Text::tr("<b>Drag the clip window,</b> or draw one ({tool-window}).")
            : Text::tr(
                "<b>Draw a clip window ({tool-window}),</b> or press <i>Lay window on page</i>.");
    setText(app::withKeys(first) + u' ' + Text::tr("What it removes is cut at every frame."));
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

#include "moc_message_strip.cpp"
