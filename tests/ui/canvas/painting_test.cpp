// SPDX-License-Identifier: GPL-3.0-or-later
// A paint event clips and compares nothing: clipping, the differences and the exactness of an
// algorithm are computed on other threads.
#include <QThread>

#include <atomic>
#include <functional>

#include "tests/ui/canvas/pane_stage.h"

using namespace clipping;

namespace {

int painting = 0; // paint events that are being handled
int paints = 0;
// Calls of the counted algorithm.
std::atomic<int> callsInPaint = 0, callsElsewhere = 0; // on the interface's thread; on others
std::function<void()> atPaint = [] {};

/// Reports when a widget paints.
class Application : public QApplication {
public:
    using QApplication::QApplication;
    bool notify(QObject* receiver, QEvent* event) override
    {
        if (event->type() != QEvent::Paint)
            return QApplication::notify(receiver, event);
        ++painting;
        ++paints;
        atPaint();
        const bool done = QApplication::notify(receiver, event);
        --painting;
        return done;
    }
};

std::size_t countedClipAll(std::span<const Segment> in, const Window& window,
                           std::span<Clipped> out)
{
    if (QThread::currentThread() != qApp->thread())
        ++callsElsewhere;
    else if (painting > 0)
        ++callsInPaint;
    return findAlgorithm("kwc")->published->clipAll(in, window, out);
}

/// Published KWC, which loses lines, with a counter of its calls.
const Algorithm& counted()
{
    static const auto uses = [] {
        auto made = *findAlgorithm("kwc")->published;
        made.clipAll = countedClipAll;
        return made;
    }();
    static const Algorithm row = [] {
        Algorithm made = *findAlgorithm("kwc");
        made.published = &uses;
        return made;
    }();
    return row;
}

void forget() { callsInPaint = callsElsewhere = paints = 0; }

/// Drags the window's corner, a frame at each step.
void dragCorner(Stage& stage, int steps)
{
    stage.canvas->setTool("window");
    const app::Point corner = stage.session.window().max;
    stage.move(corner);
    stage.press(corner);
    for (int i = 1; i <= steps; ++i) {
        // QTest::qWait() leaves events in an order in which new ones come after waiting paint
        // requests (it sends those of DeferredDelete alone); this restores that of priorities.
        QCoreApplication::processEvents();
        const int before = paints;
        stage.move(corner - app::Point(4. * i, 2. * i), Qt::LeftButton,
                   Qt::ControlModifier); // which does not snap
        QTRY_VERIFY(paints > before);
    }
}

} // namespace

class PaintingTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { ui::applyTheme(*qApp, ui::Theme::Light); }
    void cleanup()
    {
        atPaint = [] {};
    }

    void paintingComparesNothing()
    {
        Stage stage(ui::Backend::Raster, steepLines());
        const app::Variant variant{&counted(), published};
        stage.session.differences.ask(app::Comparison{variant});
        stage.session.exactness.ask(app::LiveExactness::Question{variant});
        QTRY_VERIFY(stage.session.differences.upToDate() && stage.session.exactness.upToDate());
        stage.canvas->settle();
        forget();
        const app::LiveFinding* const findings[]{&stage.session.differences,
                                                 &stage.session.exactness};
        std::optional<Window> late[2]; // where it took longer than a frame waits, and said so
        for (const int i : {0, 1})
            QObject::connect(findings[i], &app::LiveFinding::changed, stage.canvas.get(), [&, i] {
                if (!findings[i]->upToDate())
                    late[i] = stage.session.window();
            });
        int unmarked = 0;
        atPaint = [&] {
            const Window window = stage.session.window();
            unmarked += (!stage.session.differences.at(window) && late[0] != window)
                        || (stage.session.exactness.piecesAt(window).empty() && late[1] != window);
        };
        dragCorner(stage, 8);
        QVERIFY(stage.session.preview().windows);
        QCOMPARE(callsInPaint, 0);
        QVERIFY(callsElsewhere >= 8);
        QCOMPARE(unmarked, 0); // unless they are late, each frame has its marks: no flicker
        QVERIFY(!stage.session.differences.found().list.empty());
        stage.key(Qt::Key_Escape);
        QTRY_COMPARE(stage.session.differences.found().window, stage.session.window());
        QCOMPARE(callsInPaint, 0);
    }

    /// Nor does a pane whose algorithm differs from exact.
    void paintingAPaneClipsNothing()
    {
        PaneStage stage(2);
        app::Panes panes = stage.canvas->panes();
        panes.activate(1);
        panes.choose({&counted(), published});
        stage.canvas->setPanes(panes);
        stage.canvas->settle();
        forget();
        dragCorner(stage, 8);
        QCOMPARE(callsInPaint, 0);
        QVERIFY(callsElsewhere >= 8); // to be shown and compared
    }
};

int main(int argc, char** argv)
{
    Application application(argc, argv);
    PaintingTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tests/ui/canvas/painting_test.moc"
