// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/common.hpp>

#include <random>

#include "tests/app/document/sheet.h"

/// Drawings of all that a sheet can hold, and the parts that they are made of. The same seed gives
/// the same ones.
class RandomSheets {
public:
    explicit RandomSheets(unsigned seed) : random_(seed) {}

    app::Sheet sheet()
    {
        app::Sheet sheet;
        sheet.page = page();
        const app::Point p = point(), q = point(); // one that is inside out is not kept
        sheet.window = {glm::min(p, q), glm::max(p, q)};
        sheet.layers.clear();
        for (auto n = 1 + below(4); n > 0; --n) {
            const auto layer = std::uint32_t(sheet.layers.size());
            sheet.layers.push_back(
                {text(), below(2) == 0, below(2) == 0, below(2) ? text() : QString()});
            app::Style last;
            for (auto shapes = below(12); shapes > 0; --shapes) {
                if (below(2) == 0)
                    last = style();
                sheet.shapes.push_back(shape(last, layer));
            }
        }
        return sheet;
    }

    app::Shape shape(const app::Style& style, std::uint32_t layer)
    {
        app::Shape shape{paths(), style, {}, layer};
        shape.id = below(2) ? text() : QString();
        shape.hidden = below(5) == 0;
        return shape;
    }
    app::Shape shape(std::uint32_t layer) { return shape(style(), layer); }

    std::size_t below(std::size_t n) { return random_() % n; }

    double number()
    {
        const double base = std::uniform_real_distribution<double>(-1, 1)(random_);
        const int kind = int(below(4));
        return kind == 0   ? double(int(below(200)) - 100)
               : kind == 1 ? base * 1e6
               : kind == 2 ? base * 1e-5
                           : base;
    }
    app::Point point() { return {number(), number()}; }

    app::Length length()
    {
        std::vector<app::Unit> units; // bare numbers are px
        for (const app::UnitInfo& row : app::units())
            if (row.inSvg && row.unit != app::Unit::User)
                units.push_back(row.unit);
        const app::Unit unit = units[below(units.size())];
        return {1 + std::abs(number()), unit};
    }

    app::Guides guides()
    {
        app::Guides guides;
        for (auto n = below(3); n > 0; --n)
            guides.list.push_back({int(below(2)), number()});
        return guides;
    }

    app::PageSheets sheets()
    {
        app::PageSheets sheets{text().trimmed(), below(2) == 0, below(2) == 0, {}};
        app::TilePlan& plan = sheets.plan;
        plan.marks = {below(2) == 0, below(2) == 0, below(2) == 0};
        plan.margin = std::abs(number());
        plan.overlap = std::abs(number());
        plan.scale = 0.5 + std::abs(number());
        plan.empty = below(2) ? app::EmptySheets::Written : app::EmptySheets::LeftOut;
        for (auto n = below(3); n > 0; --n)
            plan.leftOut.push_back(1 + int(below(app::mostTiles)));
        plan.beyond = {int(below(3)), int(below(3)), int(below(3)), int(below(3))};
        if (sheets.byNumber) {
            plan.columns = 1 + int(below(20));
            plan.rows = 1 + int(below(20));
        } else {
            plan.shift = point();
        }
        return sheets;
    }

    app::DrawingScale scale()
    {
        const app::Unit units[]{app::Unit::Mm, app::Unit::Metre, app::Unit::Foot};
        app::DrawingScale scale;
        if (below(2))
            scale.ratio = 0.5 + std::abs(number());
        if (below(2))
            scale.unit = units[below(std::size(units))];
        return scale;
    }

    app::PaperMargins margins()
    {
        const auto side = [&] { return std::abs(number()); };
        return below(2) ? app::PaperMargins{}
                        : app::PaperMargins{side(), side(), side(), side(), below(2) == 0};
    }

    // As proportionate as the sheet of paper that it is, or open in a direction.
    app::Page page()
    {
        app::Page page{
            point(), {1 + std::abs(number()), 1 + std::abs(number())}, length(), length()};
        const auto open = [](const app::Length& l) { return l.unit == app::Unit::Percent; };
        if (!open(page.width) && !open(page.height))
            page.height = {page.width.value * (page.size.y / page.size.x), page.width.unit};
        page.guides = guides();
        if (below(2))
            page.sheets = sheets();
        page.scale = scale();
        page.margins = margins();
        return page;
    }

    QString text()
    {
        static const QStringList texts{
            "a", "Layer 1", "<&\"'>", "tab\tnew\nline\r", "Überzug – 図層 😀", "  blanks  "};
        return texts[qsizetype(below(std::size_t(texts.size())))];
    }

    app::Colour colour()
    {
        const auto byte = [&] { return std::uint8_t(below(256)); };
        return {byte(), byte(), byte(), below(2) ? byte() : std::uint8_t(255)};
    }

    app::Style style()
    {
        app::Style style;
        if (below(2))
            style.stroke = colour();
        if (below(3) == 0)
            style.fill = colour();
        if (below(2))
            style.width = std::abs(number());
        if (below(4) == 0)
            style.miterLimit = 1 + std::abs(number());
        for (auto n = below(4) == 0 ? 1 + below(4) : 0; n > 0; --n)
            style.dashes.push_back(0.5 + std::abs(number()));
        if (below(4) == 0)
            style.dashOffset = number();
        style.cap = app::Cap(below(3));
        style.join = app::Join(below(3));
        style.fillRule = app::FillRule(below(2));
        return style;
    }

    std::vector<app::Subpath> paths()
    {
        std::vector<app::Subpath> paths;
        for (auto n = 1 + below(2) * below(3); n > 0; --n) {
            app::Subpath path{point(), {}, below(2) == 0};
            const bool curves = below(2) == 0;
            for (auto segments = below(5); segments > 0; --segments) {
                if (curves && below(2))
                    path.segments.push_back({point(), point(), point(), true});
                else
                    path.segments.push_back({point()});
            }
            paths.push_back(path);
        }
        return paths;
    }

private:
    std::mt19937_64 random_;
};
