// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/change_paths.h"
#include "app/document/document_builder.h"

#include <QTest>

#include "tests/test_class.h"

namespace commands_change_paths_test {

class ChangePathsTest : public QObject {
    Q_OBJECT

    static app::Object object(const char* id, app::Point at, app::Recipe recipe = {})
    {
        return {.path = app::Path(clipping::Segment{at, at + app::Point(5, 5)}),
                .style = {.stroke = app::Colour{9, 8, 7}, .width = at.x + 1},
                .particulars = {.id = id, .title = "title", .recipe = std::move(recipe)}};
    }
    static app::Document document()
    {
        app::DocumentBuilder builder;
        builder.open({.name = "below"});
        builder.add(object("a", {0, 0}));
        builder.close();
        builder.open({.name = "above"});
        builder.add(object("b", {1, 0}, app::RectangleRecipe{{1, 0}, {5, 5}}));
        builder.add(object("c", {2, 0}));
        builder.close();
        return builder.take({}, {}, {});
    }
    static app::Path triangle()
    {
        const app::Subpath path{{0, 0}, {{{9, 0}}, {{9, 9}}}, true};
        return app::Path(std::span(&path, 1));
    }

private slots:
    void keepsEverythingButThePathAndTheRecipe()
    {
        app::EditedDocument edited(document());
        const app::Document before = edited.now();
        app::ChangePaths change(edited, std::array{app::ChangedPath{1, triangle()}}, "Nodes");
        change.redo();
        app::Object wanted = before.objects()[1].copy();
        QVERIFY(wanted.particulars.recipe.index() != 0);
        wanted.path = triangle();
        wanted.particulars.recipe = {};
        QVERIFY(edited.now().objects()[1].copy() == wanted);
        QVERIFY(edited.now().objects()[0].copy() == before.objects()[0].copy());
        QVERIFY(edited.now().containers() == before.containers());
        change.undo();
        QVERIFY(edited.now() == before);
        change.redo();
        QVERIFY(edited.now().objects()[1].copy() == wanted);
    }
    void aNewRecipeIsKept()
    {
        app::EditedDocument edited(document());
        const app::Document before = edited.now();
        const app::Recipe recipe = app::TextRecipe{"word", "font", 5, {1, 2}};
        app::ChangePaths change(edited, std::array{app::ChangedPath{1, triangle(), recipe}},
                                "Text");
        change.redo();
        QVERIFY(edited.now().objects()[1].particulars().recipe == recipe);
        QCOMPARE(edited.now().objects()[1].particulars().id, "b");
        change.undo();
        QVERIFY(edited.now() == before);
    }
    void anObjectWithoutAPathIsRemoved()
    {
        app::EditedDocument edited(document());
        const app::Document before = edited.now();
        app::ChangePaths change(
            edited, std::array{app::ChangedPath{0, triangle()}, app::ChangedPath{2, app::Path()}},
            "Join");
        change.redo();
        QCOMPARE(edited.now().objects().size(), std::size_t(2));
        QCOMPARE(edited.now().containers().objects(), std::size_t(2));
        QVERIFY(edited.now().objects()[0].path() == triangle());
        QCOMPARE(edited.now().objects()[1].particulars().id, "b");
        change.undo();
        QVERIFY(edited.now() == before);
    }
};

} // namespace commands_change_paths_test

TEST_CLASS(commands_change_paths_test::ChangePathsTest, None)
#include "tests/app/commands/change_paths_test.moc"
