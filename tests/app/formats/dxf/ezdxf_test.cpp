// SPDX-License-Identifier: GPL-3.0-or-later
// What an independent reader of DXF says of our files.
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <random>

#include "tests/app/formats/dxf/tags_of.h"
#include "tests/test_class.h"

namespace dxf_ezdxf_test {

using namespace app;

namespace {

/// Prints the faults of a file, then each entity with its points.
const QString script = QStringLiteral(R"(
import sys, ezdxf
documents = [ezdxf.readfile(name) for name in sys.argv[1:]]
for document in documents:
    audit = document.audit()
    for fault in audit.errors + audit.fixes:
        print("FAULT", fault.code, fault.message)
for e in (e for document in documents for e in document.modelspace()):
    kind = e.dxftype()
    points = {
        "LINE": lambda: [e.dxf.start, e.dxf.end],
        "LWPOLYLINE": lambda: list(e.get_points("xy")),
        "POLYLINE": lambda: [v.dxf.location for v in e.vertices],
        "SPLINE": lambda: [e.control_points[0], e.control_points[-1]],
        "ARC": lambda: [e.start_point, e.end_point],
        "ELLIPSE": lambda: [e.start_point, e.end_point],
        "CIRCLE": lambda: [e.dxf.center],
        "POINT": lambda: [e.dxf.location],
    }[kind]()
    print(kind, e.dxf.layer, *("%r %r" % (p[0], p[1]) for p in points))
)");

QString python()
{
    QString found = QStandardPaths::findExecutable("python3", {"/usr/bin"}); // of the packages
    return found.isEmpty() ? QStandardPaths::findExecutable("python3") : found;
}

bool hasEzdxf()
{
    QProcess process;
    process.start(python(), {"-c", "import ezdxf"});
    return process.waitForFinished(60'000) && process.exitCode() == 0;
}

QStringList linesOf(const QByteArrayList& files)
{
    QTemporaryDir folder;
    QStringList arguments{"-c", script};
    for (const QByteArray& file : files) {
        arguments << folder.filePath(QStringLiteral("%1.dxf").arg(arguments.size()));
        QFile out(arguments.last());
        if (!out.open(QIODevice::WriteOnly) || out.write(file) != file.size())
            return {"not written"};
    }
    QProcess process;
    process.setProcessChannelMode(QProcess::MergedChannels);
    process.start(python(), arguments);
    process.waitForFinished(200'000);
    return QString::fromUtf8(process.readAll()).split('\n', Qt::SkipEmptyParts);
}

/// Objects of all kinds, at random.
QByteArray randomElements(std::mt19937& bits)
{
    const auto number = [&] { return QByteArray::number(int(bits() % 1000) / 10.0); };
    QByteArray all;
    for (int i = 0; i < 40; ++i) {
        const QByteArray look = " stroke='#" + QByteArray::number(bits() % 900 + 100) + "'"
                                + (i % 5 == 0 ? " stroke-dasharray='" + number() + " 1'" : "");
        const QList<QByteArray> kinds{
            "<path d='M" + number() + ' ' + number() + "L" + number() + ' ' + number() + "'",
            "<path d='M1 1L" + number() + ' ' + number() + "L5 9Z'",
            "<circle cx='" + number() + "' cy='" + number() + "' r='" + number() + "'",
            "<ellipse cx='" + number() + "' cy='9' rx='" + number() + "' ry='3'",
            "<path d='M1 1C" + number() + " 3 9 " + number() + " 5 5L9 9'",
            "<path d='M10 10A20 20 0 0 1 30 30'",
            "<rect x='1' y='2' width='50' height='40' rx='" + number() + "'",
            "<path d='M" + number() + " 1h0' stroke-linecap='round'",
        };
        all += kinds[qsizetype(bits() % std::size_t(kinds.size()))] + look + "/>";
    }
    return all
           + "<g inkscape:groupmode='layer' inkscape:label='W\xc3\xa4nde &lt;1&gt;'>"
             "<path d='M1 1L2 2'/></g>";
}

} // namespace

class EzdxfTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        if (!hasEzdxf())
            QSKIP("There is no ezdxf here (python3-ezdxf)");
    }

    void noFaultIsFound()
    {
        std::mt19937 bits(11);
        QByteArrayList files;
        for (int i = 0; i < 8; ++i)
            for (const DxfVersion version : {DxfVersion::R2000, DxfVersion::R12})
                files << dxfOfSvg(randomElements(bits), {.dxf = version});
        const QStringList lines = linesOf(files);
        QVERIFY2(lines.size() >= 16 * 41, qPrintable(lines.join('\n')));
        for (const QString& line : lines)
            QVERIFY2(!line.startsWith("FAULT"), qPrintable(line));
    }

    void pointsAreReadBitForBit()
    {
        const QByteArray drawing = "<path d='M0.1 0.2L33.333333333333336 1e-9'/>"
                                   "<path d='M0.1 0.2L7 8L3 4'/>"
                                   "<path d='M0.1 0.2C1 9 2 4 3 0.3'/>";
        QCOMPARE(linesOf({dxfOfSvg(drawing)}),
                 (QStringList{"LINE Drawing 0.1 99.8 33.333333333333336 99.999999999",
                              "LWPOLYLINE Drawing 0.1 99.8 7.0 92.0 3.0 96.0",
                              "SPLINE Drawing 0.1 99.8 3.0 99.7"}));
    }
};

} // namespace dxf_ezdxf_test

TEST_CLASS(dxf_ezdxf_test::EzdxfTest, Core)
#include "tests/app/formats/dxf/ezdxf_test.moc"
