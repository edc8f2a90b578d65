// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_in_hand.h"

#include <glm/geometric.hpp>

#include "tests/app/document/sheet.h"
#include "tests/ui/test_window.h"

// A window and a person in front of it, for tests of tools.

inline app::Shape shape(std::vector<app::Subpath> paths)
{
    app::Shape shape;
    shape.paths = std::move(paths);
    shape.style.stroke = app::Colour{0, 0, 200};
    shape.style.width = 1;
    return shape;
}
inline app::Subpath corner() { return {{20, 20}, {{{100, 20}}, {{100, 80}}}, false}; }
inline app::Subpath wave()
{
    return {{20, 50},
            {{{80, 50}, {40, 10}, {60, 20}, true}, {{140, 50}, {100, 80}, {120, 90}, true}},
            false};
}

/// A window with its menus, so that every key goes the usual way. Its unit is the user unit, 1 mm.
struct Hand {
    explicit Hand(std::vector<app::Shape> shapes)
    {
        app::Sheet sheet;
        sheet.page = {{0, 0}, {200, 100}, {200, app::Unit::Mm}, {100, app::Unit::Mm}};
        sheet.window = {{160, 85}, {190, 95}};
        sheet.shapes = std::move(shapes);
        session.load({app::documentOf(sheet), {}});
        auto display = session.display();
        display.unit = app::Unit::User;
        session.setDisplay(display);
        t.show();
        key(Qt::Key_1, Qt::ControlModifier | Qt::AltModifier); // Draw: digits are numbers
        canvas.setSnapping(app::SnapTo::Nothing);
        canvas.fitPage();
    }
    QWidget& surface() { return *canvas.focusProxy(); }
    QPoint at(app::Point p)
    {
        const app::Point s = canvas.view().toScreen(p);
        return {qRound(s.x), qRound(s.y)};
    }
    void click(app::Point p, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseClick(&surface(), Qt::LeftButton, modifiers, at(p));
    }
    void doubleClick(app::Point p)
    {
        click(p);
        QTest::mouseDClick(&surface(), Qt::LeftButton, {}, at(p));
    }
    void press(app::Point p) { QTest::mousePress(&surface(), Qt::LeftButton, {}, at(p)); }
    void move(app::Point p, Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = {})
    {
        const QPointF s = at(p);
        QMouseEvent event(QEvent::MouseMove, s, surface().mapToGlobal(s), Qt::NoButton, buttons,
                          modifiers);
        QApplication::sendEvent(&surface(), &event);
    }
    void release(app::Point p, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mouseRelease(&surface(), Qt::LeftButton, modifiers, at(p));
    }
    void drag(app::Point from, app::Point to, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::mousePress(&surface(), Qt::LeftButton, modifiers, at(from));
        move((from + to) * 0.5, Qt::LeftButton, modifiers);
        move(to, Qt::LeftButton, modifiers);
        release(to, modifiers);
    }
    static void key(int key, Qt::KeyboardModifiers modifiers = {})
    {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key(key), modifiers);
    }
    static void type(const char* text)
    {
        for (const char* c = text; *c; ++c)
            *c == '\n' ? key(Qt::Key_Return) : QTest::keyClick(QApplication::focusWidget(), *c);
    }
    std::vector<app::Subpath> paths(std::size_t object = 0)
    {
        return session.now().objects()[object].path().subpaths();
    }
    app::Subpath path() { return paths().front(); }
    std::size_t selected() { return session.nodes.summary().selected; }
    /// How exact the pointer is: a pixel.
    bool isNear(app::Point a, app::Point b)
    {
        return glm::distance(a, b) <= 0.75 / canvas.view().zoom;
    }

    ui::TestWindow t;
    app::Session& session = t.window->session();
    ui::Canvas& canvas = t.window->canvas();
};
