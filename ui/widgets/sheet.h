// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

class QHBoxLayout;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace ui {

class Heading;

/// A page at the right of the drawing, in place of the panels: a heading with a button that closes
/// it, a body that scrolls, and a foot with buttons. The drawing stays alive. Esc closes it, unless
/// one of its fields takes that key.
class Sheet : public QWidget {
    Q_OBJECT

public:
    enum class Width : std::uint8_t { Usual, Wide };

    /// `key` is the objectName, `title` the heading and the accessible name.
    Sheet(const QString& key, const QString& title, Width width = Width::Usual,
          QWidget* parent = nullptr);

    void setRemark(const QString& remark); ///< muted, after the title
    /// Takes the width that suits a window of this width.
    void fitTo(int widthOfWindow);
    /// What Esc and the button in the heading do. A sheet whose changes show at once may first take
    /// them back.
    virtual void leave() { emit closeWanted(); }
    /// What stands in place of the drawing while the sheet is shown; null: the drawing.
    QWidget* preview() const { return preview_; }
    void focusFirst(); ///< gives the focus to the first widget of the body that takes it

signals:
    void closeWanted();

protected:
    QVBoxLayout& body() { return *body_; }
    enum class Side : std::uint8_t { Left, Right };
    QVBoxLayout& aboveButtons() { return *aboveButtons_; } ///< of the foot
    void setPreview(QWidget* preview) { preview_ = preview; }
    void addToFoot(QPushButton* button, Side side = Side::Right); ///< beside those before
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addHeading(QVBoxLayout& column, const QString& title);
    void addBody(QVBoxLayout& column);
    void addFoot(QVBoxLayout& column);

    Width width_;
    Heading* heading_ = nullptr;
    QWidget* inner_ = nullptr; ///< what scrolls
    QVBoxLayout* body_ = nullptr;
    QVBoxLayout* aboveButtons_ = nullptr;
    QHBoxLayout* foot_ = nullptr;
    QPointer<QWidget> preview_;
    int stretchInFoot_ = 0; ///< the number of buttons at the left
};

} // namespace ui
