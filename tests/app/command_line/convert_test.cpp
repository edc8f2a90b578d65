// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_convert_test {

namespace {

const QByteArray drawing = "<svg xmlns='http://www.w3.org/2000/svg' width='100' height='100'>"
                           "<clipPath id='c'><circle cx='50' cy='50' r='40'/></clipPath>"
                           "<g clip-path='url(#c)'><path d='M0 20L100 61' stroke='red'/></g></svg>";

QStringList convert(const QStringList& more)
{
    return QStringList{"convert", "-", "-o", "-"} + more;
}

} // namespace

class ConvertTest : public QObject {
    Q_OBJECT

private slots:
    void clipPathsAreCutOrKept()
    {
        const QStringList svg{"--from", "svg", "--to", "svg"};
        const auto cut = clearcut(convert(svg), drawing),
                   same = clearcut(convert(svg + QStringList{"--clip-paths", "cut"}), drawing),
                   kept = clearcut(convert(svg + QStringList{"--clip-paths", "keep"}), drawing);
        QVERIFY(!cut.out.contains("clipPath") && cut.err.contains("replaced by a real cut"));
        QCOMPARE(same.out, cut.out);
        QVERIFY(kept.out.contains("<clipPath ") && kept.out.contains("x2=\"100\""));
        QVERIFY2(kept.err.contains("clip path was kept"), kept.err);
    }

    void onlySvgFilesKeepThem()
    {
        for (const char* type : {"pdf", "dxf", "png"}) {
            const auto none =
                clearcut(convert({"--from", "svg", "--to", type, "--clip-paths", "keep"}), drawing);
            QCOMPARE(none.code, 2);
            QVERIFY2(none.err.contains("only svg files have clip paths"), none.err);
        }
        const auto lines = clearcut(
            convert({"--from", "csv", "--to", "svg", "--clip-paths", "keep"}), "0,0,9,9\n");
        QCOMPARE(lines.code, 2);
        const auto what =
            clearcut(convert({"--from", "svg", "--to", "svg", "--clip-paths", "maybe"}), drawing);
        QCOMPARE(what.code, 2);
        QVERIFY2(what.err.contains("cut or keep"), what.err);
    }
};

} // namespace command_line_convert_test

TEST_CLASS(command_line_convert_test::ConvertTest, Core)
#include "tests/app/command_line/convert_test.moc"
