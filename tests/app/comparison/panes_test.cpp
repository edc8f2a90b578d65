// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/panes.h"
#include "app/view/pane_grid.h"

#include <QTest>

#include <random>
#include <set>

#include "tests/test_class.h"

namespace comparison_panes_test {

using app::Panes;
using app::Variant;

namespace {

constexpr double usual = 4.0 / 3;
constexpr auto published = clipping::Form::Published;

Variant row(const char* key, clipping::Form form = clipping::Form::Corrected)
{
    return {clipping::findAlgorithm(key), form};
}

QString words(const Panes& panes)
{
    QStringList all;
    for (std::size_t i = 0; i < panes.size(); ++i) {
        const Variant& choice = panes.choices()[i];
        const QString word = QString::fromStdString(std::string(choice.algorithm->abbreviation))
                             + (choice.form == published ? "'" : "");
        all << (i == panes.active() ? "[" + word + "]" : word);
    }
    return all.join(" ");
}

/// The panes of all algorithms in the order of the catalogue, the exact one first and
/// Kodituwakku-Wijeweera-Chamikara in both forms; one of them is shown as `active`.
QString allOf(const QString& abbreviation, const QString& active)
{
    QStringList all{"EX"};
    for (const clipping::Algorithm& algorithm : clipping::algorithms()) {
        const QString word = QString::fromStdString(std::string(algorithm.abbreviation));
        if (&algorithm != &clipping::exactAlgorithm())
            all << (word == abbreviation ? active : word);
        if (word == "KWC")
            all << "KWC'";
    }
    return all.join(" ");
}

bool twice(const Panes& panes)
{
    std::set<std::pair<const void*, clipping::Form>> seen;
    for (const Variant& choice : panes.choices())
        seen.insert({choice.algorithm, choice.form});
    return seen.size() != panes.size();
}

} // namespace

class PanesTest : public QObject {
    Q_OBJECT

private slots:
    void chosenPanesStayChosen()
    {
        Panes panes(row("lb"));
        QCOMPARE(words(panes), "[LB]");
        panes.show(2);
        QCOMPARE(words(panes), "EX [LB]");
        panes.show(4);
        QCOMPARE(words(panes), "EX [LB] KWC' MD");
        panes.activate(2);
        panes.show(2);
        QCOMPARE(words(panes), "EX [KWC']");
        panes.show(1);
        QCOMPARE(words(panes), "[KWC']");
        panes.choose(row("exact"));
        panes.show(2);
        QCOMPARE(words(panes), "[EX] KWC'");
    }
    void choosingAShownAlgorithmSwapsPanes()
    {
        Panes panes(row("exact"));
        panes.show(4);
        QCOMPARE(words(panes), "[EX] CS KWC' MD");
        panes.choose(row("md"));
        QCOMPARE(words(panes), "[MD] CS KWC' EX");
        panes.choose(row("nln"));
        QCOMPARE(words(panes), "[NLN] CS KWC' EX");
        panes.choose(row("cs", published));
        QCOMPARE(words(panes), "[CS'] CS KWC' EX");
    }
    void allHasEveryAlgorithmInItsPlace()
    {
        Panes panes(row("lb"));
        panes.showAll();
        QCOMPARE(words(panes), allOf("LB", "[LB]"));
        panes.choose(row("kwc", published));
        QCOMPARE(panes.active(), std::size_t(7));
        panes.choose(row("cs", published));
        QCOMPARE(words(panes), allOf("CS", "[CS']"));
        panes.choose(row("cs"));
        QCOMPARE(words(panes), allOf("CS", "[CS]"));
        panes.show(4);
        QCOMPARE(words(panes), "EX [CS] KWC' MD");
        panes.choose(row("sb", published));
        panes.showAll();
        QCOMPARE(words(panes), allOf("SB", "[SB']"));
    }
    void closingLeavesTheOthers()
    {
        Panes panes(row("exact"));
        panes.show(4);
        panes.activate(3);
        panes.close(1);
        QCOMPARE(words(panes), "EX KWC' [MD]");
        panes.close(2);
        QCOMPARE(words(panes), "EX [KWC']");
        panes.show(4);
        QCOMPARE(words(panes), "EX [KWC'] MD CS");
        panes.show(1);
        panes.close(0);
        QCOMPARE(words(panes), "[KWC']");
    }
    void closingOneOfAllPanesEndsAll()
    {
        Panes panes(app::exactVariant());
        panes.showAll();
        while (panes.size() > Panes::most) {
            QVERIFY(panes.showsAll());
            panes.close(panes.size() - 1);
        }
        QVERIFY(!panes.showsAll());
        QVERIFY(panes.text().startsWith("4 "));
    }
    void withLittleRoomTheActiveOneIsShown()
    {
        Panes panes(row("md"));
        panes.showAll();
        QCOMPARE(panes.shown(12).size(), std::size_t(12));
        QCOMPARE(panes.shown(4), (std::vector<std::size_t>{0, 1, 2, 8}));
        QCOMPARE(panes.shown(1), (std::vector<std::size_t>{8}));
        panes.activate(1);
        QCOMPARE(panes.shown(2), (std::vector<std::size_t>{0, 1}));
    }
    void panesAreRemembered()
    {
        Panes panes(row("exact"));
        panes.show(4);
        panes.activate(2);
        panes.choose(row("skala", published));
        const auto again = Panes::fromText(panes.text(), row("exact"));
        QVERIFY(again);
        QCOMPARE(words(*again), "EX CS [Skala'] MD");
        panes.show(1);
        const auto single = Panes::fromText(panes.text(), row("exact"));
        QVERIFY(single);
        QCOMPARE(words(*single), "[EX]");
        Panes four = *single;
        four.show(4);
        QCOMPARE(words(four), "[EX] CS Skala' MD");
        panes.choose(row("nln"));
        panes.showAll();
        panes.activate(3);
        QCOMPARE(words(*Panes::fromText(panes.text(), row("exact"))), words(panes));
        for (const char* wrong :
             {"", "4", "5 0 exact cs kwc md", "4 4 exact cs kwc md", "2 0 exact exact cs md",
              "4 0 exact cs kwc nothing", "0 0 exact cs kwc md", "4 0 exact cs kwc md lb"})
            QVERIFY2(!Panes::fromText(wrong, row("exact")), wrong);
    }
    // Whatever is done: nothing twice, always one active, what is chosen is what was asked for.
    void nothingIsEverShownTwice()
    {
        std::mt19937 random(7);
        Panes panes(row("exact"));
        for (int i = 0; i < 5000; ++i) {
            const auto before = panes.chosen();
            const std::size_t pane = random() % panes.size();
            const auto& any = clipping::algorithms()[random() % clipping::algorithms().size()];
            switch (random() % 6) {
            case 0:
                panes.show(std::array{1, 2, 4}[random() % 3]);
                QVERIFY(panes.chosen() == before);
                break;
            case 1:
                panes.showAll();
                QVERIFY(panes.chosen() == before);
                break;
            case 2:
                panes.activate(pane);
                QCOMPARE(panes.active(), pane);
                break;
            case 3:
                panes.close(pane);
                break;
            default: {
                const bool faulty = any.published && random() % 2;
                const Variant wish{&any, faulty ? published : clipping::Form::Corrected};
                panes.choose(wish);
                QVERIFY(panes.chosen() == wish);
            }
            }
            QVERIFY(panes.size() >= 1 && panes.active() < panes.size());
            QVERIFY(!twice(panes));
            QVERIFY(Panes::fromText(panes.text(), panes.chosen()));
        }
    }
    void panesFormAGridOfEqualCells()
    {
        for (const int count : {1, 2, 3, 4, 11, 12})
            for (int width = 600; width < 640; ++width) {
                const QSize area(width, 500 + (width * 7) % 50);
                const auto cells = app::paneCells(area, count, usual);
                QCOMPARE(int(cells.size()), count);
                QRegion free{QRect(QPoint(), area)};
                for (const QRect& cell : cells) {
                    QCOMPARE(cell.size(), cells[0].size());
                    QCOMPARE(free & cell, QRegion(cell)); // inside, and not on another
                    free -= cell;
                }
                QVERIFY(area.width() - cells.back().right() >= 1);
            }
        const auto two = app::paneCells({900, 680}, 2, usual);
        QCOMPARE(two[0].top(), two[1].top());
        const auto square = app::paneCells({1000, 780}, 2, 1);
        QCOMPARE(square[0].top(), square[1].top());
        const auto broad = app::paneCells({1000, 780}, 2, 2);
        QCOMPARE(broad[0].left(), broad[1].left());
        const auto high = app::paneCells({400, 900}, 2, usual);
        QCOMPARE(high[0].left(), high[1].left());
        QCOMPARE(app::paneCells({900, 680}, 4, usual)[3].topLeft(), QPoint(451, 341));
    }
    void panesBecomeFewerWithoutRoom()
    {
        QCOMPARE(app::panesWithRoom({900, 680}, 12, usual), 12);
        QCOMPARE(app::panesWithRoom({900, 680}, 4, usual), 4);
        QCOMPARE(app::panesWithRoom({430, 500}, 12, usual), 4);
        QCOMPARE(app::panesWithRoom({390, 500}, 4, usual), 2);
        QCOMPARE(app::panesWithRoom({150, 100}, 4, usual), 1);
        QCOMPARE(app::panesWithRoom({900, 680}, 1, usual), 1);
    }
};

} // namespace comparison_panes_test

TEST_CLASS(comparison_panes_test::PanesTest, Gui)
#include "tests/app/comparison/panes_test.moc"
