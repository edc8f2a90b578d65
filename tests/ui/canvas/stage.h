// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/canvas.h"

#include <QApplication>
#include <QImage>
#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QTest>
#include <QWheelEvent>

#include "tests/app/document/sheet.h"

// A canvas on the screen with a drawing of 200 x 100 px at 100 %, and functions that send events.

inline app::Shape line(app::Point a, app::Point b)
{
    app::Shape shape;
    shape.paths.push_back({a, {{b}}, false});
    shape.style.stroke = app::Colour{0, 0, 200};
    shape.style.width = 4;
    return shape;
}

class Stage {
public:
    explicit Stage(ui::Backend backend,
                   std::vector<app::Shape> shapes = {line({10, 50}, {190, 50})})
    {
        app::Sheet sheet;
        sheet.page = {{0, 0}, {200, 100}, {200, app::Unit::Px}, {100, app::Unit::Px}};
        sheet.window = {{50, 20}, {150, 80}};
        sheet.shapes = std::move(shapes);
        session.load({app::documentOf(sheet), {}});
        session.worksInDraw = true; // digits are numbers
        canvas = std::make_unique<ui::Canvas>(session, backend);
        canvas->resize(820, 620);
        canvas->show();
        canvas->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(canvas.get()));
        canvas->setFocus();
        canvas->setZoom(2);
    }

    QWidget& surface() { return *canvas->focusProxy(); }
    QPoint at(app::Point p) const
    {
        const app::Point s = canvas->view().toScreen(p);
        return {qRound(s.x), qRound(s.y)};
    }
    void move(app::Point p, Qt::MouseButtons buttons = Qt::NoButton,
              Qt::KeyboardModifiers modifiers = {})
    {
        const QPointF s = at(p);
        QMouseEvent event(QEvent::MouseMove, s, surface().mapToGlobal(s), Qt::NoButton, buttons,
                          modifiers);
        QApplication::sendEvent(&surface(), &event);
    }
    void press(app::Point p, Qt::MouseButton button = Qt::LeftButton,
               Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mousePress(&surface(), button, modifiers, at(p));
    }
    void release(app::Point p, Qt::MouseButton button = Qt::LeftButton,
                 Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseRelease(&surface(), button, modifiers, at(p));
    }
    void drag(app::Point from, app::Point to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers modifiers = {})
    {
        const QPoint end = at(to); // the view may move
        move(from, Qt::NoButton, modifiers);
        press(from, button, modifiers);
        move((from + to) * 0.5, button, modifiers);
        QMouseEvent last(QEvent::MouseMove, end, surface().mapToGlobal(end), Qt::NoButton, button,
                         modifiers);
        QApplication::sendEvent(&surface(), &last);
        QTest::mouseRelease(&surface(), button, modifiers, end);
    }
    void click(app::Point p, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(&surface(), Qt::LeftButton, modifiers, at(p));
    }
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(&surface(), key, modifiers);
    }
    void wheel(QPointF at, QPoint angle, Qt::KeyboardModifiers modifiers = {}, QPoint pixels = {},
               Qt::ScrollPhase phase = Qt::NoScrollPhase)
    {
        QWheelEvent event(at, surface().mapToGlobal(at), pixels, angle, Qt::NoButton, modifiers,
                          phase, false);
        QApplication::sendEvent(&surface(), &event);
    }
    /// The drawing without the rulers, with one pixel per logical pixel.
    QImage picture()
    {
        canvas->settle();
        const QImage image = surface().grab().toImage();
        return image.scaled(surface().size());
    }
    QColor colourAt(app::Point p) { return picture().pixelColor(at(p)); }

    app::Session session;
    std::unique_ptr<ui::Canvas> canvas;
};

inline bool near(const app::Point& a, const app::Point& b, double most = 0.51)
{
    return std::abs(a.x - b.x) <= most && std::abs(a.y - b.y) <= most;
}
inline bool near(const clipping::Window& a, const clipping::Window& b, double most = 0.51)
{
    return near(a.min, b.min, most) && near(a.max, b.max, most);
}
