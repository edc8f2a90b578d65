// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/capsule_place.h"
#include "ui/canvas/controller.h"

#include <QFrame>
#include <QToolButton>

#include <vector>

namespace ui {

class LengthField;

/// The own controls of what is chosen, beside it on the canvas. It is hidden during gestures, stays
/// where it is while it has the keyboard or the pointer, and lets clicks through when it has just
/// appeared. In the options bar it is shown during gestures, too. Derived classes say what it is
/// for, and what it holds.
class Capsule : public QFrame {
    Q_OBJECT

public:
    enum class Form : std::uint8_t { Whole, Compact }; ///< Compact: fewer, for narrow canvases

    Capsule(Controller& controller, QWidget* parent);

    /// The surface on which it lies; it gets the keyboard back.
    void setSurface(QWidget* surface, Form form);
    /// `bar`: a row in the options bar, where it stands instead; null: on the surface.
    void setHome(app::CapsuleHome home, QWidget* bar);
    bool isInBar() const { return home_ == app::CapsuleHome::InBar; }
    virtual void setForm(Form form) = 0;
    void settle(); ///< shows it at once, if a change of the view has hidden it

signals:
    void menuWanted(const QPoint& corner); ///< of its lower right corner on the screen
    void refused(const QString& sentence); ///< a typed length is not one
    void taken();                          ///< the length is valid again
    void barOutdated();                    ///< it needs more or less room there

protected:
    /// Whether keys are for what it is for.
    virtual bool isFor() const = 0;
    /// Notes what is chosen now; true: it is something else than before. What is typed is only ever
    /// for what was shown.
    virtual bool followSubject() = 0;
    virtual void showValues() = 0;
    virtual app::WindowFrame frame() const = 0; ///< in the drawing, of what it is for
    virtual app::CapsuleRoom room() const = 0;  ///< without `canvas` and `released`
    virtual QColor ringColour() const = 0;

    Controller& controller() const { return controller_; }
    QWidget* surface() const { return surface_; }
    void addPart(QWidget& part, int place = -1); ///< -1: last
    QWidget* addRule(int place = -1);            ///< between two groups of parts
    void addMore(const QString& tip);            ///< the button of the menu
    LengthField* makeField(const QString& name, const QString& objectName, bool angle = false);
    void adopt(LengthField& field); ///< Enter and Esc in it give the keyboard back
    void follow();
    void leave(); ///< takes what is typed, and gives the keyboard back

    bool eventFilter(QObject* watched, QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void followSession();
    void enter();  ///< its first field gets the keyboard
    void forget(); ///< discards what is typed, and gives the keyboard back
    bool isWanted() const;
    bool hasKeyboard() const;
    bool holds() const; ///< it has the keyboard or the pointer
    void hideWhileMoving();
    void withdraw();
    void setMargins();
    void showInBar();
    void place(bool isOther); ///< than before
    void beDeaf();

    Controller& controller_;
    QWidget* surface_ = nullptr;
    QWidget* canvas_; ///< its parent while it is not in the bar
    app::CapsuleHome home_ = app::CapsuleHome::AtObject;
    bool noRoom_ = false;
    std::vector<LengthField*> fields_;
    QTimer still_; ///< runs while the view changes
    QTimer deaf_;  ///< runs while clicks go through it
    /// From the middle of the thing to where the pointer let it go.
    std::optional<QPointF> released_{};
    bool afterGesture_ = false; ///< a gesture has begun since it was placed
    std::optional<app::WindowFrame> placedAt_{};
    QSize inBar_{}; ///< the room that it has there; empty: none
};

} // namespace ui
