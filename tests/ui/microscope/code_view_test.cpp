// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/code_view.h"

#include <QScrollBar>
#include <QTest>
#include <QTextBlock>
#include <QTextLayout>

#include "tests/test_class.h"

namespace microscope_code_view_test {

class CodeViewTest : public QObject {
    Q_OBJECT

private slots:
    void aLongLineIsWrappedNotCutOff()
    {
        ui::CodeView view;
        view.resize(240, 400);
        view.show({"if a", "    x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2"}, {1, 2});
        view.QWidget::show();
        QVERIFY(QTest::qWaitForWindowExposed(&view));
        QVERIFY(!view.horizontalScrollBar()->isVisible());
        const QTextBlock block = view.document()->lastBlock();
        const QTextLayout& lines = *block.layout();
        QVERIFY(lines.lineCount() > 1);
        for (int i = 0; i < lines.lineCount(); ++i) {
            const QTextLine line = lines.lineAt(i);
            QVERIFY(line.x() + line.naturalTextWidth() <= view.viewport()->width());
        }
        const QFontMetrics metrics(view.font());
        QCOMPARE(lines.lineAt(1).x() - lines.lineAt(0).x(),
                 8.0 * metrics.horizontalAdvance(u' ')); // 4 spaces, and 4 further
        QCOMPARE(view.document()->firstBlock().layout()->lineCount(), 1);
    }
};

} // namespace microscope_code_view_test

TEST_CLASS(microscope_code_view_test::CodeViewTest, Widgets)
#include "tests/ui/microscope/code_view_test.moc"
