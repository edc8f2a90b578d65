// SPDX-License-Identifier: GPL-3.0-or-later
// Clip paths that are kept are written again, and hide the same.
#include "app/formats/svg/reader.h"
#include "app/formats/svg/writer.h"

#include <QBuffer>
#include <QTest>

#include "tests/test_class.h"

namespace formats_svg_kept_clip_paths_test {

namespace {

const QByteArray circle = "<clipPath id='c'><circle cx='50' cy='50' r='40'/></clipPath>";
const QByteArray ring = "<clipPath id='r' clip-path='url(#c)'><path clip-rule='evenodd' "
                        "d='M10 10H90V90H10ZM30 30H70V70H30Z'/></clipPath>";
const QByteArray content = "<path id='p' d='M0 20L100 61' stroke='red' fill='none'/>"
                           "<path d='M20 20L90 25L90 50L20 50Z' fill='blue'/>";

app::Imported readAgain(QByteArray svg, bool keeps)
{
    QBuffer in(&svg);
    in.open(QIODevice::ReadOnly);
    return *app::svg::read(in, {.keepsClipPaths = keeps}).value;
}

app::Imported read(const QByteArray& elements, bool keeps)
{
    return readAgain("<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'>" + elements
                         + "</svg>",
                     keeps);
}

QByteArray written(const app::Document& document, int precision = -1)
{
    QBuffer out;
    out.open(QIODevice::WriteOnly);
    app::svg::write(document, out, {.precision = precision});
    return out.data();
}

} // namespace

class KeptClipPathsTest : public QObject {
    Q_OBJECT

private slots:
    void theyAreSharedAndRefer()
    {
        const app::Imported kept =
            read(circle + ring + "<g clip-path='url(#r)'>" + content + "</g>"
                     + "<path clip-path='url(#c)' d='M0 0H9' stroke='red'/><path d='M1 1H9'/>",
                 true);
        const QByteArray svg = written(kept.document);
        QCOMPARE(svg.count("<clipPath "), 2);
        QCOMPARE(svg.count(" clip-path=\"url(#clearcut-clip-2)\""), 2);
        QCOMPARE(svg.count(" clip-path=\"url(#clearcut-clip-1)\""), 2); // of the ring and a line
        QCOMPARE(svg.count("clip-rule=\"evenodd\""), 1);
        QCOMPARE(kept.report.size(), std::size_t(1));
        QVERIFY(kept.report[0].remark && !kept.report[0].cut && kept.report[0].count == 3);
        QVERIFY(!app::mustSaveAs(kept.report));
    }

    /// What was kept and is then cut is what is cut at once, with every kind of clip.
    void theyHideTheSame_data()
    {
        QTest::addColumn<QByteArray>("elements");
        const auto row = [](const char* name, const QByteArray& definitions,
                            const QByteArray& attributes) {
            QTest::newRow(name) << definitions + "<g " + attributes + ">" + content + "</g>";
        };
        row("circle", circle, "clip-path='url(#c)'");
        row("ring in a circle", circle + ring, "clip-path='url(#r)'");
        row("transformed", circle + ring, "clip-path='url(#r)' transform='matrix(1 .2 0 .9 3 4)'");
        row("nothing", "<clipPath id='c'/>", "clip-path='url(#c)'");
        row("css", "", "style='clip-path: inset(20px 30px round 5px)'");
        row("two shapes",
            "<clipPath id='c'><path d='M0 0H40V60H0Z'/><path d='M30 0H60V40H30Z'/></clipPath>",
            "clip-path='url(#c)'");
        row("mask", "<mask id='m'><path fill='white' d='M5 5H60V70H5Z'/></mask>", "mask='url(#m)'");
        QTest::newRow("viewport") << "<svg x='10' y='10' width='40' height='40'>" + content
                                         + "</svg>";
    }
    void theyHideTheSame()
    {
        QFETCH(QByteArray, elements);
        const app::Document kept = read(elements, true).document;
        QCOMPARE(kept.objects().size(), std::size_t(2));
        const QByteArray svg = written(kept);
        QCOMPARE(written(readAgain(svg, true).document), svg);
        const QByteArray cut = written(read(elements, false).document, 6),
                         later = written(readAgain(svg, false).document, 6);
        QCOMPARE(later, cut);
    }

    void withoutClipPathsNothingChanges()
    {
        QCOMPARE(written(read(content, true).document), written(read(content, false).document));
        QVERIFY(!written(read(content, true).document).contains("defs"));
    }
};

} // namespace formats_svg_kept_clip_paths_test

TEST_CLASS(formats_svg_kept_clip_paths_test::KeptClipPathsTest, Core)
#include "tests/app/formats/svg/kept_clip_paths_test.moc"
