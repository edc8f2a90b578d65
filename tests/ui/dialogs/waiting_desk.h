// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/in_background.h"

#include <QApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QSemaphore>
#include <QTest>

#include <atomic>
#include <vector>

using ui::InBackground;
using Cancel = InBackground::Cancel;

inline ui::WaitingDialog* shownDialog()
{
    for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* dialog = qobject_cast<ui::WaitingDialog*>(widget); dialog && dialog->isVisible())
            return dialog;
    return nullptr;
}

inline void clickCancel()
{
    QTRY_VERIFY(shownDialog());
    QTest::mouseClick(shownDialog()->findChild<QPushButton*>(), Qt::LeftButton);
}

/// Work that ends when the test lets it, or when it reads a stop request.
class Gate {
public:
    Gate() = default;
    ~Gate() { open_->release(100); } // otherwise the end of the program would wait for the work
    Q_DISABLE_COPY_MOVE(Gate)

    auto work(int result) const
    {
        return [open = open_, result](const app::Follower& follower) {
            while (!open->tryAcquire(1, 1))
                if (follower.stop.stop_requested())
                    return -1;
            return result;
        };
    }
    /// Work that reads no stop request.
    auto deafWork(std::shared_ptr<std::atomic<int>> ended) const
    {
        return [begun = begun_, open = open_, ended](const app::Follower&) {
            begun->release();
            open->acquire();
            return ++*ended;
        };
    }
    void open() const { open_->release(); }
    bool begun() const { return begun_->tryAcquire(1, 5000); } ///< the deaf work

private:
    std::shared_ptr<QSemaphore> begun_ = std::make_shared<QSemaphore>();
    std::shared_ptr<QSemaphore> open_ = std::make_shared<QSemaphore>();
};

/// A window with a field, which gets the keys.
struct Desk {
    Desk()
    {
        window.show();
        window.activateWindow();
        field.setFocus();
    }
    auto store()
    {
        return [this](std::optional<int> result) { results.push_back(result); };
    }
    /// As the system sends it.
    void type(Qt::Key key) { QTest::keyClick(window.windowHandle(), key); }

    QWidget window;
    QLineEdit field{&window};
    InBackground background{&window};
    std::vector<std::optional<int>> results;
};

using Results = std::vector<std::optional<int>>;
