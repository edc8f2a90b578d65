// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/lettering.h"
#include "app/lettering/stroke_fonts.h"
#include "app/scene/bounds.h"
#include "app/session/copy_selection.h"
#include "app/session/pasted_text.h"

#include <QTest>

#include <glm/geometric.hpp>

#include "tests/test_class.h"

namespace session_pasted_text_test {

class PastedTextTest : public QObject {
    Q_OBJECT

    static app::PastedText text(const QString& text)
    {
        return {text, app::strokeFonts().front().name, 5, {40, 30}};
    }
    static const app::TextRecipe* recipeOf(const app::Document& drawing)
    {
        return std::get_if<app::TextRecipe>(&drawing.objects()[0].particulars().recipe);
    }

private slots:
    void isOneTextAroundItsCentre()
    {
        app::Session session;
        const auto drawing = app::drawingOf(session, text("Wall\nDoor"));
        QVERIFY(drawing);
        QCOMPARE(drawing.value->objects().size(), std::size_t(1));
        const app::TextRecipe* recipe = recipeOf(*drawing.value);
        QVERIFY(recipe);
        QCOMPARE(recipe->text, "Wall\nDoor");
        QCOMPARE(recipe->size, 5 / session.now().page().millimetresPerUnit());
        QVERIFY(app::makes(*recipe, drawing.value->objects()[0].path().subpaths()));
        app::paste(session, *drawing.value, app::PastePlace::InPlace);
        const auto box = app::boundsOf(session.scene.lines());
        QVERIFY(box && glm::distance((box->min + box->max) * 0.5, {40, 30}) < 1e-9);
        QCOMPARE(session.history.count(), 1);
    }
    void otherProgramsEndLinesAsTheyLike()
    {
        const app::Session session;
        const auto drawing = app::drawingOf(session, text("\r\n \r\n a\r\nb\tc\a\n\r\n"));
        QVERIFY(drawing);
        QCOMPARE(recipeOf(*drawing.value)->text, " a\nb    c");
    }
    void whatHasNoLettersIsRefused()
    {
        const app::Session session;
        for (const char* const nothing : {"", " \n\t", "\a"})
            QVERIFY(app::drawingOf(session, text(nothing)).error.contains("no text"));
        const auto tooLong = app::drawingOf(session, text(QString(10'001, u'a')));
        QVERIFY2(tooLong.error.contains("10,001 characters"), qPrintable(tooLong.error));
    }
};

} // namespace session_pasted_text_test

TEST_CLASS(session_pasted_text_test::PastedTextTest, Gui)
#include "tests/app/session/pasted_text_test.moc"
