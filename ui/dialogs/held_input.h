// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QEvent>
#include <QPointer>

#include <deque>
#include <memory>

namespace ui {

/// Keeps the person's input away from all windows of the program, and delivers it later in its
/// order. A modal dialog gets its own input even so.
class HeldInput : public QObject {
public:
    ~HeldInput() override;

    void hold();
    bool holding() const { return holding_; }
    void drop(); ///< forgets what is held; later input is still held
    /// Delivers what is held, and holds no more. If a hold() comes in between, the rest stays held.
    void release();

protected:
    bool eventFilter(QObject* receiver, QEvent* event) override;

private:
    struct Held {
        QPointer<QObject> receiver;
        std::unique_ptr<QEvent> event;
    };
    std::deque<Held> held_;
    bool holding_ = false;
};

} // namespace ui
