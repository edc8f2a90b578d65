// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/option_bar.h"
#include "ui/tools/tool.h"
#include "ui/widgets/segments.h"

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace ui::bars_option_bar_test {

// The bar across the top offers what has an effect now.
class OptionBarTest : public QObject {
    Q_OBJECT

    struct Bar {
        Bar() { t.show(); }
        bool shows(const char* choice)
        {
            for (const auto* segments : t.window->optionBar().findChildren<Segments*>())
                if (segments->accessibleName() == choice)
                    return segments->isVisible();
            return false;
        }
        void setPanes(std::size_t count)
        {
            app::Panes panes = t.window->canvas().panes();
            panes.show(count);
            t.window->canvas().setPanes(panes);
        }

        TestWindow t;
    };

private slots:
    void clippingIsOfferedWhileThereIsAWindow()
    {
        Bar bar;
        QTRY_VERIFY(!bar.shows("Removed part"));
        bar.t.run("window-on-page");
        QTRY_VERIFY(bar.shows("Removed part"));
        bar.t.window->canvas().setTool("window");
        QTRY_VERIFY(bar.shows("Removed part"));
        bar.t.window->canvas().setTool("select");
        bar.t.run("undo");
        QTRY_VERIFY(!bar.shows("Removed part"));
        bar.t.open(QStringLiteral(SOURCE_DIR "/resources/samples/nine-regions.svg"));
        QTRY_VERIFY(bar.shows("Removed part"));
    }
    void theBarNamesTheToolAndHasItsOptions()
    {
        Bar bar;
        const auto shows = [&](const char* name) {
            const auto* part = bar.t.window->optionBar().findChild<QWidget*>(name);
            return part && part->isVisible();
        };
        const auto buttonsOf = [&](const char* command) {
            int shown = 0;
            for (const auto* button : bar.t.window->optionBar().findChildren<QToolButton*>())
                shown += button->isVisible() && button->defaultAction() == bar.t.action(command);
            return shown;
        };
        auto* tool = bar.t.window->optionBar().findChild<QToolButton*>("tool-in-hand");
        for (const ToolInfo& info : tools()) {
            bar.t.window->canvas().setTool(info.key);
            QCOMPARE(tool->text(), info.name);
            const bool isView = info.key == "hand" || info.key == "zoom";
            QTRY_COMPARE(shows("style"), info.draws()); // the stroke
            QTRY_COMPARE(shows("window-shapes"), info.key == "window");
            QTRY_COMPARE(buttonsOf("fit-page"), int(isView));
        }
    }
    // Where is what, does not depend on the tool.
    void theRightGroupNeverMoves()
    {
        Bar bar;
        bar.t.window->resize(1280, 800);
        bar.t.run("window-on-page");
        const auto places = [&] {
            std::vector<int> x;
            for (const char* name : {"snap-choice", "export-button"})
                x.push_back(bar.t.window->optionBar().findChild<QWidget*>(name)->x());
            return x;
        };
        const auto before = places();
        for (const ToolInfo& info : tools()) {
            bar.t.window->canvas().setTool(info.key);
            QCoreApplication::processEvents();
            QCOMPARE(places(), before);
        }
        bar.t.window->canvas().setTool("select");
        bar.t.run("select-all");
        QCoreApplication::processEvents();
        QCOMPARE(places(), before);
    }
    void panesAreOfferedToCompareOrToCloseThem()
    {
        Bar bar;
        bar.t.run("workspace-cut");
        QTRY_VERIFY(!bar.shows("Panes"));
        bar.setPanes(4);
        QTRY_VERIFY(bar.shows("Panes"));
        bar.setPanes(1);
        QTRY_VERIFY(!bar.shows("Panes"));
        bar.t.run("workspace-compare");
        QTRY_VERIFY(bar.shows("Panes"));
    }
    void exportHasItsWord()
    {
        struct Case {
            const char* workspace;
            int width;
        };
        Bar bar;
        bar.t.run("window-on-page");
        for (const auto& [workspace, width] :
             {Case{"workspace-draw", 1024}, Case{"workspace-cut", 1024},
              Case{"workspace-learn", 1024}, Case{"workspace-compare", 1280}}) {
            bar.t.window->resize(width, 680);
            bar.t.run(workspace);
            int words = 0;
            for (const auto* button : bar.t.window->optionBar().findChildren<QToolButton*>())
                if (button->defaultAction() == bar.t.action("export"))
                    words += button->toolButtonStyle() == Qt::ToolButtonTextBesideIcon;
            QCOMPARE(words, 1);
        }
    }
};

} // namespace ui::bars_option_bar_test

TEST_CLASS(ui::bars_option_bar_test::OptionBarTest, Widgets)
#include "tests/ui/bars/option_bar_test.moc"
