// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_steps.h"

#include <QTest>

#include <set>

#include "tests/app/nodes/shapes.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace nodes_node_steps_test {

class NodeStepsTest : public QObject {
    Q_OBJECT

    static QString refusal(const char* key, const app::NodePath& path)
    {
        return app::nodeStep(key).refusal(app::summaryOf(path));
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
    void everyStepHasANameAndChangesAnOpenCurveOrSaysWhyNot()
    {
        std::set<std::string_view> keys;
        for (const app::NodeStep& step : notEmpty(app::nodeSteps())) {
            QVERIFY(keys.insert(step.key).second);
            QVERIFY(!step.name.isEmpty() && !step.done.isEmpty());
            app::OwnedPaths paths{{nodesOf({{0, 0},
                                            {{{60, 0}, {20, -40}, {60, -10}, true},
                                             {{120, 10}, {80, 0}, {100, 60}, true}},
                                            false})},
                                  {0}};
            paths.path[0].nodes[1].selected = true;
            const app::NodePath before = paths.path;
            const QString why = step.refusal(app::summaryOf(paths.path));
            const bool done = why.isEmpty() && step.change(paths, {1, {0}});
            if (done)
                QVERIFY2(paths.path != before || step.key == "corner-nodes", step.key.data());
            else
                QVERIFY2(
                    (why + (step.joins ? app::notJoinedText("1 mm") : step.refused)).endsWith('.'),
                    step.key.data());
            QCOMPARE(paths.owners.size(), paths.path.size());
            QVERIFY(app::isFinite(paths.path));
        }
    }
    void theSummaryCountsWhatStepsNeed()
    {
        app::NodePath path{nodesOf(wave()), nodesOf(circle(5)), polyline({{1, 1}})};
        app::NodeSummary none = app::summaryOf(path);
        QVERIFY(none.nodes == 8 && none.selected == 0 && none.open == 1 && none.closed == 1);
        QVERIFY(!none.only && none.curved + none.straight == 0);
        path[0].nodes[0].selected = true;
        const app::NodeSummary one = app::summaryOf(path);
        QVERIFY(one.selected == 1 && one.selectedEnds == 1 && one.curved == 1);
        QVERIFY((*one.only == app::NodeAddress{0, 0}));
        path[1].nodes[1].selected = path[1].nodes[2].selected = true;
        const app::NodeSummary more = app::summaryOf(path);
        QVERIFY(more.selected == 3 && !more.only && more.curved == 1);
    }
    void whatIsImpossibleIsSaidInOneSentence()
    {
        app::NodePath end{nodesOf(wave())};
        end[0].nodes[0].selected = true;
        for (const char* key : {"smooth-nodes", "split-path", "open-path", "curve-segments"})
            QVERIFY2(refusal(key, end).endsWith('.'), key);
        QVERIFY(refusal("straighten-segments", end).isEmpty());
        app::NodePath round{nodesOf(circle(5))};
        for (const char* key : {"join-ends", "close-path"})
            QVERIFY2(refusal(key, round).endsWith('.'), key);
        QVERIFY(refusal("open-path", round).isEmpty());
    }
    void deletingAndSplittingKeepEachObjectsSubpaths()
    {
        app::OwnedPaths paths{{nodesOf(wave()), nodesOf(circle(5)), nodesOf(wave())}, {3, 7, 7}};
        paths.path[0].nodes[1].selected = paths.path[2].nodes[1].selected = true;
        app::OwnedPaths split = paths;
        QVERIFY(app::nodeStep("split-path").change(split, {}));
        QCOMPARE(split.owners, (std::vector<std::size_t>{3, 3, 7, 7, 7}));
        app::selectAll(std::span(paths.path).first(1), true);
        QVERIFY(app::nodeStep("delete-nodes").change(paths, {}));
        QCOMPARE(paths.owners, (std::vector<std::size_t>{7, 7}));
    }
    void whatWasJoinedIsSaid()
    {
        app::OwnedPaths before;
        for (int i = 0; i < 1204; ++i) {
            before.path.push_back(polyline({{double(i), 0}, {i + 1.0, 0}}));
            before.owners.push_back(std::size_t(i));
        }
        app::OwnedPaths after = before;
        QVERIFY(app::nodeStep("join-ends").change(after, {0.1, std::vector<std::uint32_t>(1204)}));
        QCOMPARE(app::joinedText(before, after, "0.1 mm"),
                 "1,204 objects became 1: 1,203 pairs of ends were joined within 0.1 mm.");
        before = {{polyline({{0, 0}, {9, 0}, {5, 5}, {0, 0.05}})}, {7}};
        after = before;
        QVERIFY(app::nodeStep("join-ends").change(after, {0.1, {0}}));
        QCOMPARE(app::joinedText(before, after, "0.1 mm"),
                 "1 pair of ends was joined within 0.1 mm.");
    }
    void closingConcernsTheSelectedSubpathsOrAll()
    {
        app::OwnedPaths paths{{nodesOf(wave()), nodesOf(wave())}, {0, 1}};
        app::OwnedPaths all = paths;
        QVERIFY(app::nodeStep("close-path").change(all, {}));
        QVERIFY(all.path[0].closed && all.path[1].closed);
        paths.path[1].nodes[0].selected = true;
        QVERIFY(app::nodeStep("close-path").change(paths, {}));
        QVERIFY(!paths.path[0].closed && paths.path[1].closed);
    }
};

} // namespace nodes_node_steps_test

TEST_CLASS(nodes_node_steps_test::NodeStepsTest, None)
#include "tests/app/nodes/node_steps_test.moc"
