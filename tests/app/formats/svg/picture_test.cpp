// SPDX-License-Identifier: GPL-3.0-or-later
// What was read and written again looks as the original does, to another program.
#include <QDir>
#include <QImage>
#include <QProcess>
#include <QTest>

#include <random>

#include "tests/app/formats/svg/text.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace formats_svg_picture_test {

namespace {

constexpr int side = 600;               // pixels of the larger side of a picture
constexpr double strongDifference = 64; // of 255: more than the rounding of edges
constexpr double fewStrong = 0.002, smallMean = 0.5;

QImage picture(const QByteArray& svg)
{
    QProcess rsvg;
    const QString size = QString::number(side);
    rsvg.start("rsvg-convert",
               {"-w", size, "-h", size, "--keep-aspect-ratio", "-b", "white", "-f", "png"});
    rsvg.write(svg);
    rsvg.closeWriteChannel();
    if (!rsvg.waitForFinished() || rsvg.exitCode() != 0)
        return {};
    return QImage::fromData(rsvg.readAllStandardOutput()).convertToFormat(QImage::Format_RGB32);
}

struct Difference {
    double mean = 255, strong = 1;
};

Difference difference(const QImage& a, const QImage& b)
{
    if (a.isNull() || a.size() != b.size())
        return {};
    double sum = 0, strong = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
            const int largest =
                std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                          std::abs(qBlue(p) - qBlue(q))});
            sum += largest;
            strong += largest > strongDifference;
        }
    const double pixels = double(a.width()) * a.height();
    return {sum / pixels, strong / pixels};
}

// A drawing in clip paths in one another, each of one shape: librsvg 2.54 takes several shapes of a
// clip path for one path with one rule.
class RandomClips {
public:
    explicit RandomClips(unsigned seed) : random_(seed) {}

    QByteArray drawing()
    {
        QByteArray clips, groups, ends, content;
        for (int i = 0; i <= below(3); ++i) {
            const QByteArray id = "c" + QByteArray::number(i);
            clips += "<clipPath id='" + id + "'>" + shape(turn()) + "</clipPath>";
            groups += "<g clip-path='url(#" + id + ")'" + turn() + ">";
            ends += "</g>";
        }
        for (const char* fill : {"gold", "teal", "plum"})
            content += shape(turn() + " fill='" + fill + "'");
        for (const char* dashes : {"none", "4 2"})
            content +=
                shape(turn() + " fill='none' stroke='#000' stroke-dasharray='" + dashes + "'");
        return ::drawing(clips + groups + content + ends);
    }

private:
    int below(int n) { return int(random_() % unsigned(n)); }
    QByteArray place() { return QByteArray::number(below(1000) / 10.0) + ' '; }
    QByteArray places(int count) { return count == 0 ? QByteArray() : place() + places(count - 1); }
    QByteArray turn() { return " transform='rotate(" + place() + "50 50)'"; }

    QByteArray shape(const QByteArray& attributes)
    {
        const QByteArray rule = below(2) == 0 ? "evenodd" : "nonzero";
        const QByteArray more = attributes + " clip-rule='" + rule + "' fill-rule='" + rule + "'/>";
        if (below(3) == 0)
            return "<ellipse cx='" + place() + "' cy='" + place() + "' rx='" + place() + "' ry='"
                   + place() + "'" + more;
        QByteArray path = "<path d='M" + places(2);
        for (int i = 0; i < 3 + below(4); ++i)
            path += below(2) == 0 ? "L" + places(2) : "C" + places(6);
        return path + "z'" + more;
    }

    std::mt19937 random_;
};

} // namespace

class PictureTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY2(QProcess::execute("rsvg-convert", {"--version"}) == 0,
                 "rsvg-convert is missing: install librsvg2-bin");
    }

    void looksLikeTheOriginal_data()
    {
        QTest::addColumn<QString>("path");
        for (const char* place : {"/tests/app/formats/data", "/resources/samples"}) {
            const QDir folder(SOURCE_DIR + QString(place));
            for (const QString& name : notEmpty(folder.entryList({"*.svg"})))
                QTest::newRow(qPrintable(name)) << folder.filePath(name);
        }
    }
    void looksLikeTheOriginal()
    {
        QFETCH(QString, path);
        const QByteArray original = contentOf(path);
        const auto read = readText(original);
        QVERIFY2(read, qPrintable(read.error));
        const QImage expected = picture(original);
        QVERIFY(!expected.isNull());
        const Difference found = difference(expected, picture(textOf(read.value->document)));
        const auto said = QStringLiteral("mean %1, strong %2").arg(found.mean).arg(found.strong);
        QVERIFY2(found.mean < smallMean && found.strong < fewStrong, qPrintable(said));
    }

    void randomClipPathsLookLikeTheOriginal()
    {
        for (unsigned seed = 0; seed < 40; ++seed) {
            const QByteArray original = RandomClips(seed).drawing();
            const auto read = readText(original);
            QVERIFY2(read, qPrintable(read.error));
            const Difference found =
                difference(picture(original), picture(textOf(read.value->document)));
            const auto said = QStringLiteral("seed %1: mean %2, strong %3")
                                  .arg(seed)
                                  .arg(found.mean)
                                  .arg(found.strong);
            QVERIFY2(found.mean < smallMean && found.strong < fewStrong, qPrintable(said));
        }
    }

    // The comparison can fail: one line less is seen.
    void aMissingLineIsSeen()
    {
        const auto read = readText(contentOf(SOURCE_DIR "/tests/app/formats/data/groups.svg"));
        QVERIFY(read);
        const QImage whole = picture(textOf(read.value->document));
        app::Sheet less = app::sheetOf(read.value->document);
        less.shapes.pop_back();
        QVERIFY(difference(whole, picture(textOf(less))).strong > fewStrong);
    }
};

} // namespace formats_svg_picture_test

TEST_CLASS(formats_svg_picture_test::PictureTest, Gui)
#include "tests/app/formats/svg/picture_test.moc"
