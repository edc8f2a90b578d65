// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

#include <QFrame>
#include <QLabel>
#include <QPlainTextEdit>
#include <QToolButton>

namespace ui {

class FontList;
class LengthField;

/// The text that is being typed, below its letters on the canvas, with its font and size. It has
/// the keyboard as long as there is such a text.
class TextBox : public QFrame {
    Q_OBJECT

public:
    TextBox(Controller& controller, QWidget* parent);

    /// The surface over which the box is shown; it gets the keyboard back.
    void setSurface(QWidget* surface);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void follow();
    void show(const TypedText& text);
    void place(const TypedText& text);
    void change(const std::function<void(app::TextRecipe&)>& edit);
    bool key(const QKeyEvent& event);

    Controller& controller_;
    QWidget* surface_ = nullptr;
    FontList* font_;
    LengthField* size_;
    QPlainTextEdit* text_;
    /// Bold and italic, shown where the font has them.
    struct Face {
        QToolButton* button;
        bool app::FontFace::*part;
        QKeyCombination key;
    };
    const Face* faceOf(const QKeyEvent& event) const;
    std::vector<Face> faces_;
    QLabel* remark_;
    bool following_ = false; ///< shows the tool's text: nothing was typed
};

} // namespace ui
