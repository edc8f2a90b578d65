// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPointer>
#include <QPushButton>

#include <functional>
#include <optional>
#include <vector>

namespace app {
class Session;
}

namespace ui {

/// A message over the upper edge of the drawing, whose view stays as it is.
struct Message {
    enum class Kind : std::uint8_t { Done, Warning };
    Kind kind = Kind::Warning;
    QString sentence;
    QString button = {}; ///< its text, a verb; empty: no button
    std::function<void()> action = {};
};

/// A question over the drawing, which stays alive.
struct StripQuestion {
    struct Answer {
        QString text; ///< a verb
        std::function<void()> act;
    };
    QString sentence;
    std::vector<Answer> answers; ///< the first one has the focus, the last one is that of Esc
};

/// The strip that shows one message, the newest, until it is closed or withdrawn. A warning has a
/// triangle, a Done message a tick. A question hides the message until it is answered.
class MessageStrip : public QFrame {
    Q_OBJECT

public:
    explicit MessageStrip(QWidget* parent = nullptr);

    void tell(Message message);
    void closeDone(); ///< closes a Done message, because it is outdated
    /// Shows a warning about typed text in place of the current message, which returns afterwards.
    void refuse(const QString& sentence);
    void withdrawRefusal();                                ///< a field has accepted a value
    QString sentence() const { return message_.sentence; } ///< of the message

    /// Asks, and takes the focus; returns the question's number. A question that is open waits.
    int ask(StripQuestion question);
    void give(int question, std::size_t answer); ///< nothing if it has been answered
    bool asks() const { return !questions_.empty(); }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void put(Message message);
    void showNow();
    void showAnswers();
    bool isWarning() const;

    Message message_; ///< no sentence: none
    /// The message that a refusal replaces, possibly an empty text; nullopt: no refusal is shown.
    std::optional<Message> under_;
    struct Asked {
        int number;
        StripQuestion question;
    };
    std::vector<Asked> questions_; ///< the last one is shown
    int asked_ = 0;
    QPointer<QWidget> focusBefore_; ///< the question
    QLabel* text_;
    QPushButton* button_; ///< of the message
    QWidget* close_;
    QWidget* answers_; ///< the buttons of the question
};

/// A hint above the first drawing, in a strip of its own: how to use a clip window or how to add
/// one. It stays until a clip window is changed.
class WindowNote : public QLabel {
    Q_OBJECT

public:
    explicit WindowNote(const app::Session& session);

signals:
    void learnt(); ///< a clip window was changed: never show the hint again

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void follow();

    const app::Session& session_;
};

} // namespace ui
