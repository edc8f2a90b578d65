// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/properties/colour_choice.h"

#include <QWidget>

namespace ui {

class LengthField;
class DashList;

/// The colour, the width and the dashes of strokes: of the selected objects, else of what is drawn
/// next. A plain one is for selected objects and has the parts that these have: the fill, but not
/// of a single line; no width and dashes of texts.
class StrokeRow : public QWidget {
    Q_OBJECT

public:
    enum class Frame : std::uint8_t { Fields, Plain }; ///< Plain: text until it is used

    StrokeRow(app::Session& session, Canvas& canvas, Frame frame, QWidget* parent = nullptr);

    LengthField& width() { return *width_; }
    ColourChoice& colour() { return *colour_; }
    void showParts(); ///< those that the selected objects have

protected:
    void showEvent(QShowEvent* event) override;

private:
    void addFill();
    void addWidth(Frame frame);
    void addDashes(Frame frame);
    void follow();

    app::Session& session_;
    Canvas& canvas_;
    ColourChoice* colour_;
    ColourChoice* fill_ = nullptr; ///< null: it is not offered
    LengthField* width_;
    DashList* dashes_;
};

} // namespace ui
