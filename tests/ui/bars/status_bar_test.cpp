// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/transformation.h"
#include "app/session/window_kinds.h"
#include "app/session/window_steps.h"
#include "ui/bars/option_bar.h"
#include "ui/tools/tool.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/status_cell.h"
#include "ui/widgets/tabular.h"

#include <QStatusBar>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace bars_status_bar_test {

using namespace ui;

// The hints in the status bar.
class StatusBarTest : public QObject {
    Q_OBJECT

    struct Window : TestWindow {
        explicit Window(const QSize& size)
        {
            window->resize(size);
            show();
            QCoreApplication::processEvents();
            hint = window->statusBar()->findChild<ElidedLabel*>("hint");
        }
        int room() const { return hint->contentsRect().width(); }
        int widthOf(const QString& text) const
        {
            return hint->fontMetrics().horizontalAdvance(text);
        }
        /// Says what is wrong if the hint that is wanted now has no room.
        QString fault() const
        {
            const QString wanted = window->canvas().toolHint();
            return !wanted.isEmpty() && widthOf(wanted) <= room()
                       ? QString()
                       : QStringLiteral("%1: %2 of %3 pixels")
                             .arg(wanted)
                             .arg(widthOf(wanted))
                             .arg(room());
        }
        ElidedLabel* hint = nullptr;
    };

private slots:
    void theHintOfEveryToolFits_data()
    {
        QTest::addColumn<QString>("sample");
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("dark"); // where the switch for dark paper takes room
        QTest::newRow("an empty drawing") << QString() << QSize(1280, 800) << false;
        QTest::newRow("44,000 lines and a clip window")
            << QStringLiteral("landscape") << QSize(1280, 800) << false;
        QTest::newRow("in the dark theme")
            << QStringLiteral("landscape") << QSize(1280, 800) << true;
        QTest::newRow("the smallest window")
            << QStringLiteral("landscape") << QSize(1024, 640) << false;
    }
    void theHintOfEveryToolFits()
    {
        QFETCH(QString, sample);
        QFETCH(QSize, size);
        QFETCH(bool, dark);
        Window w(size);
        w.window->setTheme(dark ? Theme::Dark : Theme::Light);
        if (!sample.isEmpty())
            w.open(QStringLiteral(SOURCE_DIR "/resources/samples/") + sample + ".svg");
        QCoreApplication::processEvents(); // the cells beside it have their widths
        QCOMPARE(w.window->session().windows().list.empty(), sample.isEmpty());
        for (const ToolInfo& tool : tools()) {
            w.window->canvas().setTool(tool.key);
            QVERIFY2(w.fault().isEmpty(), qPrintable(tool.name + u' ' + w.fault()));
            QCOMPARE(w.hint->text(), w.hint->whole());
        }
        for (const app::WindowKind& kind : app::windowKinds()) { // of the last tool
            app::setNextWindow(w.window->session(), kind.key);
            QVERIFY2(w.fault().isEmpty(), qPrintable(w.fault()));
        }
    }
    void theHintOfWhatIsSelectedFits()
    {
        Window w({1280, 800});
        w.open(QStringLiteral(SOURCE_DIR "/resources/samples/landscape.svg"));
        QCoreApplication::processEvents();
        w.window->canvas().setTool("select");
        w.window->session().select({0});
        QVERIFY2(w.fault().isEmpty(), qPrintable(w.fault()));
        for (const app::Transformation& kind : app::transformations()) {
            w.window->canvas().transform(kind);
            QVERIFY2(w.fault().isEmpty(), qPrintable(w.fault()));
            w.window->canvas().endGesture();
        }
        w.window->canvas().setTool("nodes");
        QVERIFY2(w.fault().isEmpty(), qPrintable(w.fault()));
    }
    void aLongHintIsElidedAndWholeInItsTooltip()
    {
        Window w({1000, 800});
        const QString sentence = QStringLiteral("A sentence of several words. ").repeated(20);
        emit w.window->canvas().hint(sentence);
        QVERIFY(w.hint->text().endsWith(u'…') && w.widthOf(w.hint->text()) <= w.room());
        QVERIFY(w.hint->toolTip().startsWith(sentence));
    }
    void theRoomForThePointerIsThatOfTheDrawing()
    {
        Window w({1280, 800});
        const auto width = [&] {
            for (const QWidget* part : w.window->statusBar()->findChildren<QWidget*>())
                if (part->accessibleName() == "Pointer")
                    return part->width();
            return 0;
        };
        const int before = width();
        QVERIFY(before > 0);
        w.open(w.file("field.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='90000mm' "
                                   "height='90000mm' viewBox='0 0 9 9'><path d='M0 0L9 9' "
                                   "stroke='#000'/></svg>"));
        QTRY_VERIFY(width() > before);
    }
    void presentingCutsNoField()
    {
        Window w({1280, 800});
        w.window->canvas().setTool("line"); // has the field of the stroke
        const int before = w.hint->fontMetrics().height();
        w.run("presentation");
        QTRY_VERIFY(w.hint->fontMetrics().height() > before);
        const OptionBar& bar = w.window->optionBar();
        int seen = 0;
        for (const LengthField* field : bar.findChildren<LengthField*>())
            if (field->isVisible()) {
                QTRY_COMPARE(field->seenText(), field->text());
                ++seen;
            }
        QVERIFY(seen > 0);
        const auto* zoom = w.window->statusBar()->findChild<ZoomButton*>();
        QVERIFY(tabularWidth(zoom->fontMetrics(), "10,000 % ▾") < zoom->width());
        w.run("presentation");
        QTRY_COMPARE(w.hint->fontMetrics().height(), before);
    }
};

} // namespace bars_status_bar_test

TEST_CLASS(bars_status_bar_test::StatusBarTest, Widgets)
#include "tests/ui/bars/status_bar_test.moc"
