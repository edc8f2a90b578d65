// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/properties/colour_choice.h"
#include "ui/widgets/length_field.h"

#include <QTimer>

class QCheckBox;
class QLayout;
class QLineEdit;

namespace ui {

class Segments;
class Swatches;
class DashList;

/// The style of the selected objects, or of new ones if nothing is selected: colours of stroke and
/// fill, width, dashes, caps, joins, fill rule. Each choice is one undo step. Where objects differ,
/// it says "mixed" or marks no choice. What a style does not have is not shown: the miter limit
/// without mitered joins, the fill rule without a fill. Its height is always the same. While it is
/// hidden it does nothing.
class StylePanel : public QWidget {
    Q_OBJECT

public:
    StylePanel(app::Session& session, Canvas& canvas, QWidget* parent = nullptr);

    void follow();     ///< shows the style of the selection, without waiting for the event loop
    void focusFirst(); ///< gives the keyboard to the width

signals:
    void entered(); ///< a value was entered: the focus returns to the canvas
    void refused(const QString& sentence);
    void taken(); ///< a field's value is valid again
    void eyedropperStarted();

protected:
    void showEvent(QShowEvent* event) override;

private:
    QLayout* makeColour();
    QLayout* makeWidth();
    QLayout* makeCorners();
    QLayout* makePattern();
    QLayout* makeFillRule();
    void makeLayer();
    LengthField* makeField(const QString& name, LengthField::Suffix suffix);
    void followLayer();
    void followLines(std::span<const app::Style> styles);
    void change(const app::ChangeStyle& change, const QString& text,
                app::Merging merging = app::Merging::Never);
    void enterPattern();
    void enterMiterLimit();
    app::Scale scale() const;

    app::Session& session_;
    Segments* part_;
    ColourChoice* colour_;
    Swatches* swatches_;
    LengthField* width_;
    DashList* dashes_;
    QLineEdit* pattern_;
    Segments *caps_, *joins_, *fillRule_;
    LengthField* miterLimit_;
    QCheckBox* ofLayer_;
    QTimer soon_; ///< merges several changes in one event into one update
};

} // namespace ui
