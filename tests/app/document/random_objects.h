// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/objects.h"

#include <vector>

#include "tests/app/document/random_paths.h"

inline app::Path polyline(int points, double y)
{
    app::Subpath subpath{{0, y}, {}, false};
    for (int i = 1; i < points; ++i)
        subpath.segments.push_back({app::Point(i, y)});
    return app::Path({&subpath, 1});
}

/// Objects of all sizes, among them such as are more than a block; often several alike in a row.
class RandomObjects {
public:
    explicit RandomObjects(unsigned seed) : paths_(seed)
    {
        for (int i = 0; i < 40; ++i)
            large_.push_back(polyline(i < 3 ? 9000 + i : 300 * (i % 9 + 1), i));
        for (int i = 0; i < 200; ++i)
            small_.emplace_back(paths_.subpaths());
    }

    int whole(int low, int high) { return paths_.random.whole(low, high); }
    std::vector<app::Object> some(int count)
    {
        std::vector<app::Object> objects;
        while (objects.size() < std::size_t(count)) {
            const int kind = whole(0, 5);
            const app::Style style = this->style();
            for (int i = whole(1, 12); i > 0 && objects.size() < std::size_t(count); --i)
                objects.push_back({path(kind), whole(0, 9) ? style : this->style(), particulars(),
                                   whole(0, 19) == 0});
        }
        return objects;
    }

private:
    app::Path path(int kind)
    {
        if (kind < 3)
            return app::Path(clipping::Segment{paths_.point(), paths_.point()});
        const std::vector<app::Path>& paths = kind == 3 ? small_ : large_;
        return paths[std::size_t(whole(0, int(paths.size()) - 1))];
    }
    app::Style style()
    {
        app::Style style;
        style.width = whole(0, 9) ? 1 : whole(2, 300);
        return style;
    }
    app::Particulars particulars()
    {
        if (whole(0, 19))
            return {};
        return {QString::number(whole(0, 1000)), {}, {}, app::EllipseRecipe{{1, 2}, {3, 4}, 0.5}};
    }

    RandomPaths paths_;
    std::vector<app::Path> small_, large_;
};

inline app::Objects objectsOf(const std::vector<app::Object>& all, app::Objects start = {})
{
    for (const app::Object& object : all)
        start.append(object);
    return start;
}

inline bool equal(const app::Objects& objects, const std::vector<app::Object>& expected)
{
    if (objects.size() != expected.size())
        return false;
    bool equal = true;
    std::size_t next = 0;
    objects.forEach(0, objects.size(), [&](std::size_t i, const app::ObjectView& object) {
        const app::Object& other = expected[i];
        equal = equal && i == next++ && object.path() == other.path && object.style() == other.style
                && object.particulars() == other.particulars && object.hidden() == other.hidden
                && object.singleLine() == other.path.singleLine();
    });
    return equal && next == expected.size();
}
