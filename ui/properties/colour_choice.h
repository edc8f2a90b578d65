// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/selection_style.h"
#include "ui/canvas/canvas.h"
#include "ui/widgets/swatch.h"

#include <QToolButton>

namespace ui {

class ColourPopup;

/// A button with the colour of strokes or fills. It opens the colours to choose from; a choice
/// changes the selected objects, else what is drawn next.
class ColourChoice : public QToolButton {
    Q_OBJECT

public:
    ColourChoice(app::Session& session, Canvas& canvas, app::PaintPart part);

    void setPart(app::PaintPart part);
    void setSwatch(Swatch form);
    app::PaintPart part() const { return part_; }
    void choose(const std::optional<app::Colour>& colour);
    void startEyedropper(); ///< the next click on the canvas chooses
    /// The colour that all have, which may be none; empty: it differs.
    std::optional<std::optional<app::Colour>> now() const;

signals:
    void eyedropperStarted();

protected:
    void showEvent(QShowEvent* event) override;

private:
    void open();
    void follow();

    app::Session& session_;
    Canvas& canvas_;
    app::PaintPart part_;
    Swatch swatch_ = Swatch::Square;
    ColourPopup* popup_;
};

} // namespace ui
