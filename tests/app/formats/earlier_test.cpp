// SPDX-License-Identifier: GPL-3.0-or-later
// What earlier versions wrote opens as the same drawing and looks the same. The files in
// data/earlier/ were written by the writer as it was at the commit in their names, all of one
// drawing: hidden and locked layers, an empty one, hidden shapes, curves, holes, dashes, a point,
// numbers of every length, a clip window. The generations of the writer:
// - a65b602, the first: the fill of a line, which has no area, is written; no ids of layers.
// - c9d7f62: a line is written without a fill. Drawings left unsaved end with an instruction.
// - bd1048b: title, description and metadata are kept, the latter in one element with the window.
// - fd42f48: the window has an element of its own. Today's files are the same.
// CSV has been the same since 5e835f9. The version of 15e4edc wrote *.info and clipped.csv, what
// `info` and `clip` make of them.
#include "app/formats/format.h"
#include "app/recovery/leftover.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/app/command_line/program.h"
#include "tests/app/formats/lossy.h"
#include "tests/test_class.h"

namespace formats_earlier_test {

namespace {

QString path(const QString& name)
{
    return QStringLiteral(SOURCE_DIR "/tests/app/formats/data/earlier/") + name;
}

QByteArray stored(const QString& name) { return contentOf(path(name)); }

/// Metadata keep the line breaks that they have.
QByteArray inOneLine(QByteArray text) { return text.replace('\n', QByteArray()); }

/// CSV that is converted says of each row which one it was.
QByteArray withoutSources(const QByteArray& csv)
{
    QByteArray rows;
    for (const QByteArray& row : csv.trimmed().split('\n'))
        rows += row.left(row.lastIndexOf(',')) + '\n';
    return rows;
}

} // namespace

class EarlierTest : public QObject {
    Q_OBJECT

private slots:
    void aDrawing_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("today"); // what it is today, saved again
        QTest::newRow("the first") << "plan-a65b602.svg"
                                   << "plan-0827a8d.svg";
        QTest::newRow("lines unfilled") << "plan-c9d7f62.svg"
                                        << "plan-0827a8d.svg";
        QTest::newRow("with metadata") << "plan-bd1048b.svg"
                                       << "plan-metadata-0827a8d.svg";
        QTest::newRow("the window apart") << "plan-fd42f48.svg"
                                          << "plan-metadata-0827a8d.svg";
        QTest::newRow("left unsaved") << "leftover-c9d7f62.svg"
                                      << "plan-0827a8d.svg";
        QTest::newRow("a style for each object") << "plan-0827a8d.svg"
                                                 << "plan-0827a8d.svg";
    }
    void aDrawing()
    {
        QFETCH(QString, file);
        QFETCH(QString, today);
        const auto read = app::readFile(path(file));
        QVERIFY2(read, qPrintable(read.error));
        QVERIFY(!isLossy(*read.value));
        QCOMPARE(clearcut({"info", path(file)}).out, stored("plan.info"));
        QCOMPARE(clearcut({"clip", path(file), "--to", "csv", "-o", "-"}).out,
                 stored("clipped.csv"));
        const auto again = clearcut({"convert", path(file), "--to", "svg", "-o", "-"});
        QCOMPARE(inOneLine(again.out), inOneLine(stored(today)));
    }

    void allLookTheSame()
    {
        const QStringList options{"--to", "png", "--dpi", "50", "-o", "-"};
        const auto picture = [&](const char* file) {
            return clearcut(QStringList{"convert", path(file)} + options).out;
        };
        const QByteArray first = picture("plan-a65b602.svg");
        QVERIFY(first.size() > 1000);
        for (const char* file :
             {"plan-c9d7f62.svg", "plan-bd1048b.svg", "plan-fd42f48.svg", "plan-0827a8d.svg"})
            QVERIFY2(picture(file) == first, file);
    }

    void lines()
    {
        const QString file = path("plan-5e835f9.csv");
        QCOMPARE(clearcut({"info", file}).out, stored("lines.info"));
        const auto again = clearcut({"convert", file, "--to", "csv", "-o", "-"});
        QCOMPARE(withoutSources(again.out), stored("plan-5e835f9.csv"));
    }

    void aDrawingLeftUnsavedIsOffered()
    {
        const QTemporaryDir folder;
        QVERIFY(QFile::copy(path("leftover-c9d7f62.svg"), folder.filePath("left.svg")));
        const auto found = app::claimLeftovers(folder.path());
        QCOMPARE(found.size(), std::size_t(1));
        const app::Origin origin{"plan.svg", "/home/someone/plan \"A\".svg",
                                 QDateTime::fromMSecsSinceEpoch(1'763'721'600'000)};
        QVERIFY(found[0].origin == origin);
        QCOMPARE(found[0].ended.toMSecsSinceEpoch(), 1'763'721'700'000);
    }
};

} // namespace formats_earlier_test

TEST_CLASS(formats_earlier_test::EarlierTest, Core)
#include "tests/app/formats/earlier_test.moc"
