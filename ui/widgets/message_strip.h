// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include <functional>

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
    QString sentence() const { return isHidden() ? QString() : message_.sentence; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Message message_;
    QLabel* text_;
    QPushButton* button_;
};

} // namespace ui
