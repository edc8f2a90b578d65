// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/view.h"

#include <QElapsedTimer>
#include <QNativeGestureEvent>
#include <QWheelEvent>

#include <optional>

namespace ui {

/// The view, and its response to wheel, touchpad and pinch gestures.
class Navigation : public QObject {
    Q_OBJECT

public:
    explicit Navigation(QObject* parent = nullptr);

    const app::View& view() const { return view_; }
    void go(const app::View& view); ///< back() returns from it
    /// What stays when the size changes: what was fitted, else the middle; or the zoom, and the
    /// point at the upper left corner.
    enum class Keep : std::uint8_t { Fit, Corner };
    void resize(const glm::dvec2& size, Keep keep = Keep::Fit);
    /// Fits the rectangle into the view, again whenever the view's size changes.
    void show(const clipping::Window& rectangle);
    bool isFitted() const { return fitted_.has_value(); } ///< until the view moves
    void hold(); ///< keeps the visible part in view when the size changes, until the view moves
    /// For release(), which goes back to the present zoom and corner unless the view moves before.
    void remember();
    bool release(); ///< false: nothing is remembered
    void pan(const QPointF& pixels);
    void zoomAt(const QPointF& screen, double factor);
    void back();
    void forth();

    void wheel(const QWheelEvent& event);
    bool gesture(const QNativeGestureEvent& event); ///< true if the gesture was handled

signals:
    void moved();

private:
    void replace(const app::View& view);
    void forget(); ///< the view was moved
    static bool isTouchpad(const QWheelEvent& event);

    app::View view_;
    app::ViewHistory history_;
    app::WheelZoom wheel_;
    /// hold() fits without a margin.
    enum class Margin : std::uint8_t { None, Usual };
    struct Fitted {
        clipping::Window rectangle;
        Margin margin;
    };
    static void fit(app::View& view, const Fitted& fitted);
    std::optional<Fitted> fitted_; ///< until the view is moved
    struct Held {
        app::View view;
        std::optional<Fitted> fitted;
    };
    std::optional<Held> held_; ///< what is remembered; until the view is moved
    QElapsedTimer clock_;
};

} // namespace ui
