// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/microscope_mode.h"
#include "ui/window/presenting_mode.h"

class QToolBar;

namespace ui {

class PanelLayout;

/// What the window is used for. Presenting is entered and left at any time, also with the
/// microscope open, and the microscope also while presenting; lessons are part of the microscope.
enum class Mode : std::uint8_t { Editing, Microscope, Presenting, PresentingMicroscope };

/// The mode that a session asks for. This alone says which mode is on.
Mode modeOf(const app::Session& session);

/// The parts of the window that a mode shows.
struct ModeParts {
    bool microscope; ///< in place of the canvas
    bool panels;
    bool barAcross; ///< the horizontal tool bar, with the options; the microscope has its own
    bool barAtSide; ///< the vertical tool bar, with the tools
};
constexpr ModeParts partsOf(Mode mode)
{
    using enum Mode;
    const bool microscope = mode == Microscope || mode == PresentingMicroscope;
    const bool presenting = mode == Presenting || mode == PresentingMicroscope;
    return {.microscope = microscope,
            .panels = !microscope && !presenting,
            .barAcross = !microscope,
            .barAtSide = !presenting};
}

/// Takes a window from one mode to another. Panels and bars that were shown in Editing are shown
/// again when the window returns to it.
class Modes : public QObject {
    Q_OBJECT

public:
    /// What the modes change in a window.
    struct Parts {
        QWidget& window;
        Centre& centre;
        PanelLayout& panels;
        QList<QToolBar*> bars;
    };
    Modes(app::Session& session, app::DrawnLine& drawn, Canvas& canvas, Parts parts);

    void togglePresenting();
    MicroscopeMode& microscope() { return microscope_; }
    const MicroscopeMode& microscope() const { return microscope_; }

signals:
    void changed(); ///< the mode, or whether lessons are shown

private:
    void followMicroscope();
    void fit();
    void fitBars(const ModeParts& shown);

    app::Session& session_;
    Parts parts_;
    MicroscopeMode microscope_;
    PresentingMode presenting_;
    /// The bars that Editing shows; empty: they are shown now.
    std::optional<QList<QToolBar*>> barsOfEditing_;
};

} // namespace ui
