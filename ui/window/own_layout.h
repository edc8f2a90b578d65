// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QScopedValueRollback>

class QDockWidget;
class QMainWindow;

namespace ui {

/// Whether the person has moved panels of a window, and the settings that keep such a layout. The
/// program never rearranges it.
class OwnLayout : public QObject {
    Q_OBJECT

public:
    explicit OwnLayout(QMainWindow& window);

    /// Notices from now on when the person moves this dock.
    void watch(const QDockWidget& dock);

    bool exists() const { return exists_; }
    void forget() { exists_ = false; }

    /// While this lives, docks are moved by the program, not by the person.
    [[nodiscard]] QScopedValueRollback<bool> byProgram()
    {
        return QScopedValueRollback<bool>(byProgram_, true);
    }
    bool isByProgram() const { return byProgram_; }

    QByteArray state() const; ///< where docks and bars are now
    /// Stores in the settings whether the layout is the person's own, and if so, `state`.
    void save(const QByteArray& state) const;
    void restore();

private:
    void notice();

    QMainWindow& window_;
    bool exists_ = false;
    bool byProgram_ = false;
};

} // namespace ui
