// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMap>
#include <QObject>
#include <QScopedValueRollback>

class QDockWidget;
class QMainWindow;

namespace ui {

/// The layouts that the person has made by moving panels, one for each workspace, and the settings
/// that keep them. The program never rearranges them.
class OwnLayout : public QObject {
    Q_OBJECT

public:
    explicit OwnLayout(QMainWindow& window);

    /// Notices from now on when the person moves this dock.
    void watch(const QDockWidget& dock);

    bool exists() const { return exists_; } ///< for the chosen workspace
    void forget() { exists_ = false; }
    /// Keeps the layout of the workspace before, and shows that of this one if there is one.
    void choose(const QString& workspace);

    /// While this lives, docks are moved by the program, not by the person.
    [[nodiscard]] QScopedValueRollback<bool> byProgram()
    {
        return QScopedValueRollback<bool>(byProgram_, true);
    }
    bool isByProgram() const { return byProgram_; }

    QByteArray state() const; ///< which docks are open, and where docks and bars are now
    /// Stores the layouts in the settings; `state` is where docks and bars are, or were.
    void save(const QByteArray& state);
    void restore(const QString& workspace);

private:
    void notice();
    void keep(const QByteArray& state);
    void show();
    QList<QDockWidget*> docks() const;

    QMainWindow& window_;
    QString workspace_;
    QMap<QString, QByteArray> layouts_; ///< of workspaces
    bool exists_ = false;
    bool byProgram_ = false;
};

} // namespace ui
