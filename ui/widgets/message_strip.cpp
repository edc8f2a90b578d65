// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/message_strip.h"

#include "app/session/session.h"
#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace ui {

MessageStrip::MessageStrip(QWidget* parent)
    : QFrame(parent), text_(new QLabel), button_(new QPushButton), answers_(new QWidget)
{
    setAccessibleName(Text::tr("Message"));
    auto* close = new QToolButton;
    close_ = close;
    close->setIcon(icon("close"));
    close->setAutoRaise(true);
    close->setToolTip(Text::tr("Close this message"));
    close->setAccessibleName(close->toolTip());
    text_->setWordWrap(true);
    text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* buttons = new QHBoxLayout(answers_);
    buttons->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(36, 4, 8, 4);
    row->addWidget(text_, 1);
    row->addWidget(button_);
    row->addWidget(answers_);
    row->addWidget(close);
    connect(close, &QToolButton::clicked, this, [this] { under_ ? withdrawRefusal() : tell({}); });
    connect(button_, &QPushButton::clicked, this, [this] {
        const auto action = message_.action;
        tell({});
        if (action)
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
    const Message before = under_.value_or(message_);
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
    showNow();
}

void MessageStrip::showNow()
{
    const QString& sentence = asks() ? questions_.back().question.sentence : message_.sentence;
    text_->setText(sentence);
    button_->setText(message_.button);
    button_->setVisible(!asks() && !message_.button.isEmpty());
    answers_->setVisible(asks());
    close_->setVisible(!asks());
    setVisible(!sentence.isEmpty());
    QAccessibleEvent event(text_, QAccessible::Alert);
    QAccessible::updateAccessibility(&event);
    update();
}

void MessageStrip::closeDone()
{
    if (under_ && under_->kind == Message::Kind::Done)
        under_ = Message{};
    if (message_.kind == Message::Kind::Done)
        put({});
}

int MessageStrip::ask(StripQuestion question)
{
    if (!asks())
        focusBefore_ = window()->focusWidget();
    questions_.push_back({++asked_, std::move(question)});
    showAnswers();
    return asked_;
}

/// What an answer does may ask again, or destroy the strip.
void MessageStrip::give(int question, std::size_t answer)
{
    const auto open = std::ranges::find(questions_, question, &Asked::number);
    if (open == questions_.end())
        return;
    const auto act = open->question.answers[answer].act;
    questions_.erase(open);
    showAnswers();
    act();
}

/// Those of the question that is shown; the first one has the focus.
void MessageStrip::showAnswers()
{
    const bool hadFocus = isAncestorOf(window()->focusWidget());
    if (!asks() && hadFocus && focusBefore_)
        focusBefore_->setFocus();
    while (QLayoutItem* before = answers_->layout()->takeAt(0)) {
        before->widget()->hide();
        before->widget()->deleteLater(); // it may be handling its click
        delete before;
    }
    QWidget* first = nullptr;
    if (asks()) {
        const auto& [number, question] = questions_.back();
        for (std::size_t i = 0; i < question.answers.size(); ++i) {
            auto* button = new QPushButton(question.answers[i].text);
            answers_->layout()->addWidget(button);
            if (i == 0) {
                wearFont(*button, 1, QFont::DemiBold); // Enter presses it
                first = button;
            }
            connect(button, &QPushButton::clicked, this,
                    [this, number = number, i] { give(number, i); });
        }
    }
    showNow();
    if (first)
        first->setFocus();
}

/// The arrow keys and Tab go from button to button.
void MessageStrip::keyPressEvent(QKeyEvent* event)
{
    auto* const button = qobject_cast<QPushButton*>(window()->focusWidget());
    const bool confirms = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (asks() && event->key() == Qt::Key_Escape)
        give(questions_.back().number, questions_.back().question.answers.size() - 1);
    else if (confirms && button && isAncestorOf(button))
        button->click();
    else
        QFrame::keyPressEvent(event);
}

bool MessageStrip::isWarning() const { return asks() || message_.kind == Message::Kind::Warning; }

void MessageStrip::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    const bool warning = isWarning();
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
    setTextFormat(Qt::RichText);
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
