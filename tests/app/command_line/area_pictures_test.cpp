// SPDX-License-Identifier: GPL-3.0-or-later
#include <QImage>
#include <QTest>

#include <glm/glm.hpp>

#include <cmath>

#include "tests/app/command_line/program.h"
#include "tests/test_class.h"

namespace command_line_area_pictures_test {

// A filled ring with a stroke, cut by the program, beside librsvg's picture of the same ring with
// an SVG clipPath.

namespace {

using Point = glm::dvec2;
constexpr int pixels = 800;
constexpr double scale = 8; // pixels to the unit
constexpr double strokeWidth = 1;

struct Window {
    QString option;  ///< for -w
    QByteArray clip; ///< for the clipPath
    double (*toBorder)(const Point& p);
};

double toCircle(const Point& p) { return std::abs(glm::distance(p, Point(55, 45)) - 30); }

double toRectangle(const Point& p)
{
    const double angle = glm::radians(30.0); // counterclockwise on the screen: y points down
    const Point way = p - Point(50, 50);
    const Point own(way.x * std::cos(angle) - way.y * std::sin(angle),
                    way.x * std::sin(angle) + way.y * std::cos(angle));
    const Point beyond = glm::abs(own) - Point(35, 20);
    return beyond.x > 0 && beyond.y > 0 ? glm::length(beyond)
                                        : std::abs(std::max(beyond.x, beyond.y));
}

const Window circle{"circle:55,45,30", "<circle cx='55' cy='45' r='30'/>", toCircle};
const Window rectangle{"15,30,85,70@30",
                       "<rect x='15' y='30' width='70' height='40' transform='rotate(-30 50 50)'/>",
                       toRectangle};

QByteArray svg(const QByteArray& style, const QByteArray& clip)
{
    QByteArray ring = "<path fill='#c33' fill-rule='evenodd' " + style
                      + " d='M90,50 A40,40 0 1 1 10,50 A40,40 0 1 1 90,50 Z "
                        "M65,50 A15,15 0 1 1 35,50 A15,15 0 1 1 65,50 Z'/>";
    if (!clip.isEmpty())
        ring = "<clipPath id='c'>" + clip + "</clipPath><g clip-path='url(#c)'>" + ring + "</g>";
    return "<svg xmlns='http://www.w3.org/2000/svg' width='800' height='800' "
           "viewBox='0 0 100 100'>"
           + ring + "</svg>";
}

// Whether a pixel of one picture has its colour within a pixel's distance in the other one.
bool isNear(const QImage& a, const QImage& b, int x, int y)
{
    const auto distance = [](QRgb p, QRgb q) {
        return std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                         std::abs(qBlue(p) - qBlue(q))});
    };
    constexpr int most = 64;
    for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
            if (distance(a.pixel(x, y), b.pixel(x + dx, y + dy)) <= most)
                return true;
    return false;
}

} // namespace

class AreaPicturesTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString path(const char* name) const { return folder_.filePath(name); }

    QImage picture(const QString& svg) const
    {
        const QString png = path("picture.png");
        runProgram("rsvg-convert", {"-b", "white", "-o", png, svg});
        return QImage(png).convertToFormat(QImage::Format_RGB32);
    }

private slots:
    void aCutRingLooksLikeAMaskedOne_data()
    {
        QTest::addColumn<bool>("isCircle");
        QTest::addColumn<bool>("stroked");
        for (const bool isCircle : {true, false})
            for (const bool stroked : {true, false})
                QTest::addRow("%s, %s", isCircle ? "circle" : "rotated rectangle",
                              stroked ? "stroked" : "filled alone")
                    << isCircle << stroked;
    }
    void aCutRingLooksLikeAMaskedOne()
    {
        QFETCH(bool, isCircle);
        QFETCH(bool, stroked);
        const Window& window = isCircle ? circle : rectangle;
        const QByteArray style =
            stroked ? QByteArrayLiteral("stroke='#036' stroke-width='1'") : QByteArray();
        writeText(path("art.svg"), svg(style, {}));
        writeText(path("masked.svg"), svg(style, window.clip));
        const auto run =
            clearcut({"clip", path("art.svg"), "-o", path("cut.svg"), "-w", window.option});
        QVERIFY2(run.code == 0, run.err);
        const QImage cut = picture(path("cut.svg")), masked = picture(path("masked.svg"));
        QCOMPARE(cut.size(), QSize(pixels, pixels));
        QCOMPARE(masked.size(), cut.size());
        int painted = 0, wrong = 0;
        for (int y = 1; y + 1 < pixels; ++y)
            for (int x = 1; x + 1 < pixels; ++x) {
                painted += cut.pixel(x, y) != qRgb(255, 255, 255);
                // Where a stroke ends, a mask cuts its ink, and a cut its centre line.
                if (stroked && window.toBorder(Point(x + 0.5, y + 0.5) / scale) < strokeWidth)
                    continue;
                wrong += !isNear(cut, masked, x, y) || !isNear(masked, cut, x, y);
            }
        QVERIFY(painted > 100'000);
        QCOMPARE(wrong, 0);
    }
};

} // namespace command_line_area_pictures_test

TEST_CLASS(command_line_area_pictures_test::AreaPicturesTest, Core)
#include "tests/app/command_line/area_pictures_test.moc"
