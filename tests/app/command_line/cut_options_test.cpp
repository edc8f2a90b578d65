// SPDX-License-Identifier: GPL-3.0-or-later
#include <QRegularExpression>
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_cut_options_test {

namespace {

QByteArray svg(const QByteArray& content)
{
    return "<svg xmlns='http://www.w3.org/2000/svg' "
           "xmlns:i='http://www.inkscape.org/namespaces/inkscape' width='100mm' height='100mm' "
           "viewBox='0 0 100 100'>"
           + content + "</svg>";
}

const QByteArray filled = svg("<g id='g'><rect id='r' x='-10' y='20' width='40' height='20' "
                              "fill='red' stroke='black'/></g>");

Ended clip(const QByteArray& drawing, const QStringList& options)
{
    return clearcut(QStringList{"clip", "-", "--from", "svg", "--to", "svg", "-o", "-"} + options,
                    drawing);
}

} // namespace

class CutOptionsTest : public QObject {
    Q_OBJECT

private slots:
    // Two elements in one group that keeps the id.
    void aFilledShapeBecomesAGroup()
    {
        const auto run = clip(filled, {"--page"});
        QCOMPARE(run.code, 0);
        const QString text = QString::fromUtf8(run.out).simplified();
        const QRegularExpression group(QStringLiteral(
            "id=\"g\"[^>]*>\\s*<g "
            "id=\"r\"[^>]*>\\s*<polygon[^>]*/>\\s*<polyline[^>]*/>\\s*</g>\\s*</g>"));
        QVERIFY2(group.match(text).hasMatch(), run.out);
        QCOMPARE(clip(run.out, {"--page", "-q"}).out, run.out); // cutting again changes nothing
    }

    void aFilledShapeIsClosed()
    {
        const auto run = clip(filled, {"--page", "--close"});
        QCOMPARE(run.code, 0);
        QCOMPARE(run.out.count("<polygon") + run.out.count("<rect"), 1);
        QVERIFY2(run.out.contains("id=\"r\"") && run.out.contains("stroke=\"#000000\"")
                     && run.out.contains("fill=\"#ff0000\""),
                 run.out);
        QVERIFY(!run.err.contains("opened"));
    }

    void shortPiecesAreCounted()
    {
        const QByteArray lines = svg("<path d='M-1,5 H2 M-1,9 H50' stroke='black' fill='none'/>");
        const auto run = clip(lines, {"--page", "--min-length", "3mm"});
        QVERIFY2(run.err.contains("Pieces shorter than --min-length left out: 1."), run.err);
        QVERIFY(run.out.contains("50") && !run.out.contains("2,5"));
        QCOMPARE(clip(lines, {"--page", "--min-length=-1mm"}).code, 2);
    }

    void hiddenShapesCanBeLeft()
    {
        const QByteArray hidden =
            svg("<path d='M-1,5 H2' stroke='black' fill='none' display='none'/>");
        const auto left = clip(hidden, {"--page", "--leave-hidden"});
        QVERIFY2(left.err.contains("Hidden shapes are left whole: 1."), left.err);
        QVERIFY2(left.out.contains("-1"), left.out);
        QVERIFY(!clip(hidden, {"--page"}).out.contains("-1,5"));
        const auto both = clip(hidden, {"--page", "--leave-hidden", "--drop-hidden"});
        QCOMPARE(both.code, 2);
        QVERIFY(both.err.contains("Give either --leave-hidden or --drop-hidden, not both."));
    }

    void lockedLayersAreReported()
    {
        const QByteArray locked =
            svg("<g i:groupmode='layer' i:label='L' "
                "xmlns:s='http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd' s:insensitive='true'>"
                "<path d='M-1,5 H2' stroke='black' fill='none'/></g>");
        const auto run = clip(locked, {"--page"});
        QVERIFY2(run.err.contains("shapes cut or removed on them: 1."), run.err);
    }

    // A circle 0.03 mm outside of the window's.
    void howFarEqualCurvesAreApartIsGiven()
    {
        const QByteArray two = "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' "
                               "height='100mm' viewBox='0 0 100 100'><circle cx='50' cy='50' "
                               "r='30.03' stroke='#000' fill='none'/></svg>";
        const QStringList window{"-w", "circle:50,50,30"};
        QVERIFY(!clip(two, window).out.contains("<circle"));
        const auto run = clip(two, window + QStringList{"--coincident", "0.05mm"});
        QVERIFY2(run.code == 0 && run.err.contains("1 kept whole"), run.err);
        for (const char* length : {"0mm", "-1mm"}) {
            const auto wrong = clip(two, window + QStringList{"--coincident", length});
            QVERIFY2(wrong.code != 0 && wrong.err.contains("--coincident"), wrong.err);
        }
    }

    void coveredLinesAreRemoved()
    {
        const QByteArray two = svg("<path d='M0,5 H50' stroke='black' fill='none'/>"
                                   "<rect x='10' y='1' width='10' height='10' fill='white' "
                                   "stroke='black'/>");
        const auto run = clip(two, {"--page", "--occlude"});
        QCOMPARE(run.code, 0);
        QVERIFY2(run.err.contains("Shapes with covered lines: 1 cut, 0 removed; fills removed: 1."),
                 run.err);
        QVERIFY2(!run.out.contains("#ffffff") && run.out.contains("10") && run.out.contains("20"),
                 run.out);
        // In a table of lines, too, which has no fills.
        const auto table = clearcut(
            {"clip", "-", "--from", "svg", "--to", "csv", "-o", "-", "--page", "--occlude", "-q"},
            two);
        QVERIFY2(table.out.contains("\n0,5,10,5") && table.out.contains("\n20,5,50,5"), table.out);
    }
};

} // namespace command_line_cut_options_test

TEST_CLASS(command_line_cut_options_test::CutOptionsTest, Core)
#include "tests/app/command_line/cut_options_test.moc"
