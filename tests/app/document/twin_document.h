// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/objects.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/app/document/plain_drawing.h"

/// A drawing as a sheet of shapes and as objects, which are edited together.
class TwinDocument {
public:
    static constexpr double tolerance = 0.05;

    explicit TwinDocument(std::uint64_t seed) : random(seed)
    {
        app::Sheet sheet;
        sheet.page = {{0, 0}, {100, 100}, {100, app::Unit::Mm}, {100, app::Unit::Mm}};
        sheet.layers = {{"one"}, {"two"}, {"three"}};
        drawing.load(sheet);
    }

    std::size_t size() const { return objects.size(); }
    const app::Shape& shape(std::size_t i) const { return drawing.sheet().shapes[i]; }

    void splice(std::size_t first, std::size_t removed, std::vector<app::Shape> shapes)
    {
        const auto& old = drawing.sheet().shapes;
        app::Objects added;
        for (app::Shape& shape : shapes) { // layers ascend
            if (first < size())
                shape.layer = old[first].layer;
            else
                shape.layer = std::max(shapes.front().layer, size() > 0 ? old.back().layer : 0);
            added.append({app::Path(shape.paths), shape.style, {}, shape.hidden});
        }
        objects.splice(first, removed, added);
        drawing.splice(first, removed, shapes);
        followLayers();
    }
    void append(app::Shape shape) { splice(size(), 0, {std::move(shape)}); }

    void setVisible(std::size_t layer, bool visible)
    {
        auto layers = drawing.sheet().layers;
        layers[layer].visible = visible;
        drawing.setLayers(layers);
        followLayers();
    }

    /// Exchanges some shapes for others.
    void editAtRandom()
    {
        const std::size_t first = random() % (size() + 1);
        const std::size_t most = random() % 20 == 0 ? 500 : 5;
        const std::size_t removed = random() % (std::min(size() - first, most) + 1);
        std::vector<app::Shape> shapes;
        for (auto n = random() % (most + 1); n > 0; --n)
            shapes.push_back(randomShape());
        if (random() % 30 == 0)
            setVisible(random() % 3, random() % 2);
        else
            splice(first, removed, std::move(shapes));
    }

    app::Point randomPoint()
    {
        std::uniform_real_distribution<double> number(-10, 110);
        // Some on a grid, where they meet each other and the edges of windows.
        app::Point point(number(random), number(random));
        return random() % 4 == 0 ? app::Point(std::round(point.x), std::round(point.y)) : point;
    }

    app::Shape randomShape()
    {
        app::Shape shape;
        shape.style.width = double(1 + random() % 3);
        shape.hidden = random() % 8 == 0;
        shape.layer = std::uint32_t(random() % 3);
        const auto kind = random() % 8;
        if (kind < 4)
            shape.paths.push_back({randomPoint(), {{randomPoint()}}, false});
        else if (kind < 5)
            shape.paths.push_back({randomPoint(), {}, false});
        else if (kind < 6)
            shape.paths.push_back(stroke());
        else
            for (auto n = random() % 3; n > 0; --n)
                shape.paths.push_back(randomSubpath());
        return shape;
    }

    PlainDrawing drawing;
    app::Objects objects;
    app::ObjectRanges hidden; ///< those on layers that are not visible
    std::mt19937_64 random;

private:
    /// A pen line that wanders over a corner of the page.
    app::Subpath stroke()
    {
        std::uniform_real_distribution<double> step(-1, 1);
        app::Point at = randomPoint();
        app::Subpath path{at, {}, random() % 2 == 0};
        for (auto n = random() % 200; n > 0; --n)
            path.segments.push_back({at += app::Point(step(random), step(random))});
        return path;
    }
    app::Subpath randomSubpath()
    {
        app::Subpath path{randomPoint(), {}, random() % 2 == 0};
        for (auto n = random() % 5; n > 0; --n) {
            if (random() % 2 == 0)
                path.segments.push_back({randomPoint()});
            else
                path.segments.push_back({randomPoint(), randomPoint(), randomPoint(), true});
        }
        return path;
    }
    void followLayers()
    {
        hidden = {};
        const auto& [page, layers, shapes, window, about] = drawing.sheet();
        for (std::size_t i = 0; i < shapes.size(); ++i)
            if (!layers[shapes[i].layer].visible)
                hidden.insert(app::ObjectRange{i, i + 1});
    }
};
