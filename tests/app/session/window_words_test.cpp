// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_kinds.h"
#include "app/session/window_words.h"

#include <QTest>

#include "tests/test_class.h"

namespace session_window_words_test {

using namespace app;

namespace {

const WindowShape box = RectangleShape{{{1, 2}, {3, 4}}};

} // namespace

class WindowWordsTest : public QObject {
    Q_OBJECT

private slots:
    void theResultReadsLikeASum()
    {
        ClipWindows windows{
            {{.name = "Old town", .shape = box},
             {.name = "Hidden", .shape = box, .visible = false},
             {.name = "Market hall", .shape = box, .operation = WindowOperation::CutOut},
             {.shape = windowKind("star").make({{0, 0}, {9, 9}})},
             {.shape = box, .operation = WindowOperation::Intersect}}};
        QCOMPARE(resultOf(windows), "Old town − Market hall + Star ∩ Rectangle");
        windows.list[0].visible = false;
        QCOMPARE(resultOf(windows), "everything − Market hall + Star ∩ Rectangle");
        windows.list.push_back(windows.list.back());
        windows.list.push_back(windows.list.back());
        windows.list.back().visible = false;
        QCOMPARE(resultOf(windows), "everything − Market hall + Star ∩ 2 × Rectangle");
        QCOMPARE(resultOf({}), "");
        QCOMPARE(resultOf({{{.shape = box, .visible = false}}}), "");
    }
    void onlyMadeNamesHaveNumbers()
    {
        const auto next = [](const char* name) {
            return numberForNew({{{.name = name, .shape = box}}});
        };
        QCOMPARE(next("Rectangle 7"), 8);
        for (const char* own :
             {"", "Hall 7", "Rectangle 2147483647", "Rectangle -5", "Rectangle 07"})
            QCOMPARE(next(own), 2);
        QCOMPARE(nameAfter({.name = "Rectangle 7", .shape = box}, PathShape{}), "Path 7");
        QCOMPARE(nameAfter({.name = "Rectangle 0", .shape = box}, PathShape{}), "Rectangle 0");
    }
    void aShapeIsNamedByWhatItWasMadeFrom()
    {
        QCOMPARE(nameOf(box), "Rectangle");
        for (const auto& [key, name] :
             {std::pair{"ellipse", "Ellipse"}, {"polygon", "Polygon"}, {"star", "Star"}}) {
            const WindowShape shape = windowKind(key).make({{0, 0}, {9, 9}});
            QCOMPARE(nameOf(shape), name);
            QCOMPARE(iconOf(shape), std::string_view(key));
        }
        QCOMPARE(nameOf(PathShape{}), "Path");
        QCOMPARE(nameOf(PathShape{.recipe = TextRecipe{"A", {}, 0, {}}}), "Text");
        QCOMPARE(nameOf(ClipWindow{.name = "Hall", .shape = box}), "Hall");
    }
};

} // namespace session_window_words_test

TEST_CLASS(session_window_words_test::WindowWordsTest, Core)
#include "tests/app/session/window_words_test.moc"
