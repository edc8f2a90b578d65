// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/session.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/app/document/first_window.h"
#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"

namespace session_session_test {

using app::ClipWindows;

namespace {

ClipWindows list(std::initializer_list<clipping::Window> boxes)
{
    ClipWindows windows;
    for (const clipping::Window& box : boxes)
        windows.list.push_back({.shape = app::RectangleShape{box}});
    return windows;
}

void setWindows(app::Session& session, const ClipWindows& windows)
{
    app::Edit edit;
    edit.windows = windows;
    session.document.apply(edit);
}

/// Whether a session's windows and region are those of its document and its preview.
bool isUpToDate(const app::Session& session)
{
    const ClipWindows windows = session.preview().windows.value_or(session.now().windows());
    return session.windows() == windows
           && session.region() == regionOf(windows, session.now().page());
}

/// A session whose windows are looked at whenever it says that something has changed.
struct Watched : app::Session {
    Watched()
    {
        const auto look = [this] {
            ++looks;
            outdated += !isUpToDate(*this);
        };
        connect(this, &Session::previewChanged, this, look);
        connect(this, &Session::selectionChanged, this, look);
        connect(&document, &app::EditedDocument::changed, this, look);
        connect(&scene, &app::Scene::outdated, this, look); // as soon as the document has changed
        connect(&history, &app::History::indexChanged, this, look);
    }
    int looks = 0, outdated = 0;
};

} // namespace

class SessionTest : public QObject {
    Q_OBJECT

private slots:
    // Saving over the file would lose what was there.
    void whatWasLostOrCutIsSavedUnderAnotherName()
    {
        const auto mustSaveAs = [](const app::Loss& loss) {
            app::Session session;
            app::Imported imported;
            imported.report = {loss};
            session.load(std::move(imported), "drawing.svg");
            return session.mustSaveAs();
        };
        QVERIFY(mustSaveAs({.what = "text"}));
        QVERIFY(!mustSaveAs({.what = "moved opacity", .remark = true}));
        QVERIFY(mustSaveAs({.what = "clip path", .remark = true, .cut = true}));
    }

    void newObjectsGoIntoTheTopmostLayerThatCanBeDrawnOn()
    {
        app::Sheet sheet;
        sheet.layers = {{"land"}, {"roads"}, {"hidden"}, {"frame"}};
        sheet.layers[2].visible = false;
        sheet.layers[3].locked = true;
        app::Session session;
        session.document.load(documentOf(sheet));
        QCOMPARE(session.now().containers()[session.pen.layer].name, "roads");
        sheet.layers[0].locked = sheet.layers[1].locked = true;
        session.document.load(documentOf(sheet));
        QCOMPARE(session.now().containers()[session.pen.layer].name, "frame");
    }
    void theDisplayIsChangedInOnePart()
    {
        app::Session session;
        const app::Display before = session.display();
        const QSignalSpy changed(&session, &app::Session::displayChanged);
        session.changeDisplay([](app::Display& display) { display.overlay = true; });
        app::Display expected = before;
        expected.overlay = true;
        QVERIFY(session.display() == expected);
        session.changeDisplay([](app::Display&) {});
        QCOMPARE(changed.size(), 1);
    }

    void windowsAreAlwaysThoseOfNow()
    {
        const clipping::Window a{{0, 0}, {5, 5}}, b{{2, 2}, {9, 9}}, c{{1, 1}, {3, 3}};
        const std::vector<std::function<void(app::Session&)>> steps{
            [&](app::Session& s) { s.setPreview({.windows = withWindow(s.now().windows(), a)}); },
            [&](app::Session& s) { s.history.push(windowStep(s.document, a)); },
            [&](app::Session& s) { s.setPreview({}); },
            [&](app::Session& s) {
                setWindows(s, list({a, b}));
            },
            [&](app::Session& s) { s.setPreview({.windows = withWindow(s.now().windows(), c)}); },
            [&](app::Session& s) {
                s.setPreview(
                    {.windows = withWindow(s.now().windows(), b), .line = clipping::Segment{}});
            },
            [&](app::Session& s) {
                setWindows(s, list({b, a}));
            }, // in the middle of a gesture
            [&](app::Session& s) { s.setPreview({.line = clipping::Segment{}}); },
            [&](app::Session& s) { setVisible(s, false); },
            [&](app::Session& s) { ::setPage(s.document, {}); },
            [&](app::Session& s) { s.history.undo(); },
            [&](app::Session& s) { s.history.redo(); },
            [&](app::Session& s) { s.setPreview({.windows = withWindow(s.now().windows(), c)}); },
            [&](app::Session& s) {
                s.load({app::documentOf(sheetAt(b)), {}});
            },
            [&](app::Session& s) { s.setPreview({.windows = withWindow(s.now().windows(), a)}); },
            [&](app::Session& s) { s.load({}); },
        };
        Watched session;
        QVERIFY(isUpToDate(session));
        for (const auto& step : steps) {
            const int before = session.looks;
            step(session);
            QVERIFY(session.looks > before);
            QVERIFY(isUpToDate(session));
        }
        QCOMPARE(session.outdated, 0);
    }

    void whatIsOpenedDuringASaveIsNotTheSavedFile()
    {
        app::Session session;
        setWindows(session, list({{{0, 0}, {5, 5}}}));
        session.history.resetClean();
        QVERIFY(session.beginSaving() == session.now());
        session.load({}, "other.svg");
        session.history.resetClean();
        session.endSaving("saved.svg");
        QCOMPARE(session.path(), "other.svg");
        QVERIFY(!session.history.isClean());
        session.beginSaving();
        session.endSaving("saved.svg");
        QCOMPARE(session.path(), "saved.svg");
        QVERIFY(session.history.isClean());
    }

    /// Frames ask several times each.
    void askingCopiesNothing()
    {
        app::Session session;
        setWindows(session, list({{{0, 0}, {5, 5}}, {{2, 2}, {9, 9}}}));
        session.setPreview(
            {.windows = withWindow(session.now().windows(), clipping::Window{{1, 1}, {3, 3}})});
        QVERIFY(session.windows().list.data() == session.windows().list.data());
        QVERIFY(session.region().steps.data() == session.region().steps.data());
    }
};

} // namespace session_session_test

TEST_CLASS(session_session_test::SessionTest, Core)
#include "tests/app/session/session_test.moc"
