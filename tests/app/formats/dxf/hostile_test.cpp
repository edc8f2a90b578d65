// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are small and would become huge, and thousands of damaged ones: each is either read or
// refused in a sentence, within seconds.
#include "app/base/finite.h"
#include "app/formats/svg/writer.h"

#include <QTest>

#include <random>

#include "tests/app/formats/dxf/file.h"
#include "tests/test_class.h"

namespace formats_dxf_hostile_test {

using namespace app;
using tests::dxf::file;
using tests::dxf::report;
using tests::dxf::section;
using tests::dxf::sheet;

namespace {

const QByteArray oneLine = "0|LINE|8|0|11|1|21|1";

QByteArray block(const QByteArray& name, const QByteArray& content)
{
    return "0|BLOCK|2|" + name + "|70|0|10|0|20|0|" + content + "|0|ENDBLK|";
}

/// A file with an entity of every type that is read.
QByteArray everything()
{
    return file(
        oneLine
            + "|0|LWPOLYLINE|90|3|70|1|43|2|10|0|20|0|42|0.5|10|4|20|0|10|4|20|4"
              "|0|POLYLINE|66|1|70|1|0|VERTEX|10|1|20|1|42|1|0|VERTEX|10|3|20|1|0|SEQEND"
              "|0|ARC|10|1|20|2|40|3|50|10|51|200|0|CIRCLE|10|5|20|5|40|2"
              "|0|ELLIPSE|10|1|20|1|11|3|21|1|40|0.4|41|0.2|42|5"
              "|0|SPLINE|71|3|40|0|40|0|40|0|40|0|40|1|40|1|40|1|40|1|41|1|41|2|41|1|41|1|10|0|20|"
              "0|"
              "10|1|20|3|10|3|20|3|10|4|20|0"
              "|0|SPLINE|71|3|11|0|21|0|11|2|21|3|11|5|21|1"
              "|0|INSERT|2|B|10|3|20|4|41|2|42|-1|50|30|70|2|71|2|44|9|45|9"
              "|0|TEXT|10|0|20|0|40|3|1|abc %%d|72|1|11|5|21|5|0|MTEXT|40|2|41|9|71|5|1|{\\fA;a b} "
              "c\\Pd"
              "|0|HATCH|2|SOLID|70|1|91|2|92|2|72|0|73|1|93|3|10|0|20|0|10|1|20|0|10|1|20|1|92|1|"
              "93|2|"
              "72|1|10|0|20|0|11|1|21|1|72|2|10|0|20|0|40|1|50|0|51|90|73|0|75|0"
              "|0|SOLID|10|0|20|0|11|1|21|0|12|0|22|1|13|1|23|1|210|0|220|0.6|230|-0.8"
              "|0|LEADER|72|1|10|0|20|0|10|4|20|1|10|5|20|5|0|DIMENSION|2|B|0|POINT|10|1",
        section("TABLES", "0|LTYPE|2|D|49|3|49|-1|0|LAYER|2|0|62|3|6|D|370|50|0|STYLE|2|S|41|0.8")
            + section("BLOCKS", block("B", oneLine).chopped(1)));
}

class Damage {
public:
    explicit Damage(unsigned seed) : random_(seed) {}

    QByteArray of(QByteArray text)
    {
        for (auto n = 1 + below(3); n > 0 && !text.isEmpty(); --n)
            once(text);
        return text;
    }

private:
    qsizetype below(qsizetype n) { return qsizetype(random_() % std::size_t(n)); }

    void once(QByteArray& text)
    {
        static const QByteArrayList values{"1e99",   "-1e308", "nan",        "0", "-1",
                                           "1e-320", "",       "2147483647", "x", "\xff",
                                           "256",    "B",      "1e15"};
        QByteArrayList lines = text.split('|');
        const auto at = below(lines.size());
        switch (below(5)) {
        case 0:
            lines[at] = values[below(values.size())];
            break;
        case 1:
            lines.removeAt(at);
            break;
        case 2:
            lines.insert(at, lines[below(lines.size())]);
            break;
        case 3:
            lines = lines.mid(0, at);
            break;
        default:
            for (qsizetype i = 0, from = below(lines.size()); i < 8 && from + i < lines.size(); ++i)
                lines.insert(at + i, lines[from + i]);
            break;
        }
        text = lines.join('|');
    }

    std::mt19937_64 random_;
};

bool isDrawable(const Document& document)
{
    bool finite = true;
    document.objects().forEach(0, document.objects().size(), [&](std::size_t, const ObjectView& o) {
        o.path().forEachPoint([&](const Point& p) { finite = finite && isFinite(p); });
    });
    QBuffer svg;
    svg.open(QIODevice::ReadWrite);
    if (!finite || findFormat(u"svg")->write(document, svg, {}))
        return false;
    svg.seek(0);
    const auto again = findFormat(u"svg")->read(svg);
    return again && again.value->document.objects().size() == document.objects().size();
}

} // namespace

class DxfHostileTest : public QObject {
    Q_OBJECT

private slots:
    void arraysAndNestedBlocksAreLimited()
    {
        const QByteArray array = file("0|INSERT|2|B|70|32767|71|32767",
                                      section("BLOCKS", block("B", oneLine).chopped(1)));
        const QString error = tests::dxf::read(array).error;
        QVERIFY2(error.startsWith("line ")
                     && error.endsWith("inserts blocks too often: more than 50,000,000 values of "
                                       "their entities would be read."),
                 qPrintable(error));
        QByteArray blocks = block("B0", oneLine);
        for (int i = 1; i < 12; ++i)
            blocks += block("B" + QByteArray::number(i),
                            "0|INSERT|70|10|2|B" + QByteArray::number(i - 1));
        const auto result =
            tests::dxf::read(file("0|INSERT|2|B11", section("BLOCKS", blocks.chopped(1))));
        QVERIFY(!result);
    }
    void blocksAreNestedToALimit()
    {
        QByteArray blocks = block("B0", oneLine);
        for (int i = 1; i < 60; ++i)
            blocks +=
                block("B" + QByteArray::number(i), "0|INSERT|2|B" + QByteArray::number(i - 1));
        const QStringList lines =
            report(file("0|INSERT|2|B59|0|INSERT|2|B49", section("BLOCKS", blocks.chopped(1))));
        QCOMPARE(lines.back(), QStringLiteral("1 insertion nested more than 50 deep"));
    }
    // A count that the file announces is never believed.
    void announcedCountsDoNotMatter()
    {
        const Sheet drawing = sheet(file(
            "0|LWPOLYLINE|90|1073741825|10|0|20|0|10|1|20|1|"
            "0|SPLINE|71|3|72|-5|73|2147483647|11|0|21|0|11|1|21|1|"
            "0|HATCH|91|1000000000|92|2|72|0|73|1|93|1000000000|10|0|20|0|10|1|20|0|10|1|20|1"));
        QCOMPARE(drawing.shapes.size(), 3u);
    }
    void numbersBeyondAllDrawingsAreTold()
    {
        const QByteArray blocks =
            block("A", "0|INSERT|2|B|41|1e99") + block("B", "0|INSERT|2|C|41|1e99")
            + block("C", "0|INSERT|2|D|41|1e99") + block("D", "0|LINE|10|1e99|11|2e99");
        QCOMPARE(report(file("0|LINE|10|1e101|0|ARC|40|1|50|1e99|51|0|0|INSERT|2|A|41|1e99",
                             section("BLOCKS", blocks.chopped(1)))),
                 (QStringList{"2 damaged entities of the type “LINE”",
                              "4 inserted blocks became separate shapes"}));
    }
    void largeWholeNumbersAreTold()
    {
        QCOMPARE(report(file("0|LINE|11|1|62|-2147483648|0|LINE|11|1|62|1e300|0|LINE|11|1|62|1.0")),
                 QStringList{"2 damaged entities of the type “LINE”"});
    }
    void manyLayersBecomeOne()
    {
        QByteArray entities;
        for (int i = 0; i < 1500; ++i)
            entities += "0|LINE|11|1|8|L" + QByteArray::number(i) + '|';
        const QByteArray text = file(entities.chopped(1));
        QCOMPARE(sheet(text).layers.size(), 1000u);
        QCOMPARE(report(text), QStringList{"500 layers beyond the first 1,000"});
    }
    void longTextsAndLines()
    {
        const QByteArray text = file("0|TEXT|40|1|1|" + QByteArray(20'000, 'a') + "|0|MTEXT|40|1|1|"
                                     + QByteArray(90'000, 'b'));
        QCOMPARE(report(text), QStringList{"2 texts of more than 10,000 letters"});
        const QByteArray name = QByteArray(5'000, 'n');
        QCOMPARE(sheet(file("0|LINE|11|1|8|" + name)).layers.at(0).name, QString(name));
    }
    void everyEntityIsRead()
    {
        const auto imported = tests::dxf::read(everything());
        QVERIFY(imported);
        QCOMPARE(imported.value->document.objects().size(), 19u);
        QVERIFY(isDrawable(imported.value->document));
    }
    void damagedFilesAreReadOrRefused()
    {
        constexpr int cases = 6'000;
        const QByteArray whole = everything();
        Damage damage(1);
        int read = 0;
        for (int i = 0; i < cases; ++i) {
            const QByteArray text = damage.of(whole);
            const auto result = tests::dxf::read(text);
            if (!result) {
                QVERIFY2(result.error.endsWith('.') && !result.error.contains('\n'),
                         result.error.toUtf8() + " <- " + text);
                continue;
            }
            ++read;
            if (i % 10 == 0)
                QVERIFY2(isDrawable(result.value->document), text);
        }
        QVERIFY(read > cases / 2 && read < cases);
    }
};

} // namespace formats_dxf_hostile_test

TEST_CLASS(formats_dxf_hostile_test::DxfHostileTest, None)
#include "tests/app/formats/dxf/hostile_test.moc"
