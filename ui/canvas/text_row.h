// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/selected_texts.h"

#include <QToolButton>
#include <QWidget>

namespace ui {

class FontList;
class LengthField;

/// Font, bold, italic and size of the selected texts.
class TextRow : public QWidget {
    Q_OBJECT

public:
    explicit TextRow(app::Session& session);

    /// Shows the selected texts. False: there are none.
    bool follow();
    void setCompact(bool compact); ///< without bold and italic

signals:
    void done(); ///< the keyboard should return to the canvas

private:
    void addFaces();
    void showFaces(std::span<const app::TextRecipe> texts);
    void say(const std::optional<QString>& remark);

    app::Session& session_;
    FontList* font_;
    LengthField* size_;
    /// Bold and italic, shown where the font has them.
    struct Face {
        QToolButton* button;
        bool app::FontFace::*part;
    };
    std::vector<Face> faces_;
    bool compact_ = false;
};

} // namespace ui
