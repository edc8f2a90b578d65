// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers and words that widgets paint themselves are those that they should show, where they
// belong.
#include "app/base/numbers.h"
#include "app/exactness/error_class.h"
#include "app/session/window_words.h"
#include "app/view/ruler.h"
#include "ui/canvas/ruler.h"
#include "ui/microscope/legend.h"
#include "ui/microscope/operations_view.h"
#include "ui/microscope/timeline.h"
#include "ui/tiles/tiles_view.h"
#include "ui/widgets/error_histogram.h"
#include "ui/widgets/status_cell.h"

#include <QLocale>

#include <set>

#include "tests/painted_texts.h"
#include "tests/test_class.h"
#include "tests/ui/fresh/made.h"
#include "tests/ui/fresh/shown_by.h"

namespace painted_test {

using namespace ui;

namespace {

std::vector<PaintedText> textsOf(QWidget& widget)
{
    TextDevice device(widget.size());
    widget.render(&device, {}, {}, QWidget::DrawChildren);
    return device.texts();
}

double numberIn(QString text) { return QLocale().toDouble(text.replace(u'−', u'-')); }

/// Whether a painted text is this one, perhaps shortened: "EX", "exact (CS…", "11.7391".
bool isShownAs(const QString& painted, const QString& whole)
{
    constexpr qsizetype enough = 4;
    const QString begin = painted.section(u'…', 0, 0);
    return painted.startsWith(whole.section(u' ', 0, 0))
           || (begin.size() > 1 && whole.startsWith(begin, Qt::CaseInsensitive))
           || (begin.size() > enough && whole.startsWith(begin.first(enough)));
}

struct Traced {
    explicit Traced(const char* algorithm)
    {
        microscope.open({{clipping::findAlgorithm(algorithm)},
                         {{-160, -30}, {70, 130}},
                         {{-100, -75}, {100, 75}}});
    }
    app::Microscope microscope;
};

} // namespace

class PaintedTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        Timers::watch();
        dropRemarksOfThePlatform();
        applyTheme(*qApp, Theme::Light);
    }

    void theTimelineNumbersItsSteps()
    {
        for (const char* algorithm : {"CS", "LB", "MS"})
            for (const int width : {300, 700, 2000}) {
                Traced traced(algorithm);
                Timeline timeline(traced.microscope);
                timeline.resize(width, timeline.sizeHint().height());
                const auto count = traced.microscope.narration().steps.size();
                for (std::size_t now = 0; now < count; now += 3) {
                    traced.microscope.goTo(now);
                    std::set<int> numbers;
                    double last = -1e9;
                    auto texts = textsOf(timeline);
                    std::ranges::sort(texts, {}, [](const auto& t) { return t.place.left(); });
                    for (const PaintedText& text : texts) {
                        const int number = text.text.toInt();
                        QVERIFY2(number >= 1 && std::size_t(number) <= count,
                                 qPrintable(text.text));
                        const double place = timeline.placeOf(std::size_t(number - 1)).x();
                        QVERIFY2(std::abs(text.place.center().x() - place) < 1,
                                 qPrintable(text.text));
                        QVERIFY2(text.place.left() > last, qPrintable(text.text)); // none touch
                        last = text.place.right();
                        numbers.insert(number);
                    }
                    QVERIFY(numbers.contains(int(now) + 1));
                    const double way = timeline.placeOf(now).x() - timeline.placeOf(0).x();
                    QVERIFY(numbers.contains(1) || way < 40); // hidden by the step's own
                }
            }
    }

    void theLegendHasTheMarksOfTheSteps()
    {
        Traced traced("CS");
        Legend legend;
        legend.show(traced.microscope.narration());
        legend.resize(legend.sizeHint());
        QStringList words;
        for (const app::NarratedStep& step : traced.microscope.narration().steps)
            words << markWord(step.mark);
        words.removeDuplicates();
        QStringList painted = wordsOf(textsOf(legend));
        words.sort();
        painted.sort();
        QCOMPARE(painted, words);
    }

    void operationsAreCountedUpToTheStep()
    {
        Traced traced("CB");
        OperationsView view;
        view.resize(420, 200);
        const auto& steps = traced.microscope.narration().steps;
        for (const app::NarratedStep& step : steps) {
            view.show(step.cost, steps.back().cost);
            const auto texts = textsOf(view);
            const auto besides = [&](const QString& word) -> QStringList {
                const auto at = std::ranges::find(texts, word, &PaintedText::text);
                if (at == texts.end())
                    return {};
                QStringList above; // of the same cell
                for (const PaintedText& text : texts)
                    if (text.place.top() < at->place.top()
                        && std::abs(text.place.bottom() - at->place.top()) < 12
                        && text.place.left() >= at->place.left() - 1
                        && text.place.left() < at->place.right())
                        above << text.text;
                return above;
            };
            const auto& [now, all] = std::pair(step.cost, steps.back().cost);
            const auto row = [](std::uint64_t n, std::uint64_t of) {
                return QStringList{app::countText(n), "of " + app::countText(of)};
            };
            QCOMPARE(besides("comparisons"), row(now.comparisons, all.comparisons));
            QCOMPARE(besides("additions"), row(now.additions, all.additions));
            QCOMPARE(besides("multiplications"), row(now.multiplications, all.multiplications));
            QCOMPARE(besides("divisions"), row(now.divisions, all.divisions));
            QCOMPARE(besides("negations").isEmpty(), all.negations == 0);
        }
    }

    void eachErrorClassHasItsCount()
    {
        app::ErrorCounts counts;
        counts.classes.resize(app::errorClasses().size());
        for (std::size_t i = 0; i < counts.classes.size(); ++i)
            counts.classes[i] = i * i * 1000 + i;
        ErrorHistogram histogram;
        histogram.show(counts);
        histogram.resize(400, histogram.sizeHint().height());
        const auto texts = textsOf(histogram);
        QCOMPARE(texts.size(), 2 * counts.classes.size());
        for (std::size_t i = 0; i < counts.classes.size(); ++i) {
            const auto name =
                std::ranges::find(texts, app::errorClasses()[i].name, &PaintedText::text);
            QVERIFY(name != texts.end());
            const auto number = std::ranges::find_if(texts, [&](const PaintedText& text) {
                return text.place.left() > name->place.right()
                       && std::abs(text.place.center().y() - name->place.center().y()) < 2;
            });
            QVERIFY(number != texts.end());
            QCOMPARE(number->text, app::countText(counts.classes[i]));
        }
    }

    void rulersTellWhereOneIs()
    {
        Desk desk(3);
        desk_changes::openFull(desk);
        desk.canvas.resize(500, 400);
        desk.canvas.setAttribute(Qt::WA_DontShowOnScreen);
        desk.canvas.show();
        settle();
        for (const app::Unit unit : shownUnits())
            for (const double zoom : {0.3, 1.0, 12.0}) {
                desk_changes::display(desk, [unit](app::Display& d) { d.unit = unit; });
                desk.canvas.setZoom(zoom);
                settle();
                const app::Page& page = desk.session.now().page();
                const app::Point origin = app::originOf(page, unit);
                const auto& view = desk.canvas.view();
                for (Ruler* ruler : desk.canvas.findChildren<Ruler*>()) {
                    const bool across = ruler->width() > ruler->height();
                    const auto texts = textsOf(*ruler);
                    QVERIFY(texts.size() >= 2);
                    for (const PaintedText& text : texts) {
                        const double value =
                            app::fromUnit(numberIn(text.text), unit, page.millimetresPerUnit());
                        const app::Point place = view.toScreen(origin + value);
                        const double distance =
                            across ? text.place.left() - place.x
                                   : place.y - text.place.bottom(); // it is read upwards
                        QVERIFY2(std::abs(distance - 4) < 2,
                                 qPrintable(QString("%1: %2").arg(text.text).arg(distance)));
                    }
                }
            }
    }

    void everySheetHasItsName()
    {
        Desk desk(3);
        desk_changes::openFull(desk);
        TilesView view(desk.session, desk.sheets, app::SheetArrangement::Apart);
        view.resize(700, 500);
        view.setAttribute(Qt::WA_DontShowOnScreen);
        view.show();
        settle();
        const app::Tiling& tiling = *desk.sheets.tiling().value;
        const auto texts = textsOf(view);
        QVERIFY(tiling.tiles.size() >= 2);
        for (std::size_t i = 0; i < tiling.tiles.size(); ++i) {
            const QString name =
                QString("%1-%2").arg(tiling.tiles[i].row).arg(tiling.tiles[i].column);
            const auto tag = std::ranges::find(texts, name, &PaintedText::text);
            QVERIFY2(tag != texts.end(), qPrintable(wordsOf(texts).join('|')));
            const QPointF away = tag->place.center() - view.middleOf(i);
            QVERIFY2(away.x() < 0 && away.y() < 0, qPrintable(name)); // above, at the left
        }
    }

    void aStatusCellPaintsItsText()
    {
        StatusCell cell(QStringLiteral("Times"));
        cell.setWidest(QStringLiteral("clip 99.9 ms"));
        cell.setText(QStringLiteral("clip 1.25 ms"));
        cell.resize(cell.width(), 26);
        QCOMPARE(wordsOf(textsOf(cell)).join(QString()), "clip 1.25 ms");
    }

    /// What a list or table holds is painted in its row, at least its beginning.
    void everyVisibleItemIsPainted_data() { addEveryMaker(); }
    void everyVisibleItemIsPainted()
    {
        QFETCH(int, number);
        Desk desk(5);
        desk_changes::openFull(desk);
        desk_changes::changeLayer(desk);
        const Maker maker = makers()[std::size_t(number)];
        const std::unique_ptr<QWidget> window(maker.make(desk));
        window->setAttribute(Qt::WA_DontShowOnScreen);
        window->resize(maker.size);
        ui::open(maker, *window, desk);
        settle();
        for (QAbstractItemView* view : window->findChildren<QAbstractItemView*>()) {
            if (!view->isVisible())
                continue;
            const auto texts = textsOf(*view->viewport());
            const QAbstractItemModel& model = *view->model();
            for (int row = 0; row < model.rowCount(); ++row)
                for (int column = 0; column < model.columnCount(); ++column) {
                    const QModelIndex index = model.index(row, column);
                    const QRect cell = view->visualRect(index);
                    const QString whole = index.data().toString();
                    if (whole.isEmpty() || !view->viewport()->rect().contains(cell))
                        continue;
                    const bool found = std::ranges::any_of(texts, [&](const PaintedText& text) {
                        return QRectF(cell).adjusted(-1, -1, 1, 1).contains(text.place.center())
                               && isShownAs(text.text, whole);
                    });
                    QVERIFY2(found, qPrintable(QString("%1: %2, %3: %4 (%5)")
                                                   .arg(classOf(*view))
                                                   .arg(row)
                                                   .arg(column)
                                                   .arg(whole, wordsOf(texts).join('|'))));
                }
        }
    }
};

} // namespace painted_test

TEST_CLASS(painted_test::PaintedTest, Widgets)
#include "tests/ui/painted_test.moc"
