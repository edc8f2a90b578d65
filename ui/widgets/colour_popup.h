// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"
#include "ui/widgets/popup.h"

#include <map>

class QLabel;
class QLineEdit;
class QToolButton;

namespace ui {

class LookLabel;

class Swatches;

/// What a colour can be chosen from.
struct ColourOffer {
    std::vector<app::Colour> inDrawing, recent;
    /// The current one, which may be none; empty: there are several.
    std::optional<std::optional<app::Colour>> now;
};

/// A small window in which a colour is picked: from the drawing, from those picked last, from a
/// chart, by digits or name, with the eyedropper; or none. A pick closes it. Digits and letters go
/// to the field, whichever part has the keyboard.
class ColourPopup : public Popup {
    Q_OBJECT

public:
    explicit ColourPopup(QWidget* parent);

    void open(const QWidget& below, const ColourOffer& offer);
    void hideEyedropper(); ///< where it has no canvas

signals:
    void picked(const std::optional<app::Colour>& colour);
    void eyedropperWanted();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    Swatches* addSwatches(const QString& name, int rows);
    void addField();
    void say(const QString& sentence, bool isError);
    void pick(const std::optional<app::Colour>& colour);
    void accept();

    std::map<const Swatches*, QLabel*> captions_;
    Swatches *inDrawing_, *recent_, *chart_;
    QToolButton* eyedropper_;
    QLineEdit* field_;
    LookLabel* sentence_;
};

} // namespace ui
