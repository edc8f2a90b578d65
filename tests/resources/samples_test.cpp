// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/flatten.h"
#include "app/formats/format.h"

#include <QDir>
#include <QProcess>
#include <QStandardPaths>
#include <QTest>

#include "tests/app/document/sheet.h"
#include "tests/test_class.h"

namespace samples_test {

namespace {

const QString folder = QStringLiteral(SOURCE_DIR "/resources/samples/");

struct Row {
    QString key, title, file;
};

std::vector<Row> index()
{
    QFile file(folder + "index.txt");
    std::vector<Row> rows;
    if (file.open(QIODevice::ReadOnly)) {
        file.readLine();
        while (!file.atEnd()) {
            const QStringList cells = QString::fromUtf8(file.readLine()).trimmed().split(u'\t');
            rows.push_back({cells.value(0), cells.value(1), cells.value(2)});
        }
    }
    return rows;
}

std::size_t lines(const app::Sheet& sheet)
{
    std::vector<app::Chord> chords;
    const double tolerance = app::flatteningMillimetres / sheet.page.millimetresPerUnit();
    for (const app::Shape& shape : sheet.shapes)
        for (const app::Subpath& path : shape.paths)
            app::flatten(path, tolerance, chords);
    return chords.size();
}

} // namespace

class SamplesTest : public QObject {
    Q_OBJECT

private slots:
    void theIndexListsEveryDrawing()
    {
        QStringList listed;
        for (const Row& row : index())
            listed.append(row.file);
        QCOMPARE(listed.value(0), QStringLiteral("rosette.svg"));
        listed.sort();
        QCOMPARE(listed,
                 QDir(folder).entryList({QStringLiteral("*.svg")}, QDir::Files, QDir::Name));
    }

    void isReadWithoutLoss_data()
    {
        QTest::addColumn<QString>("file");
        for (const Row& row : index())
            QTest::newRow(qPrintable(row.key)) << row.file;
    }

    void isReadWithoutLoss()
    {
        QFETCH(QString, file);
        const auto read = app::readFile(folder + file);
        QVERIFY2(read, qPrintable(read.error));
        QVERIFY(read.value->report.empty());

        const app::Sheet sheet = app::sheetOf(read.value->document);
        const auto page = sheet.page.rectangle();
        QVERIFY(page.min.x < sheet.window.min.x && sheet.window.max.x < page.max.x);
        QVERIFY(page.min.y < sheet.window.min.y && sheet.window.max.y < page.max.y);
        const std::size_t count = lines(sheet);
        QVERIFY2(count > 50 && count < 60'000, qPrintable(QString::number(count)));
        for (const app::Layer& layer : sheet.layers)
            QVERIFY(!layer.name.isEmpty());
        for (const app::Shape& shape : sheet.shapes)
            QVERIFY(shape.style.stroke && !shape.style.fill);
        QVERIFY(QFileInfo(folder + file).size() < 1'000'000);
    }

    void areWhatTheScriptMakes()
    {
        const QString python = QStandardPaths::findExecutable(QStringLiteral("python3"));
        if (python.isEmpty())
            QSKIP("There is no python3 here");
        QProcess process;
        process.start(python, {folder + "make_samples.py", QStringLiteral("--check")});
        QVERIFY(process.waitForFinished(200'000));
        QVERIFY2(process.exitCode() == 0, process.readAllStandardError().constData());
    }
};

} // namespace samples_test

TEST_CLASS(samples_test::SamplesTest, None)
#include "tests/resources/samples_test.moc"
