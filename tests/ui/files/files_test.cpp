// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/document_builder.h"
#include "app/session/export_source.h"
#include "ui/files/files.h"

#include <QTest>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace files_files_test {

using namespace ui;

namespace {

/// Dashed lines across the page: each piece begins at another place of the pattern.
app::Document dashedLines()
{
    app::DocumentBuilder builder;
    builder.open({.name = "layer"});
    for (int y = 0; y < 50; ++y) {
        const app::Style style{.stroke = app::Colour{}, .width = 1, .dashes = {3, 2}};
        builder.add({app::Path(clipping::Segment{{y / 100.0, y}, {50, y}}), style});
    }
    builder.close();
    return builder.take({});
}

void setWindow(app::Session& session, const clipping::Window& window)
{
    app::Edit edit;
    edit.windows = app::ClipWindows{{{.shape = app::RectangleShape{window}}}};
    session.document.apply(edit);
}

/// Exports the cut drawing, and waits until it is written.
void exportCut(const TestWindow& t, const QString& path)
{
    const app::Format& format = *app::formatOfFile(path);
    t.window->files().exportTo(
        {app::exportSourceOf(t.window->session()), {.format = std::string(format.key)}}, path);
    t.window->files().wait();
}

} // namespace

class FilesTest : public QObject {
    Q_OBJECT

private slots:
    void exportingAddsNoStyleToTheDocument()
    {
        TestWindow t;
        app::Session& session = t.window->session();
        session.load({dashedLines(), {}});
        const app::Document document = session.now();
        const std::size_t styles = document.styles().size();
        for (const char* const file : {"out.svg", "out.csv", "out.png"})
            for (const double x : {10.25, 20.5}) {
                setWindow(session, {{x, 5}, {40, 45}});
                exportCut(t, t.path(file));
                QVERIFY2(t.window->message().contains("Exported"), qPrintable(t.window->message()));
                QCOMPARE(session.now().styles().size(), styles);
            }
        QVERIFY(session.now().objects() == document.objects());
        const auto cut = app::readFile(t.path("out.svg"));
        QVERIFY(cut);
        QVERIFY(cut.value->document.styles().size() > 30); // made by the cut
    }
    // It was perhaps left over from a comparison.
    void aPublishedFormIsNamedAfterTheCut()
    {
        TestWindow t;
        app::Session& session = t.window->session();
        session.load({dashedLines(), {}});
        setWindow(session, {{10, 5}, {40, 45}});
        for (const auto form : {clipping::Form::Published, clipping::Form::Corrected}) {
            session.changeDisplay([form](app::Display& display) {
                display.variant = {clipping::findAlgorithm("kwc"), form};
            });
            exportCut(t, t.path("out.svg"));
            QVERIFY2(t.window->message().contains("Exported"), qPrintable(t.window->message()));
            QCOMPARE(t.window->message().contains("KWC as published"),
                     form == clipping::Form::Published);
        }
    }
};

} // namespace files_files_test

TEST_CLASS(files_files_test::FilesTest, Widgets)
#include "tests/ui/files/files_test.moc"
