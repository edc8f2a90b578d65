// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/window_values.h"
#include "ui/canvas/controller.h"

#include <QElapsedTimer>
#include <QFrame>
#include <QLabel>
#include <QToolButton>

class QActionGroup;

namespace ui {

class LengthField;
class Segments;
class UnitButton;

/// The chosen clip window's own controls, beside it on the canvas: what it does with those above
/// it, its size, the side that is kept, and its menu. It is shown while the window's handles are,
/// and hidden during gestures. It stays where it is while it has the keyboard or the pointer.
class Capsule : public QFrame {
    Q_OBJECT

public:
    enum class Form : std::uint8_t { Whole, Compact }; ///< Compact: fewer, for narrow canvases

    Capsule(Controller& controller, QWidget* parent);

    /// The surface on which it lies; it gets the keyboard back.
    void setSurface(QWidget* surface, Form form);
    void switchOn(bool on);
    bool isOn() const { return on_; }
    void settle(); ///< shows it at once, if a change of the view has hidden it

signals:
    void menuWanted(const QPoint& corner); ///< of its lower right corner on the screen
    void refused(const QString& sentence); ///< a typed length is not one
    void taken();                          ///< the length is valid again

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QToolButton* makeOperations();
    LengthField* makeField(app::WindowValue which);
    void setOperation(int operation);
    void enter(); ///< its first field gets the keyboard
    void leave(); ///< gives the keyboard back
    bool isWanted() const;
    bool hasKeyboard() const;
    bool holds() const; ///< it has the keyboard or the pointer
    void follow();
    void hideWhileMoving();
    void showValues();
    void place();

    Controller& controller_;
    QWidget* surface_ = nullptr;
    Form form_ = Form::Whole;
    bool on_ = true;
    Segments *operation_, *keep_;
    QActionGroup* operationChoice_; ///< of the menu of operations_
    QToolButton *operations_, *more_;
    LengthField *width_, *height_;
    UnitButton* unit_;
    QTimer still_; ///< runs while the view changes
    QElapsedTimer shownFor_;
};

} // namespace ui
