// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/styles_in_use.h"

#include <QTest>

#include "tests/test_class.h"

namespace document_styles_in_use_test {

using app::Colour;

class StylesInUseTest : public QObject {
    Q_OBJECT

    static constexpr Colour red{255, 0, 0}, blue{0, 0, 255}, green{0, 128, 0};

    static app::Objects lines(const std::vector<app::Style>& styles)
    {
        app::Objects objects;
        for (const app::Style& style : styles)
            objects.append(app::Object{app::Path(clipping::Segment{{0, 0}, {1, 1}}), style});
        return objects;
    }

private slots:
    void mostUsedColoursComeFirst()
    {
        const auto objects = lines({{.stroke = red},
                                    {.stroke = blue},
                                    {.stroke = blue, .width = 3},
                                    {.stroke = green, .fill = red},
                                    {.stroke = green},
                                    {.stroke = green, .width = 2},
                                    {.stroke = Colour{1, 2, 3, 0}}}); // transparent
        QCOMPARE(app::coloursInUse(objects, 9), (std::vector{green, red, blue}));
        QCOMPARE(app::coloursInUse(objects, 2), (std::vector{green, red}));
        QVERIFY(app::coloursInUse({}, 9).empty());
    }
    void eachStyleOfTheChosenObjectsIsFoundOnce()
    {
        const auto objects =
            lines({{.stroke = red}, {.stroke = blue}, {.stroke = red}, {.stroke = green}});
        const auto strokes = [&](const app::ObjectRanges& chosen) {
            std::vector<Colour> found;
            for (const auto style : app::stylesOf(objects, chosen))
                found.push_back(*objects.styles()[style].stroke);
            return found;
        };
        QCOMPARE(strokes({0, 2}), (std::vector{red}));
        QCOMPARE(strokes({0, 1, 2}), (std::vector{red, blue}));
        QCOMPARE(strokes({3}), (std::vector{green}));
        QVERIFY(strokes({}).empty());
    }
    void manyBlocksAreCounted()
    {
        app::Objects objects;
        const auto first = objects.styles().entryOf({.stroke = blue});
        const auto second = objects.styles().entryOf({.stroke = red});
        constexpr std::size_t many = 50'000;
        for (std::size_t i = 0; i < many; ++i)
            objects.appendLine({{0, 0}, {1, 1}}, i < many / 3 ? first : second);
        QVERIFY(objects.blocks().size() > 3);
        QCOMPARE(app::coloursInUse(objects, 9), (std::vector{red, blue}));
        const app::ObjectRanges end(app::ObjectRange{many / 2, many});
        QCOMPARE(app::stylesOf(objects, end), (std::vector{second.index()}));
    }
};

} // namespace document_styles_in_use_test

TEST_CLASS(document_styles_in_use_test::StylesInUseTest, None)
#include "tests/app/document/styles_in_use_test.moc"
