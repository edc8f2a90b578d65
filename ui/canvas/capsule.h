// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/window_values.h"
#include "ui/canvas/controller.h"

#include <QFrame>
#include <QLabel>
#include <QToolButton>

class QActionGroup;

namespace ui {

class LengthField;
class Segments;
class UnitButton;

/// The chosen clip window's own controls, beside it on the canvas: what it does with those above
/// it, its size, the side that is kept, and its menu. It is shown while keys are for the window
/// (Controller::actsOnWindow), and hidden during gestures. It stays where it is while it has the
/// keyboard or the pointer.
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
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QToolButton* makeOperations();
    LengthField* makeField(app::WindowValue which);
    void setOperation(int operation);
    void enter();  ///< its first field gets the keyboard
    void leave();  ///< takes what is typed, and gives the keyboard back
    void forget(); ///< discards what is typed, and gives the keyboard back
    void set(app::WindowValue which, double length, app::Merging merging);
    bool isWanted() const;
    bool hasKeyboard() const;
    bool holds() const; ///< it has the keyboard or the pointer
    void follow();
    void hideWhileMoving();
    void showValues();
    void place();
    void beDeaf();

    Controller& controller_;
    QWidget* surface_ = nullptr;
    bool on_ = true;
    Segments *operation_, *keep_;
    QActionGroup* operationChoice_; ///< of the menu of operations_
    QToolButton *operations_, *more_;
    LengthField *width_, *height_;
    UnitButton* unit_;
    QTimer still_; ///< runs while the view changes
    QTimer deaf_;  ///< runs while clicks go through it
    struct Shown {
        std::optional<std::size_t> number{};
        QString name{};
        friend bool operator==(const Shown&, const Shown&) = default;
    };
    Shown shown_;                       ///< the window whose values it shows
    std::optional<QPointF> released_{}; ///< where the pointer was when the window was let go
    std::optional<app::WindowFrame> placedAt_{};
};

} // namespace ui
