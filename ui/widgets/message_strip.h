// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include <functional>
#include <optional>

namespace ui {

/// A message above the canvas, which hides none of the drawing.
struct Message {
    enum class Kind : std::uint8_t { Done, Warning };
    Kind kind = Kind::Warning;
    QString sentence;
    QString button = {}; ///< the verb of what can be done about it; empty: nothing
    std::function<void()> action = {};
};

/// The strip that shows one message, the newest, until it is closed or taken back. A warning has a
/// triangle, what was done has a tick.
class MessageStrip : public QFrame {
    Q_OBJECT

public:
    explicit MessageStrip(QWidget* parent = nullptr);

    void tell(Message message);
    void takeBackDone(); ///< closes it if it tells of something done, which is past now
    /// A warning about what was typed, over the message that is there, which comes back after it.
    void refuse(const QString& sentence);
    void withdrawRefusal(); ///< a field has taken a value
    QString sentence() const { return isHidden() ? QString() : message_.sentence; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void put(Message message);

    Message message_;
    std::optional<Message> under_; ///< while a refusal is shown: what it hides, or an empty one
    QLabel* text_;
    QPushButton* button_;
};

} // namespace ui
