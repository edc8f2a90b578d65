// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QSize>

#include <vector>

class QMainWindow;

namespace ui {

class Dock;

/// The panels that a mode without panels hides. They come back as they were: in the same places
/// and sizes, with the same tabs in front.
class HiddenPanels {
public:
    /// `docks` are all docks of the window.
    HiddenPanels(QMainWindow& window, QList<Dock*> docks);

    /// Hides every panel. Until they come back, none can be shown by its toggle.
    void hide();
    void bringBack();

private:
    struct Place {
        Dock* dock;
        QSize size; ///< including the tab bar above it
        bool inFront;
    };

    QMainWindow& window_;
    QList<Dock*> docks_;
    std::vector<Place> places_; ///< of the panels to show again
};

} // namespace ui
