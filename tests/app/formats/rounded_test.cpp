// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/rounded.h"

#include <QTest>

#include <random>

#include "tests/app/formats/svg/text.h"
#include "tests/test_class.h"
#include "tests/verify.h"

namespace formats_rounded_test {

namespace {

using app::Point;
using app::Subpath;

std::vector<Subpath> rounded(std::vector<Subpath> paths, int precision = 0)
{
    app::Sheet sheet;
    sheet.shapes = {{std::move(paths), {.stroke = app::Colour{}}, {}, 0, false}};
    app::WriteOptions options;
    options.precision = precision;
    const auto made = app::rounded(app::documentOf(sheet), options);
    const auto& shapes = app::sheetOf(made.document).shapes;
    return shapes.empty() ? std::vector<Subpath>() : shapes.front().paths;
}

Subpath random(std::mt19937& bits)
{
    const auto number = [&] { return double(bits() % 4000) / 1000; };
    const auto point = [&] { return Point{number(), number()}; };
    Subpath path{point(), {}, bits() % 3 == 0};
    for (std::uint32_t left = bits() % 6; left > 0; --left)
        path.segments.push_back(bits() % 3 == 0 ? app::PathSegment{point(), point(), point(), true}
                                                : app::PathSegment{point()});
    return path;
}

// Whether no part of the path goes to where it already is.
bool moves(const Subpath& path)
{
    Point at = path.start;
    for (const app::PathSegment& segment : path.segments) {
        const bool turns = segment.curved && (segment.control1 != at || segment.control2 != at);
        if (segment.to == at && !turns)
            return false;
        at = segment.to;
    }
    return true;
}

} // namespace

class RoundedTest : public QObject {
    Q_OBJECT

private slots:
    void withoutALimitNothingChanges()
    {
        const Subpath path{{0.1, 0.2}, {{{0.1, 0.2}}}, false};
        QCOMPARE(rounded({path}, -1), std::vector{path});
    }

    void repeatedPointsGo()
    {
        QCOMPARE(rounded({{{0, 0}, {{{0.2, 0.1}}, {{5, 5}}, {{5.1, 4.9}}, {{9, 9}}}, false}}),
                 (std::vector<Subpath>{{{0, 0}, {{{5, 5}}, {{9, 9}}}, false}}));
        // The closing line of a polygon needs no point of its own.
        QCOMPARE(rounded({{{0, 0}, {{{5, 0}}, {{5, 5}}, {{0.1, 0.1}}}, true}}),
                 (std::vector<Subpath>{{{0, 0}, {{{5, 0}}, {{5, 5}}}, true}}));
        // A curve that returns is no point.
        const Subpath loop{{1, 1}, {{{1, 1}, {9, 1}, {1, 9}, true}}, false};
        QCOMPARE(rounded({loop}), std::vector{loop});
    }

    void whatBecomesAPointGoesUnlessItWasOne()
    {
        const Subpath dot{{3, 3}, {}, false}, line{{1, 1}, {{{1.2, 1.1}}}, false};
        QCOMPARE(rounded({line}), std::vector<Subpath>());
        QCOMPARE(rounded({dot, line}), std::vector{dot});
        QCOMPARE(rounded({{{1, 1}, {{{1.1, 1}}, {{1, 1.1}}}, true}}), std::vector<Subpath>());
        QCOMPARE(rounded({{{1.2, 1}, {{{1.2, 1}}}, true}}),
                 (std::vector<Subpath>{{{1, 1}, {}, true}}));
        app::Sheet sheet;
        sheet.shapes = {{{line, line}, {.stroke = app::Colour{}}, {}, 0, false},
                        {{dot}, {.stroke = app::Colour{}}, {}, 0, false}};
        app::WriteOptions options;
        options.precision = 0;
        const auto made = app::rounded(app::documentOf(sheet), options);
        QCOMPARE(made.points, std::size_t(2));
        QCOMPARE(made.document.objects().size(), std::size_t(1));
    }

    // Whatever is drawn: what is written has no repeated points, is written alike when it is
    // rounded before, and is read as what was rounded.
    void manyPaths()
    {
        std::mt19937 bits(11);
        app::WriteOptions options;
        for (int round = 0; round < 2000; ++round) {
            options.precision = int(bits() % 3);
            app::Sheet sheet;
            sheet.shapes = {
                {{random(bits), random(bits)}, {.stroke = app::Colour{}}, {}, 0, false}};
            const app::Document drawing = app::documentOf(sheet);
            const app::Document made = app::rounded(drawing, options).document;
            for (const auto& shape : app::sheetOf(made).shapes)
                for (const Subpath& path : shape.paths)
                    QVERIFY(moves(path));
            const QByteArray text = textOf(drawing, options);
            VERIFY_OR_SAY(textOf(made, options) == text, text);
            VERIFY_OR_SAY(textOf(made) == text, text);
            QCOMPARE(app::rounded(made, options).points, std::size_t(0));
        }
    }
};

} // namespace formats_rounded_test

TEST_CLASS(formats_rounded_test::RoundedTest, Core)
#include "tests/app/formats/rounded_test.moc"
