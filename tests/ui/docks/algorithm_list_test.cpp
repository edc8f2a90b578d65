// SPDX-License-Identifier: GPL-3.0-or-later
// Choosing an algorithm that cannot clip at the window in hand.
#include "app/session/window_kinds.h"
#include "ui/bars/status_bar.h"
#include "ui/canvas/pane_heading.h"
#include "ui/docks/algorithm_list.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/widgets/status_cell.h"

#include <QRadioButton>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace docks_algorithm_list_test {

using namespace ui;

namespace {

app::ClipWindow windowOf(std::string_view kind, const QString& name = {})
{
    const auto kinds = app::windowKinds();
    const auto found = std::ranges::find(kinds, kind, &app::WindowKind::key);
    return {name, found->make({{10, 10}, {90, 90}})};
}

struct Window : TestWindow {
    explicit Window(const app::ClipWindows& windows)
    {
        open(twoLines());
        show();
        app::Session& session = window->session();
        app::Edit edit;
        edit.windows = windows;
        session.document.apply(edit);
    }
    app::Session& session() { return window->session(); }
    void choose(const char* key, clipping::Form form = clipping::Form::Corrected)
    {
        session().changeDisplay([&](app::Display& display) {
            display.variant = {clipping::findAlgorithm(key), form};
        });
    }
    AlgorithmList& list() { return *window->algorithmPanel().findChild<AlgorithmList*>(); }
    QString tooltip(const char* key)
    {
        const auto row = clipping::findAlgorithm(key) - clipping::algorithms().data();
        return list().model()->index(int(row), 0).data(Qt::ToolTipRole).toString();
    }
    QString instead() { return window->algorithmPanel().instead(); }
    QString status()
    {
        for (const auto* cell : window->statusBar()->findChildren<StatusCell*>())
            if (cell->accessibleName() == "Algorithm")
                return cell->text();
        return {};
    }
};

} // namespace

class AlgorithmListTest : public QObject {
    Q_OBJECT

private slots:
    void aRowSaysWhyItCannotClip()
    {
        Window w({{windowOf("star", "Star")}});
        QVERIFY(w.tooltip("lb").endsWith("Not at this window: rectangles only"));
        QVERIFY(w.tooltip("cb").endsWith("Not at this window: convex only"));
        QVERIFY(!w.tooltip("ex").contains("Not at"));
        Window round({{windowOf("ellipse")}});
        QVERIFY(!round.tooltip("cb").contains("Not at"));
    }
    void theChoiceStaysAndWhatIsUsedIsSaid()
    {
        Window w({{windowOf("star", "Star")}});
        w.choose("lb");
        QCOMPARE(w.session().variant().algorithm, clipping::findAlgorithm("lb"));
        QCOMPARE(w.instead(), "Exact is used instead: Liang-Barsky clips at rectangles only.");
        QCOMPARE(w.status(), "EX instead of LB");
        w.choose("ex");
        QCOMPARE(w.instead(), "");
        QCOMPARE(w.status(), "EX");
    }
    void aHiddenStarNeedsNothing()
    {
        app::ClipWindows windows{{windowOf("rectangle"), windowOf("star", "Star")}};
        windows.list[1].visible = false;
        Window w(windows);
        w.choose("lb");
        QCOMPARE(w.instead(), "");
        windows.list[1].visible = true;
        w.session().setPreview({.windows = windows});
        QCOMPARE(w.instead(), "Exact is used instead: Liang-Barsky clips at rectangles only.");
        QVERIFY(!w.tooltip("lb").contains("Not at")); // the window in hand is the rectangle
    }
    void publishedFormsAreForRectangles()
    {
        Window w({{windowOf("ellipse")}});
        w.choose("cb", clipping::Form::Published);
        QCOMPARE(w.instead(), "The corrected form is used instead: the published one clips at "
                              "rectangles only.");
        const auto radios = w.window->algorithmPanel().findChildren<QRadioButton*>();
        QVERIFY(!radios[1]->isEnabled());
        QCOMPARE(radios[1]->toolTip(), "Published forms clip at rectangles only");
    }
    void theMenuSaysIt()
    {
        Window w({{windowOf("star", "Star")}});
        QStringList names;
        w.window->refreshActions();
        for (const auto* action : w.window->findChildren<QAction*>())
            names << action->text();
        QVERIFY(names.contains("Liang-Barsky (rectangles only)"));
        QVERIFY(names.contains("Cyrus-Beck (convex only)"));
    }
    void panesSayIt()
    {
        Window w({{windowOf("star", "Star")}});
        app::Panes panes = w.window->canvas().panes();
        panes.show(2);
        w.window->canvas().setPanes(panes);
        QStringList tips;
        for (const auto* heading : w.window->canvas().findChildren<PaneHeading*>())
            tips << heading->toolTip();
        QVERIFY2(tips.contains("Cohen-Sutherland does not clip Star: rectangles only"),
                 qPrintable(tips.join("; ")));
    }
};

} // namespace docks_algorithm_list_test

TEST_CLASS(docks_algorithm_list_test::AlgorithmListTest, Widgets)
#include "tests/ui/docks/algorithm_list_test.moc"
