// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/microscope_mode.h"
#include "ui/window/presenting_mode.h"
#include "ui/window/sheet_place.h"
#include "ui/window/tiles_mode.h"

class QToolBar;

namespace ui {

class PanelLayout;

/// What the window is used for. Presenting is entered and left at any time, also with the
/// microscope open, and the microscope also while presenting; lessons are part of the microscope.
/// Both of them close the tiles, which are entered from the drawing.
enum class Mode : std::uint8_t {
    Editing,
    Microscope,
    Lessons,
    Presenting,
    PresentingMicroscope,
    PresentingLessons,
    Tiles
};

/// Whether the lessons are shown beside the microscope.
enum class Beside : std::uint8_t { Nothing, Lessons };

/// The mode that a session and its sheets ask for. They alone say which mode is on, except that the
/// page of the microscope knows what is shown beside it.
Mode modeOf(const app::Session& session, const app::LiveSheets& sheets,
            Beside beside = Beside::Nothing);

/// The parts of the window that a mode shows.
struct ModeParts {
    bool microscope, tiles; ///< in place of the canvas
    bool panels;
    bool barAcross; ///< the horizontal tool bar, with the options; microscope and tiles have their
                    ///< own
    bool barAtSide; ///< the vertical tool bar, with the tools
    bool status;    ///< the status bar
};
constexpr ModeParts partsOf(Mode mode)
{
    using enum Mode;
    const bool lessons = mode == Lessons || mode == PresentingLessons;
    const bool microscope = lessons || mode == Microscope || mode == PresentingMicroscope;
    const bool presenting =
        mode == Presenting || mode == PresentingMicroscope || mode == PresentingLessons;
    const bool tiles = mode == Tiles;
    return {.microscope = microscope,
            .tiles = tiles,
            .panels = !microscope && !presenting && !tiles,
            .barAcross = !microscope && !tiles,
            .barAtSide = !presenting && !tiles && !lessons,
            .status = !lessons};
}

/// Takes a window from one mode to another. Panels and bars that were shown in Editing are shown
/// again when the window returns to it.
class Modes : public QObject {
    Q_OBJECT

public:
    /// What the modes change in a window.
    struct Parts {
        QWidget& window;
        app::LiveSheets& sheets;
        Centre& centre;
        PanelLayout& panels;
        QList<QToolBar*> bars;
        QWidget& status; ///< the status bar
    };
    Modes(app::Session& session, app::DrawnLine& drawn, Canvas& canvas, Parts parts);

    void togglePresenting();
    MicroscopeMode& microscope() { return microscope_; }
    const MicroscopeMode& microscope() const { return microscope_; }
    TilesMode& tiles() { return tiles_; }
    SheetPlace& sheets() { return sheets_; }
    const SheetPlace& sheets() const { return sheets_; }

signals:
    void changed(); ///< the mode, or whether lessons are shown

private:
    void followMicroscope();
    void followSheets();
    void followLessons();
    void followSheet();
    Mode mode() const;
    void fit();
    void fitBars(const ModeParts& shown);

    app::Session& session_;
    Parts parts_;
    MicroscopeMode microscope_;
    TilesMode tiles_;
    SheetPlace sheets_;
    PresentingMode presenting_;
    /// The bars that Editing shows; empty: they are shown now.
    std::optional<QList<QToolBar*>> barsOfEditing_;
};

} // namespace ui
