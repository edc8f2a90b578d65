// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_words.h"

#include <QTest>

#include "tests/app/document/sheet_edits.h"
#include "tests/app/session/concave_window.h"
#include "tests/test_class.h"

namespace session_compared_text_test {

using clipping::Window;

namespace {

constexpr Window middle{{40, 40}, {60, 60}}, other{{0, 0}, {20, 20}};

app::ClipWindow rectangle(const QString& name, const Window& box)
{
    return {.name = name, .shape = app::RectangleShape{box}};
}

/// Steep lines that published KWC loses wherever they are visible.
app::Sheet steepLines()
{
    app::Sheet sheet;
    sheet.page = {{0, 0}, {100, 100}};
    for (int i = 0; i < 20; ++i) {
        app::Shape line;
        line.paths = {{{5. * i, 10}, {{{5. * i + 0.5, 90}}}}};
        line.style.stroke = app::Colour{};
        sheet.shapes.push_back(std::move(line));
    }
    return sheet;
}

struct Drawing {
    Drawing() { load(session.document, steepLines()); }
    /// How many lines published KWC is said to lose.
    std::size_t lost()
    {
        session.differences.ask(app::Comparison{*app::findVariant("kwc:published")});
        session.differences.finish();
        return session.differences.found().list.size();
    }
    app::Session session;
};

} // namespace

/// Algorithms are compared where the drawing is cut, or nowhere.
class ComparedTextTest : public QObject {
    Q_OBJECT

private slots:
    void atOneRectangleNothingIsToBeSaid()
    {
        Drawing drawing;
        setWindows(drawing.session, {rectangle("A", middle)});
        QCOMPARE(drawing.session.comparedAt(), std::optional(middle));
        QCOMPARE(app::comparedText(drawing.session), QString());
        QCOMPARE(app::comparedName(drawing.session), QString());
        QVERIFY(drawing.lost() > 0);
    }
    void withoutAWindowItIsThePage()
    {
        Drawing drawing;
        setWindows(drawing.session, {});
        QCOMPARE(drawing.session.comparedAt(),
                 std::optional(drawing.session.now().page().rectangle()));
        QVERIFY(app::comparedText(drawing.session).startsWith("At the page"));
        auto hidden = rectangle("A", middle);
        hidden.visible = false;
        setWindows(drawing.session, {hidden});
        QVERIFY(app::comparedText(drawing.session).startsWith("At the page"));
        QCOMPARE(drawing.lost(), std::size_t(20));
    }
    /// What an algorithm loses of the page is no loss of a drawing that is cut at a star.
    void atAStarNothingIsCompared()
    {
        Drawing drawing;
        QVERIFY(drawing.lost() > 0);
        setWindows(drawing.session, {concaveWindow("Star", middle)});
        QVERIFY(!drawing.session.comparedAt());
        QVERIFY(app::comparedText(drawing.session).startsWith("Nothing is compared"));
        QCOMPARE(drawing.lost(), std::size_t(0));
        QVERIFY(drawing.session.differences.upToDate());
        drawing.session.exactness.ask(
            app::LiveExactness::Question{*app::findVariant("kwc:published")});
        drawing.session.exactness.finish();
        QVERIFY(drawing.session.exactness.found().list.empty());
        setWindows(drawing.session, {rectangle("A", middle)}); // found again by itself
        QVERIFY(drawing.lost() > 0);
        drawing.session.exactness.finish();
        QVERIFY(!drawing.session.exactness.found().list.empty());
    }
    void aRotatedRectangleIsNotComparedEither()
    {
        Drawing drawing;
        app::RectangleShape turned{middle};
        turned.angle = 0.5;
        setWindows(drawing.session, {{.name = "Turned", .shape = turned}});
        QVERIFY(!drawing.session.comparedAt());
    }
    void amongSeveralWindowsTheRectangleIsNamed()
    {
        Drawing drawing;
        setWindows(drawing.session, {concaveWindow("Star", other), rectangle("Yard", middle)});
        QCOMPARE(drawing.session.comparedAt(), std::optional(middle));
        QCOMPARE(app::comparedName(drawing.session), QStringLiteral("Yard"));
        QCOMPARE(app::comparedText(drawing.session), "Compared inside Yard only.");
        setWindows(drawing.session, {rectangle("Shed", other), rectangle("Yard", middle)});
        drawing.session.chooseWindow(1);
        QCOMPARE(app::comparedName(drawing.session), QStringLiteral("Yard"));
        drawing.session.chooseWindow(0);
        QCOMPARE(app::comparedName(drawing.session), QStringLiteral("Shed"));
    }
    /// What is kept outside a window is not what algorithms are compared by.
    void outsideItSaysInside()
    {
        Drawing drawing;
        setWindows(drawing.session, {rectangle("Yard", middle)}, app::Keep::Outside);
        QCOMPARE(app::comparedName(drawing.session), QStringLiteral("Yard"));
        auto cut = rectangle("Yard", middle);
        cut.operation = app::WindowOperation::CutOut;
        setWindows(drawing.session, {cut});
        QCOMPARE(app::comparedName(drawing.session), QStringLiteral("Yard"));
    }
};

} // namespace session_compared_text_test

TEST_CLASS(session_compared_text_test::ComparedTextTest, Core)
#include "tests/app/session/compared_text_test.moc"
