// SPDX-License-Identifier: GPL-3.0-or-later
#include <QImage>
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_stroke_areas_test {

// What `clip --strokes-as-areas` makes of strokes, beside librsvg's pictures of the strokes.

namespace {

/// 10 pixels for a millimetre.
QByteArray svg(const QByteArray& content)
{
    return "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' "
           "viewBox='0 0 100 100'>"
           + content + "</svg>";
}

const QByteArray cross = "<path d='M0 50H100M30 0V100' stroke='#000' stroke-width='15'";
/// Without dashes also closed, and with curves: librsvg joins the last dash to the first one, and
/// ends dashes at right angles to the chords of curves.
QByteArray paths(bool dashed)
{
    return QByteArrayLiteral("<path d='M10 10H40L20 30 45 32 12 38M60 10L90 12 85 40")
           + (dashed ? "L60 10"
                     : "ZM10 60H40C15 95 30 40 45 90M88 70A18 18 0 0 1 52 70A18 18 0 0 1 88 70Z")
           + "' fill='none' stroke='#000' ";
}

} // namespace

class StrokeAreasTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString path(const char* name) const { return folder_.filePath(QString::fromUtf8(name)); }

    QImage picture(const char* name) const
    {
        const QString png = path("picture.png");
        runProgram("rsvg-convert", {"-w", "1000", "-h", "1000", "-o", png, path(name)});
        return QImage(png).convertToFormat(QImage::Format_ARGB32);
    }

    /// How many pixels differ by half of their ink; librsvg itself is off by a third at curves.
    static int differing(const QImage& a, const QImage& b)
    {
        int count = 0, ink = 0;
        for (int y = 0; y < 1000; ++y)
            for (int x = 0; x < 1000; ++x) {
                count += std::abs(qAlpha(a.pixel(x, y)) - qAlpha(b.pixel(x, y))) > 127;
                ink += qAlpha(a.pixel(x, y)) > 0;
            }
        return ink > 20'000 ? count : 1'000'000;
    }

private slots:
    void theyLookLikeTheStrokes_data()
    {
        QTest::addColumn<QByteArray>("style");
        for (const QByteArray cap : {"butt", "round", "square"})
            for (const QByteArray join : {"miter", "round", "bevel"})
                for (const QByteArray dashes : {"none", "9 8 4 7"}) {
                    const QByteArray style = "stroke-width='6' stroke-linecap='" + cap
                                             + "' stroke-linejoin='" + join + "' stroke-dasharray='"
                                             + dashes + "' stroke-dashoffset='2'";
                    QTest::newRow(style.constData()) << style;
                }
    }
    void theyLookLikeTheStrokes()
    {
        QFETCH(QByteArray, style);
        writeText(path("art.svg"), svg(paths(!style.contains("none")) + style + "/>"));
        const auto run = clearcut({"clip", path("art.svg"), "-o", path("areas.svg"), "--page",
                                   "--margin", "-20mm", "--strokes-as-areas"});
        QVERIFY2(run.code == 0, run.err);
        QVERIFY(!contentOf(path("areas.svg")).contains("stroke-width"));
        const int off = differing(picture("art.svg"), picture("areas.svg"));
        QVERIFY2(off == 0, qPrintable(QString::number(off)));
    }

    void theyEndAlongASlantedEdge()
    {
        writeText(path("art.svg"), svg(cross + "/>"));
        writeText(path("masked.svg"), svg("<clipPath id='k'><polygon points='50,10 90,50 50,90 "
                                          "10,50'/></clipPath>"
                                          + cross + " clip-path='url(#k)'/>"));
        const QStringList clip{"clip", path("art.svg"), "-w", "polygon:50,10 90,50 50,90 10,50",
                               "-o",   path("cut.svg")};
        const QByteArray told = "wider than 1 mm that do not end along a slanted edge: 1. With "
                                "--strokes-as-areas";
        const auto plain = clearcut(clip);
        QVERIFY2(plain.err.count(told) == 1, plain.err);
        QVERIFY(differing(picture("masked.svg"), picture("cut.svg")) > 1000);
        const auto areas = clearcut(clip + QStringList{"--strokes-as-areas"});
        QVERIFY2(areas.code == 0 && !areas.err.contains("slanted"), areas.err);
        QCOMPARE(differing(picture("masked.svg"), picture("cut.svg")), 0);
    }

    void atRightAnglesNothingIsTold()
    {
        writeText(path("art.svg"), svg(cross + "/>"));
        for (const QStringList& window : {QStringList{"-w", "20,20,80,80"},
                                          QStringList{"-w", "polygon:20,20 80,20 80,80 20,80"}}) {
            const auto run =
                clearcut(QStringList{"clip", path("art.svg"), "-o", path("cut.svg")} + window);
            QVERIFY2(run.code == 0 && !run.err.contains("slanted"), run.err);
        }
        // Nor of a hairline, which shows no corner.
        writeText(path("thin.svg"), svg("<path d='M0 0L100 60' stroke='#000' stroke-width='.5'/>"));
        const auto run =
            clearcut({"clip", path("thin.svg"), "-o", path("cut.svg"), "-w", "20,0,80,99"});
        QVERIFY2(run.code == 0 && !run.err.contains("slanted"), run.err);
    }

    void besideOccludeItIsRefused()
    {
        writeText(path("art.svg"), svg(cross + "/>"));
        const auto run = clearcut({"clip", path("art.svg"), "-o", path("no.svg"), "--page",
                                   "--strokes-as-areas", "--occlude"});
        QVERIFY(run.code != 0);
        QVERIFY2(run.err.contains("either --strokes-as-areas or --occlude"), run.err);
        QVERIFY(!QFile::exists(path("no.svg")));
    }
};

} // namespace command_line_stroke_areas_test

TEST_CLASS(command_line_stroke_areas_test::StrokeAreasTest, Gui)
#include "tests/app/command_line/stroke_areas_test.moc"
