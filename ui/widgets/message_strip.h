// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include <functional>
#include <optional>

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

/// The strip that shows one message, the newest, until it is closed or withdrawn. A warning has a
/// triangle, a Done message a tick.
class MessageStrip : public QFrame {
    Q_OBJECT

public:
    explicit MessageStrip(QWidget* parent = nullptr);

    void tell(Message message);
    void closeDone(); ///< closes a Done message, because it is outdated
    /// Shows a warning about typed text in place of the current message, which returns afterwards.
    void refuse(const QString& sentence);
    void withdrawRefusal(); ///< a field has accepted a value
    QString sentence() const { return isHidden() ? QString() : message_.sentence; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void put(Message message);

    Message message_;
    /// The message that a refusal replaces, possibly an empty text; nullopt: no refusal is shown.
    std::optional<Message> under_;
    QLabel* text_;
    QPushButton* button_;
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
