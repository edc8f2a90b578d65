// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/tasks/player.h"

using namespace tasks;

// Tasks of README.md about nodes.
class NodesTest : public QObject {
    Q_OBJECT

    static Steps rectangle()
    {
        return {key("R"), type("10,10"), enter(), type("40"), tab(), type("20"), enter(), key("V")};
    }
    static Steps both(Steps first, const Steps& then)
    {
        first.insert(first.end(), then.begin(), then.end());
        return first;
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void movedEnd()
    {
        check({key("L"), type("10,20"), enter(), type("30,0"), enter(), key("V"), click({25, 20}),
               key("N"), click({40, 20}), type("50,60"), enter()},
              {{{{10, 20}, {50, 60}}}});
    }
    void insertedNode()
    {
        check(both(rectangle(),
                   {doubleClick({20, 10}), doubleClick({20, 10}), type("30,-2"), enter()}),
              {{{{10, 10}, {30, -2}, {50, 10}, {50, 30}, {10, 30}}, true}});
    }
    void split()
    {
        check(both(rectangle(), {doubleClick({20, 10}), click({10, 10}),
                                 click({50, 30}, Qt::ShiftModifier), key("Shift+B")}),
              {{{{10, 10}, {50, 10}, {50, 30}}}, {{{50, 30}, {10, 30}, {10, 10}}}});
    }
    void joined()
    {
        check({key("L"), type("10,10"), enter(), type("30,0"), enter(), type("0,20"), enter(),
               type("-30,0"), enter(), type("0,-20"), enter(), key("Ctrl+A"), key("Shift+J")},
              {{{{10, 30}, {10, 10}, {40, 10}, {40, 30}}, true}});
    }
};

QTEST_MAIN(NodesTest)
#include "nodes_test.moc"
