// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure.h"
#include "app/teaching/figure_labels.h"
#include "app/teaching/near_frame.h"
#include "app/teaching/page_figure.h"

#include <QImage>
#include <QPainter>
#include <QTest>

#include <algorithm>
#include <random>
#include <span>

#include "tests/test_class.h"

namespace teaching_figure_test {

using namespace app;

namespace {

constexpr clipping::Window window{{-100, -75}, {100, 75}};
const QSizeF size(900, 560);

QFont font()
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(13);
    return font;
}

TracedLine tracedLine(std::string_view key, const clipping::Segment& line,
                      const clipping::Window& w = window, YAxis y = YAxis::Up)
{
    return {{clipping::findAlgorithm(key), clipping::Form::Corrected}, line, w, y, {}};
}

QByteArray told(const TracedLine& s, std::size_t step)
{
    const auto& [a, b] = s.line;
    return QStringLiteral("%1 %2,%3,%4,%5 window %6,%7,%8,%9 step %10")
        .arg(keyOf(s.variant))
        .arg(a.x, 0, 'g', 17)
        .arg(a.y, 0, 'g', 17)
        .arg(b.x, 0, 'g', 17)
        .arg(b.y, 0, 'g', 17)
        .arg(s.window.min.x)
        .arg(s.window.min.y)
        .arg(s.window.max.x)
        .arg(s.window.max.y)
        .arg(step + 1)
        .toUtf8();
}

/// Whether a stretch meets a box, from corner to corner: sides of the stretch, then bounds.
bool meets(const QLineF& line, const QRectF& box)
{
    const auto side = [&](const QPointF& p) {
        return line.dx() * (p.y() - line.y1()) - line.dy() * (p.x() - line.x1());
    };
    const double a = side(box.topLeft()), b = side(box.topRight()), c = side(box.bottomLeft()),
                 d = side(box.bottomRight());
    const bool apart = (a > 0 && b > 0 && c > 0 && d > 0) || (a < 0 && b < 0 && c < 0 && d < 0);
    return !apart && std::max(line.x1(), line.x2()) >= box.left()
           && std::min(line.x1(), line.x2()) <= box.right()
           && std::max(line.y1(), line.y2()) >= box.top()
           && std::min(line.y1(), line.y2()) <= box.bottom();
}

QImage painted(const TracedLine& s, std::size_t step, Ground ground)
{
    QImage image(size.toSize(), QImage::Format_RGB32);
    QPainter painter(&image);
    paintStep(painter, {s, narrationOf(s), step}, figureFrame(s, size, font()),
              figureColours(ground));
    return image;
}

/// Whether a point of the drawing has a colour, there or a pixel off: strokes have soft edges.
bool hasColour(const QImage& image, const FigureFrame& frame, const Point& point,
               const QColor& colour, const QPointF& aside = {})
{
    const QPoint at = (frame.at(point) + aside).toPoint();
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            if (image.pixelColor(at + QPoint(x, y)) == colour)
                return true;
    return false;
}

double length(const clipping::Segment& s) { return std::hypot(s.b.x - s.a.x, s.b.y - s.a.y); }

/// Whether a box is clear of other labels and of all marks.
bool isFree(const QRectF& box, std::span<const FigureLabel> others,
            std::span<const FigureMark> marks)
{
    return std::ranges::none_of(others,
                                [&](const FigureLabel& other) { return box.intersects(other.box); })
           && std::ranges::none_of(
               marks, [&](const FigureMark& mark) { return box.contains(mark.place); });
}

} // namespace

class FigureTest : public QObject {
    Q_OBJECT

    /// Random lines: some long, some short, some parallel to an axis, some a point, some with ends
    /// on edges, and a third with a window that is thin or a point.
    TracedLine anyTracedLine(const Variant& variant)
    {
        std::uniform_real_distribution<double> anywhere(-250, 250);
        std::uniform_int_distribution<int> kind(0, 8), onGrid(-3, 3);
        const auto point = [&] { return Point(anywhere(random_), anywhere(random_)); };
        TracedLine s{
            variant, {point(), point()}, window, kind(random_) % 2 ? YAxis::Up : YAxis::Down, {}};
        switch (kind(random_)) {
        case 0:
            s.line.b = s.line.a + 0.02 * s.line.b;
            break;
        case 1:
            s.line.b = 1e4 * s.line.b;
            break;
        case 2:
            s.line.b.y = s.line.a.y;
            break;
        case 3:
            s.line.b = s.line.a;
            break;
        case 4:
            s.line = {{50 * onGrid(random_), 37.5 * onGrid(random_)},
                      {50 * onGrid(random_), 37.5 * onGrid(random_)}};
            break;
        case 5:
            s.window.max.x = s.window.min.x;
            break;
        case 6:
            s.window.min = s.window.max;
            break;
        default:
            break;
        }
        return s;
    }
    std::mt19937_64 random_{8};

private slots:
    void windowOfADrawingWithoutOneIsLabelledPage()
    {
        TracedLine s = tracedLine("exact", {{-150, -20}, {150, 30}});
        const Narration narration = narrationOf(s);
        const FigureFrame frame = figureFrame(s, size, font());
        const auto names = [&](const QString& name) {
            return std::ranges::count(figureLabels(s, narration, stepScene(s, narration, 0), frame),
                                      name, &FigureLabel::head);
        };
        QCOMPARE(names("Clip window"), 1);
        s.windowIsPage = true;
        QCOMPARE(names("Clip window"), 0);
        QCOMPARE(names("Page"), 1);
    }
    void marksAreWhereTheNumbersAre()
    {
        const TracedLine s = tracedLine("matthes-drakopoulos", {{-160, -30}, {70, 130}});
        const Narration narration = narrationOf(s);
        FigureFrame frame = figureFrame(s, size, font());
        const StepScene last = stepScene(s, narration, narration.steps.size() - 1);
        const auto marks = figureMarks(s, last, frame);
        QCOMPARE(marks.size(), 4);
        // One scale on both axes, y up, the middle of window and line in the picture's middle.
        const double scale = size.width() / (frame.seen.max.x - frame.seen.min.x);
        const Point middle((-160 + 100) / 2.0, (-75 + 130) / 2.0);
        for (const FigureMark& mark : marks) {
            const QPointF expected(size.width() / 2 + (mark.point.x - middle.x) * scale,
                                   size.height() / 2 - (mark.point.y - middle.y) * scale);
            QVERIFY(QLineF(mark.place, expected).length() < 1e-6);
        }
        QCOMPARE(marks[0].point, Point(-160, -30));
        QCOMPARE(marks[1].point, Point(70, 130));
        QCOMPARE(marks[2].point.x, -100.0);
        QCOMPARE(marks[3].point, Point(-9.0625, 75));
        QCOMPARE(marks[3].head, "\u22129.0625, 75");
        QVERIFY(marks[3].detail.startsWith("cut at the top edge, step "));
        frame.countsSteps = false; // a lesson's page shows no steps
        QCOMPARE(figureMarks(s, last, frame)[3].detail, "cut at the top edge");
    }

    void everyPartHasItsColour_data()
    {
        QTest::addColumn<bool>("dark");
        QTest::newRow("light") << false;
        QTest::newRow("dark") << true;
    }
    void everyPartHasItsColour()
    {
        QFETCH(bool, dark);
        const Ground ground = dark ? Ground::Dark : Ground::Light;
        const FigureColours colours = figureColours(ground);
        const TracedLine s = tracedLine("matthes-drakopoulos", {{-160, -30}, {70, 130}});
        const Narration narration = narrationOf(s);
        const FigureFrame frame = figureFrame(s, size, font());
        std::size_t cut = narration.steps.size() - 1;
        while (narration.steps[cut].mark != Mark::Cut
               || narration.steps[cut].edge != clipping::Edge::Top)
            --cut;
        const QImage at = painted(s, cut, ground),
                     end = painted(s, narration.steps.size() - 1, ground);
        QVERIFY(hasColour(at, frame, {-9.0625, 75}, colours.highlight)); // the new diamond
        QVERIFY(hasColour(at, frame, {90, 75}, colours.highlight));      // the edge of this step
        QVERIFY(hasColour(end, frame, {90, 75}, colours.window));        // and of no step
        QVERIFY(hasColour(at, frame, {100, 20}, colours.window));        // the window
        QVERIFY(hasColour(at, frame, {-54.53125, 43.369565}, colours.text));  // what is left
        QVERIFY(hasColour(at, frame, {-160, -30}, colours.paper));            // End 1: hollow, ...
        QVERIFY(hasColour(at, frame, {-160, -30}, colours.muted, {-5.5, 0})); // discarded, so grey
        QVERIFY(
            hasColour(at, frame, {70, 130}, colours.highlight, {5.5, 0})); // End 2: discarded now
        QVERIFY(hasColour(end, frame, {20, -20}, colours.paper));
    }

    void rejectedLinesAreGrey()
    {
        const TracedLine s = tracedLine("cohen-sutherland", {{-160, 90}, {70, 130}});
        const FigureColours colours = figureColours(Ground::Light);
        const Narration narration = narrationOf(s);
        const QImage image = painted(s, narration.steps.size() - 1, Ground::Light);
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (image.pixelColor(x, y) == colours.highlight)
                    QFAIL("blue where nothing is chosen");
        QVERIFY(hasColour(image, figureFrame(s, size, font()), {-45, 110}, colours.muted)); // cross
    }

    void whatIsCutOffAndWhatIsLeftIsTheLine() // of every row that keeps the contract
    {
        for (const auto& algorithm : clipping::algorithms()) {
            int visible = 0;
            for (int i = 0; i < 300; ++i) {
                const TracedLine s = anyTracedLine({&algorithm, clipping::Form::Corrected});
                const Narration narration = narrationOf(s);
                if (!narration.visible)
                    continue;
                ++visible;
                const std::size_t last = narration.steps.size() - 1;
                const StepScene scene = stepScene(s, narration, last);
                QCOMPARE(scene.state, StepScene::State::Accepted);
                QVERIFY2(scene.left == *narration.visible, told(s, last));
                double sum = length(scene.left);
                for (const auto& piece : scene.discarded)
                    sum += length(piece);
                for (const auto& piece : scene.discardedNow)
                    sum += length(piece);
                QVERIFY2(std::abs(sum - length(s.line)) <= 1e-9 * (1 + length(s.line)),
                         told(s, last));
                for (const CutPoint& cut : scene.cuts)
                    if (cut.stands)
                        QVERIFY2(cut.at == (cut.end == 1 ? scene.left.a : scene.left.b),
                                 told(s, last));
            }
            QVERIFY2(visible > 30, algorithm.key.data());
        }
    }

    void goingBackIsNoCut() // halving looks for one end after the other, each from the whole line
    {
        const TracedLine s = tracedLine("midpoint-subdivision", {{-160, -30}, {70, 130}});
        const Narration narration = narrationOf(s);
        const StepScene scene = stepScene(s, narration, narration.steps.size() - 1);
        std::vector<clipping::Edge> edges;
        for (const CutPoint& cut : scene.cuts)
            if (cut.stands)
                edges.push_back(cut.edge);
        std::ranges::sort(edges);
        QCOMPARE(edges, (std::vector{clipping::Edge::Left, clipping::Edge::Top}));
        for (const CutPoint& cut : scene.cuts)
            QVERIFY(cut.at != s.line.a && cut.at != s.line.b);
    }

    void labelsAreInsideAndApart() // every form of every row
    {
        std::size_t wanted = 0, placed = 0;
        for (const Variant& variant : variants()) {
            for (int i = 0; i < 150; ++i) {
                const TracedLine s = anyTracedLine(variant);
                const Narration narration = narrationOf(s);
                const FigureFrame frame =
                    i % 2 ? figureFrame(s, size, font()) : nearFrame(s, size, font());
                for (const std::size_t step :
                     {narration.steps.size() / 2, narration.steps.size() - 1}) {
                    const StepScene scene = stepScene(s, narration, step);
                    const auto labels = figureLabels(s, narration, scene, frame);
                    const auto marks = figureMarks(s, scene, frame);
                    wanted += 6, placed += labels.size(); // two ends, four edges
                    const auto part = frame.part(s.line);
                    for (auto label = labels.begin(); label != labels.end(); ++label)
                        QVERIFY2(frame.picture().contains(label->box)
                                     && !(part && meets(*part, label->box))
                                     && isFree(label->box, {labels.begin(), label}, marks),
                                 told(s, step));
                    for (const FigureMark& mark : marks) // none of the points goes without
                        QVERIFY2(mark.head.isEmpty()
                                     || std::ranges::count(labels, mark.head, &FigureLabel::head)
                                            > 0,
                                 told(s, step));
                }
            }
        }
        QVERIFY2(placed >= wanted, QByteArray::number(double(placed) / double(wanted)));
    }

    void labelsKeepClearOfReservedPlaces()
    {
        for (int i = 0; i < 300; ++i) {
            const TracedLine s = anyTracedLine(exactVariant());
            FigureFrame frame = figureFrame(s, size, font());
            frame.reserved = QRectF(10, 10, 180, 140);
            const Narration narration = narrationOf(s);
            for (const auto& label : figureLabels(s, narration, stepScene(s, narration, 0), frame))
                QVERIFY(!label.box.intersects(frame.reserved));
        }
    }

    void farEndsAreArrowsAtTheBorder()
    {
        for (const clipping::Segment& line : {clipping::Segment{{0, 0}, {1e9, 2e8}},
                                              {{0, 0}, {0, -1e300}},
                                              {{3e5, 2e6}, {10, 10}},
                                              {{1e6, 2e6}, {3e6, 1e6}},
                                              {{-1e12, 0}, {1e12, 0.5}}}) {
            const TracedLine s = tracedLine("exact", line);
            const FigureFrame frame = figureFrame(s, size, font());
            const auto marks = figureMarks(s, stepScene(s, narrationOf(s), 0), frame);
            int arrows = 0;
            for (const FigureMark& mark : marks) {
                if (mark.shape != FigureMark::Shape::FarEnd)
                    continue;
                ++arrows;
                const QPointF& p = mark.place;
                QVERIFY(frame.picture().contains(p));
                const double off =
                    std::min({p.x(), p.y(), size.width() - p.x(), size.height() - p.y()});
                QVERIFY2(off < 10, told(s, 0));
                QVERIFY(!frame.shows(mark.point));
                // On the line, and pointing along it, where it can be seen.
                if (const auto part = frame.part(line)) {
                    const double across =
                        part->dx() * (p.y() - part->y1()) - part->dy() * (p.x() - part->x1());
                    QVERIFY2(std::abs(across) < 0.5 * part->length(), told(s, 0));
                }
            }
            QVERIFY2(arrows > 0, told(s, 0));
        }
    }

    void frameShowsTheWindowAndNearLines()
    {
        for (int i = 0; i < 2000; ++i) {
            const TracedLine s = anyTracedLine(exactVariant());
            const FigureFrame frame = figureFrame(s, size, font());
            QVERIFY2(frame.shows(s.window.min) && frame.shows(s.window.max), told(s, 0));
            const Point span = s.window.max - s.window.min;
            const double near = 1.19 * std::max(span.x, span.y); // about the window's own size
            const auto isNear = [&](double value, glm::length_t axis) {
                return near == 0
                       || (value > s.window.min[axis] - near && value < s.window.max[axis] + near);
            };
            for (const Point& end : {s.line.a, s.line.b})
                if (isNear(end.x, 0) && isNear(end.y, 1))
                    QVERIFY2(frame.shows(end), told(s, 0));
            const double across = (frame.seen.max.x - frame.seen.min.x) / size.width(),
                         down = (frame.seen.max.y - frame.seen.min.y) / size.height();
            QVERIFY2(std::abs(across / down - 1) < 1e-9, told(s, 0)); // nothing is stretched
            const Point back = frame.pointAt(frame.at(s.window.min));
            QVERIFY(std::abs(back.x - s.window.min.x) < 1e-6 * (1 + std::abs(s.window.min.x)));
        }
    }

    void anyNumbersArePainted()
    {
        const double big = std::numeric_limits<double>::max(),
                     least = std::numeric_limits<double>::denorm_min();
        const std::vector<TracedLine> all{
            tracedLine("exact", {{-big, -big}, {big, big}}, {{-big, -big}, {big, big}}),
            tracedLine("exact", {{-big, 0}, {big, 1}}),
            tracedLine("exact", {{0, 0}, {least, least}}, {{0, 0}, {least, 2 * least}}),
            tracedLine("exact", {{-1e-200, 0}, {2e-200, 1e-200}}, {{0, 0}, {1e-200, 1e-200}}),
            tracedLine("exact", {{1e15, 1e15}, {1e15 + 3, 1e15 + 5}},
                       {{1e15, 1e15}, {1e15 + 2, 1e15 + 2}}),
            tracedLine("exact", {{0, 0}, {1, 1}}, {{-big, -big}, {big, big}}),
            tracedLine("exact", {{1e9, 1e9}, {1e9 + 1, 1e9 + 2}}, {{-1e300, 5}, {1e300, 1e300}}),
            tracedLine("exact", {{5, 5}, {5, 5}}, {{5, 5}, {5, 5}}),
            tracedLine("exact", {{0, 0}, {0, 0}}, {{0, 0}, {0, 0}}),
            tracedLine("exact", {{std::nan(""), 0}, {1, 1}}),
            tracedLine("exact", {{0, -INFINITY}, {1, 1}}),
            tracedLine("exact", {{0, 0}, {1, 1}}, {{5, 5}, {0, 0}}),
            tracedLine("exact", {{0, 0}, {1, 1}}, {{std::nan(""), 5}, {INFINITY, 0}})};
        for (const TracedLine& s : all)
            for (const QSizeF& picture : {size, QSizeF(60, 40), QSizeF(1, 1)}) {
                const Narration narration = narrationOf(s);
                QImage image(picture.toSize(), QImage::Format_RGB32);
                QPainter painter(&image);
                for (const FigureFrame& frame :
                     {figureFrame(s, picture, font()), nearFrame(s, picture, font())}) {
                    paintStep(painter, {s, narration, narration.steps.size()}, frame,
                              figureColours(Ground::Light));
                    if (!narration.steps.empty())
                        paintStep(painter, {s, narration, narration.steps.size() - 1}, frame,
                                  figureColours(Ground::Dark));
                    for (const Point& p : {s.line.a, s.line.b, s.window.min, s.window.max}) {
                        const QPointF place = frame.at(p);
                        QVERIFY2(std::isfinite(place.x()) && std::isfinite(place.y()), told(s, 0));
                    }
                }
            }
    }

    void tracesWithoutStepsHaveNoFigure()
    {
        clipping::Algorithm silent = clipping::exactAlgorithm();
        silent.corrected.trace = [](const clipping::Segment&, const clipping::Window&) {
            return clipping::Trace{};
        };
        QVERIFY(pageFigure(silent, Ground::Light, 600, 1).isNull());
    }
    void pagesHaveTellingFigures()
    {
        for (const auto& algorithm : clipping::algorithms()) {
            const PageFigure figure = teachingOf(algorithm).figure;
            const Narration narration = narrationOf(pageTracedLine(algorithm));
            QVERIFY2(narration.visible, algorithm.key.data());
            QVERIFY2(narration.steps[stepOf(figure, narration)].mark == figure.mark,
                     algorithm.key.data());
            const QString address = "figure:" + QString::fromUtf8(algorithm.key.data());
            const QImage light = pageFigure(address, Ground::Light, 600, 2);
            QCOMPARE(light.size(), QSize(1200, 674));
            QVERIFY(light != pageFigure(address, Ground::Dark, 600, 2));
        }
        QVERIFY(pageFigure(QStringLiteral("figure:nobody"), Ground::Light, 600, 1).isNull());
        QVERIFY(pageFigure(QStringLiteral("exact"), Ground::Light, 600, 1).isNull());
    }
};

} // namespace teaching_figure_test

TEST_CLASS(teaching_figure_test::FigureTest, Gui)
#include "tests/app/teaching/figure_test.moc"
