// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDir>
#include <QTest>
#include <QXmlStreamReader>

#include "tests/test_class.h"

namespace icons_test {

namespace {

const QString folder = QStringLiteral(SOURCE_DIR "/resources/icons/");
const QStringList basicShapes{"path", "circle", "ellipse", "rect", "polyline"};
const QStringList withAccent{"window.svg", "tiles.svg", "clearcut.svg"};

} // namespace

/// What the program relies on when it recolours an icon.
class IconsTest : public QObject {
    Q_OBJECT

private slots:
    void hasPlainStrokesInTwoColours_data()
    {
        QTest::addColumn<QString>("file");
        const QStringList files = QDir(folder).entryList(QDir::Files);
        QVERIFY(files.size() > 40);
        for (const QString& file : files)
            QTest::newRow(qPrintable(file)) << file;
    }

    void hasPlainStrokesInTwoColours()
    {
        QFETCH(QString, file);
        QFile in(folder + file);
        QVERIFY(in.open(QIODevice::ReadOnly));
        QXmlStreamReader xml(&in);
        QVERIFY(xml.readNextStartElement());
        QCOMPARE(xml.attributes().value("viewBox"), QStringLiteral("0 0 20 20"));
        QCOMPARE(xml.attributes().value("stroke"), QStringLiteral("#000000"));
        QCOMPARE(xml.attributes().value("stroke-width"), QStringLiteral("1.5"));
        bool accent = false;
        while (xml.readNextStartElement()) {
            QVERIFY2(basicShapes.contains(xml.name()), qPrintable(xml.name().toString()));
            const auto fill = xml.attributes().value("fill");
            const auto stroke = xml.attributes().value("stroke");
            QVERIFY(fill.isEmpty() || fill == QStringLiteral("#000000"));
            QVERIFY(stroke.isEmpty() || stroke == QStringLiteral("#C2410C"));
            accent |= !stroke.isEmpty();
            xml.skipCurrentElement();
        }
        QVERIFY2(!xml.hasError(), qPrintable(xml.errorString()));
        QCOMPARE(accent, withAccent.contains(file));
    }
};

} // namespace icons_test

TEST_CLASS(icons_test::IconsTest, None)
#include "tests/resources/icons_test.moc"
