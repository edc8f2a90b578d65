// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/arrangement.h"
#include "ui/window/hidden_panels.h"
#include "ui/window/own_layout.h"

#include <functional>
#include <vector>

class QAction;

namespace ui {

/// Which panels a window shows, and where. The program arranges those of the chosen workspace
/// (`Arrangement`) until the person moves one (`OwnLayout`); a mode without panels hides them all
/// for a while
/// (`HiddenPanels`). Meanwhile nothing is rearranged or shown: raise(), toggle() and reset() take
/// effect, in the order of the calls, when the panels come back.
class PanelLayout : public QObject {
    Q_OBJECT

public:
    /// Adds the docks to the window.
    PanelLayout(QMainWindow& window, const PanelDocks& docks);

    const Workspace& workspace() const { return *workspace_; }
    void choose(const Workspace& workspace);

    QList<QAction*> toggles() const; ///< of all panels except Start, which is shown automatically
    /// Brings a panel to the front, and opens it first if it is a closed comparison panel.
    void raise(const QString& key);
    /// Opens a comparison panel, or closes it if it is in front.
    void toggle(const QString& key);
    bool shows(const QString& key) const; ///< possibly behind another tab

    void showStart();
    void leaveStart(); ///< shows the working panels; nothing happens if Start is not wanted
    void fit();        ///< the window has another size, or a panel needs another height
    void reset();      ///< forgets the person's own layout and folds

    void hideAll();
    void bringBack(); ///< nothing happens if the panels are not hidden

    void save();    ///< to the settings; if the panels are hidden, the layout before that
    void restore(); ///< from the settings

signals:
    void aboutToRaise();     ///< receivers must hide what covers the panels
    void aboutToBringBack(); ///< each panel needs its final height now
    void changed();          ///< a comparison panel was opened or closed
    void workspaceChanged();

private:
    void add(Dock& dock);
    bool hidden() const { return !before_.isEmpty(); }
    Situation situation() const;
    void arrange();
    void follow(Dock& wide);
    void showTitles();
    void bringToFront(Dock& narrow);
    Dock* lowestDocked() const;
    void setOpen(Dock& wide, bool open); ///< an open one is in front
    void showWide();
    void fold(Dock& dock, bool folded);
    void showFolds();
    void makeRoom(const Dock& opened);
    void takeBackRoom();
    void saveFolds();
    QStringList folded() const; ///< in the workspace
    void defer(std::function<void()> action) { deferred_.push_back(std::move(action)); }

    QMainWindow& window_;
    PanelDocks docks_;
    OwnLayout own_;
    Arrangement arrangement_;
    HiddenPanels hiding_;
    QByteArray before_; ///< the layout before all panels were hidden; empty: they are not
    std::vector<std::function<void()>> deferred_; ///< until the panels come back
    QList<Dock*> openWide_; ///< the visible comparison panels, the newest last
    const Workspace* workspace_;
    bool starting_ = false; ///< Start is wanted in front
    QList<Dock*> yielding_; ///< folded to make room for one that was unfolded, the last one last
};

} // namespace ui
