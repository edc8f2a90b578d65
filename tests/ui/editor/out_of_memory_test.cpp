// SPDX-License-Identifier: GPL-3.0-or-later
// The heap runs out while the whole window handles the keys of edits. Each edit is done or not, the
// window says which, and everything goes on.
#include "ui/editor/editor_application.h"

#include <array>
#include <cstdlib>
#include <limits>
#include <new>

#include "tests/app/document/sheet.h"
#include "tests/ui/test_window.h"
#include "tests/verify.h"

namespace {

constexpr std::size_t enough = std::numeric_limits<std::size_t>::max();
thread_local std::size_t left = enough; ///< the allocations until one fails

} // namespace

void* operator new(std::size_t size)
{
    void* const taken = left != enough && left-- == 0 ? nullptr : std::malloc(size > 0 ? size : 1);
    if (!taken)
        throw std::bad_alloc(); // `left` is `enough` again
    return taken;
}
void operator delete(void* given) noexcept { std::free(given); }
void operator delete(void* given, std::size_t) noexcept { std::free(given); }

using namespace ui;

namespace {

struct Window : TestWindow {
    Window()
    {
        app::Sheet sheet;
        sheet.layers = {{"Below"}, {"Above"}};
        for (std::uint32_t i = 0; i < 6; ++i) {
            app::Shape shape;
            shape.paths.push_back({{10.0 * i, 10}, {{{10.0 * i + 5, 40}}}, false});
            shape.style.stroke = app::Colour{};
            shape.layer = i % 2;
            sheet.shapes.push_back(shape);
        }
        window->session().load({app::documentOf(sheet), {}});
        show();
        window->session().select(app::ObjectRanges(app::ObjectRange{1, 4}));
        QCoreApplication::processEvents();
    }
    void key(int key, Qt::KeyboardModifiers modifiers = {}) const
    {
        try {
            QTest::keyClick(drawingArea(), Qt::Key(key), modifiers);
        } catch (const std::bad_alloc&) { // of QTest itself
        }
    }
};

struct Press {
    const char* name;
    int key;
    Qt::KeyboardModifiers modifiers;
};
constexpr std::array presses{Press{"move", Qt::Key_Right, {}}, Press{"delete", Qt::Key_Delete, {}},
                             Press{"duplicate", Qt::Key_D, Qt::ControlModifier},
                             Press{"group", Qt::Key_G, Qt::ControlModifier}};

} // namespace

class OutOfMemoryTest : public QObject {
    Q_OBJECT

private slots:
    void anEditIsDoneOrNot()
    {
        for (const Press& press : presses) {
            Window t;
            app::Session& session = t.window->session();
            const app::Document before = session.now();
            const int index = session.history.index();
            std::size_t failures = 0;
            // Each step allocates some ten thousand times, most of all for menus and panels.
            for (std::size_t at = 0; session.history.index() == index; at = at * 21 / 20 + 1) {
                t.window->tell({});
                left = at;
                t.key(press.key, press.modifiers);
                const bool failed = left == enough;
                left = enough;
                failures += failed;
                const QString what = QStringLiteral("%1, after %2").arg(press.name).arg(at);
                if (session.history.index() == index) {
                    VERIFY_OR_SAY(session.now() == before, qPrintable(what));
                    VERIFY_OR_SAY(failed, qPrintable(what));
                }
                QCoreApplication::processEvents();
                t.window->grab();
            }
            QVERIFY(failures > 20);
            QCOMPARE(session.history.index(), index + 1);
            session.history.undo();
            QVERIFY(session.now() == before);
            QCoreApplication::processEvents();
            t.window->grab();
        }
    }
};

int main(int argc, char** argv)
{
    EditorApplication application(argc, argv);
    OutOfMemoryTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "out_of_memory_test.moc"
