// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/pane_heading.h"

#include <random>

#include "tests/ui/canvas/stage.h"

// A stage with panes.

inline constexpr auto published = clipping::Form::Published;

inline app::Variant row(const char* key, clipping::Form form = clipping::Form::Corrected)
{
    return {clipping::findAlgorithm(key), form};
}

/// Thin lines, many of them nearly vertical: published KWC loses these.
inline std::vector<app::Shape> steepLines()
{
    std::mt19937 random(5);
    std::vector<app::Shape> shapes;
    for (int i = 0; i < 300; ++i) {
        const double x = double(20 + random() % 160);
        shapes.push_back(line({x, double(random() % 50)}, {x + 0.5, double(50 + random() % 50)}));
        shapes.back().style.width = 0.5;
    }
    return shapes;
}

class PaneStage : public Stage {
public:
    explicit PaneStage(std::size_t count, ui::Backend backend = ui::Backend::Raster)
        : Stage(backend, steepLines())
    {
        show(count);
        canvas->fitPage();
        canvas->setSnapping(app::SnapTo::Nothing);
    }
    void show(std::size_t count)
    {
        app::Panes panes = canvas->panes();
        count > 4 ? panes.showAll() : panes.show(count);
        canvas->setPanes(panes);
        QCoreApplication::processEvents();
    }
    std::size_t count() const { return canvas->panes().size(); }
    QWidget& pane(std::size_t i) const { return *canvas->paneSurface(i); }
    ui::PaneHeading& heading(std::size_t i) const
    {
        return *pane(i).parentWidget()->findChild<ui::PaneHeading*>();
    }
    /// A mouse event in a pane, at a point of the drawing.
    void send(std::size_t i, QEvent::Type type, QPointF at, Qt::MouseButton button) const
    {
        const bool move = type == QEvent::MouseMove, up = type == QEvent::MouseButtonRelease;
        if (type == QEvent::MouseButtonPress)
            pane(i).setFocus(Qt::MouseFocusReason);
        QMouseEvent event(type, at, pane(i).mapToGlobal(at), move ? Qt::NoButton : button,
                          up ? Qt::NoButton : button, Qt::NoModifier);
        QApplication::sendEvent(&pane(i), &event);
    }
    QImage shot(std::size_t i)
    {
        canvas->settle();
        return pane(i).grab().toImage();
    }
    /// The bounding box of the orange outline in a pane.
    QRect orange(std::size_t i)
    {
        const QImage image = shot(i);
        QRect found;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x) {
                const QColor c = image.pixelColor(x, y);
                if (c.red() > 180 && c.green() < 90 && c.blue() < 60)
                    found |= QRect(x, y, 1, 1);
            }
        return found;
    }
    app::Variant chosen() const { return session.variant(); }
};
