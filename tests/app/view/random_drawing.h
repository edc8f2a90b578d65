// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_builder.h"
#include "app/scene/scene_lines.h"
#include "app/view/view.h"

#include <glm/common.hpp>

#include <cmath>
#include <random>

/// Drawings of all styles: loose lines, strokes, areas, curves, the same thing several times. The
/// same seed gives the same ones.
class RandomDrawing {
public:
    explicit RandomDrawing(unsigned seed) : random_(seed)
    {
        for (int i = 0; i < 3; ++i)
            styles_.push_back(style());
    }

    app::Document document()
    {
        const std::size_t count = 1 + below(below(5) == 0 ? 400 : 60);
        app::DocumentBuilder builder;
        builder.open({.name = "one"});
        while (builder.size() < count) {
            const app::Object object{
                app::Path(subpaths()), styles_[below(styles_.size())], {}, below(9) == 0};
            for (auto copies = below(20) == 0 ? 1 + below(5) : 1; copies > 0; --copies)
                builder.add(object);
            if (below(12) == 0)
                styles_[below(styles_.size())] = style();
            if (below(40) == 0) {
                builder.close();
                builder.open({.name = "more", .visible = below(4) > 0, .locked = below(4) == 0});
            }
        }
        builder.close();
        return builder.take(page());
    }
    /// One object that spans blocks of the scene, between others.
    app::Document longOutline()
    {
        app::Subpath ring{{50, 50}, {}, true};
        for (std::size_t i = 0; i < app::SceneBlock::mostSegments + 30'000; ++i) {
            const double turn = double(i) * 0.01, radius = 5 + double(i) * 4e-4;
            ring.segments.push_back({{50 + radius * std::cos(turn), 50 + radius * std::sin(turn)}});
        }
        app::Style dashed = style();
        dashed.dashes = {7, 3};
        app::DocumentBuilder builder;
        builder.open({.name = "one"});
        builder.add({app::Path(std::vector{ring}), dashed});
        builder.add({app::Path(std::vector{stroke()}), style()});
        builder.add({app::Path(std::vector{ring}), dashed});
        builder.close();
        return builder.take(page());
    }
    clipping::Window window()
    {
        const app::Point a = point(), b = point();
        if (below(6) == 0)
            return {{-1e9, -1e9}, {1e9, 1e9}};
        return {glm::min(a, b), glm::max(a, b)};
    }
    app::View view()
    {
        app::View view;
        view.size = {200, 150};
        view.centre = below(6) == 0 ? app::Point(1e5, -1e5) : point();
        view.zoom = std::pow(10, std::uniform_real_distribution<double>(-3, 6)(random_));
        if (below(2))
            view.zoom = std::pow(10, double(below(10)) - 3);
        return view;
    }
    app::ObjectRanges selection(std::size_t objects)
    {
        app::ObjectRanges some;
        for (auto n = below(4); n > 0; --n) {
            const std::size_t first = below(objects);
            some.insert(app::ObjectRange{first, first + 1 + below(objects - first)});
        }
        return some;
    }
    std::vector<clipping::Clipped> pieces(std::size_t lines)
    {
        std::vector<clipping::Clipped> some;
        for (auto n = below(30); n > 0; --n) // some of lines that are no longer there
            some.push_back({{point(), point()}, std::uint32_t(below(lines + 5)), 0});
        return some;
    }
    // Many on a grid, where they meet each other and the edges of windows.
    app::Point point()
    {
        std::uniform_real_distribution<double> number(-10, 110);
        const app::Point p(number(random_), number(random_));
        return below(2) ? p : glm::round(p / 10.0) * 10.0;
    }
    std::size_t below(std::size_t n) { return random_() % n; }
    app::Colour colour()
    {
        const auto byte = [&] { return std::uint8_t(below(256)); };
        return {byte(), byte(), byte(), below(3) ? std::uint8_t(255) : byte()};
    }

private:
    static app::Page page()
    {
        return {{0, 0}, {100, 100}, {100, app::Unit::Mm}, {100, app::Unit::Mm}};
    }
    app::Style style()
    {
        app::Style style;
        style.width = double(below(4)) * 0.7;
        if (below(4))
            style.stroke = colour();
        if (below(3) == 0)
            style.fill = colour();
        for (auto n = below(3) == 0 ? 1 + below(4) : 0; n > 0; --n)
            style.dashes.push_back(0.5 + double(below(9)));
        style.dashOffset = double(below(3));
        style.miterLimit = double(below(3) * 4);
        style.cap = app::Cap(below(3));
        style.join = app::Join(below(3));
        style.fillRule = app::FillRule(below(2));
        return style;
    }
    std::vector<app::Subpath> subpaths()
    {
        const auto kind = below(10);
        if (kind < 4)
            return {{point(), {{point()}}, false}};
        if (kind < 5)
            return {{point(), {}, false}};
        if (kind < 6)
            return {stroke()};
        std::vector<app::Subpath> paths;
        for (auto n = 1 + below(3); n > 0; --n)
            paths.push_back(subpath());
        return paths;
    }
    app::Subpath stroke()
    {
        std::uniform_real_distribution<double> step(-2, 2);
        app::Point at = point();
        app::Subpath path{at, {}, below(2) == 0};
        for (auto n = below(300); n > 0; --n)
            path.segments.push_back({at += app::Point(step(random_), step(random_))});
        return path;
    }
    app::Subpath subpath()
    {
        app::Subpath path{point(), {}, below(2) == 0};
        for (auto n = below(6); n > 0; --n) {
            if (below(3))
                path.segments.push_back({point()});
            else
                path.segments.push_back({point(), point(), point(), true});
        }
        return path;
    }

    std::mt19937_64 random_;
    std::vector<app::Style> styles_;
};
