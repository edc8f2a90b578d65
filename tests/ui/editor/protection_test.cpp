// SPDX-License-Identifier: GPL-3.0-or-later
// Whether unsaved work would survive a crash is seen as long as it would not.
#include "app/commands/move_objects.h"
#include "ui/editor/recovery.h"
#include "ui/widgets/status_cell.h"

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace editor_protection_test {

using namespace ui;

namespace {

constexpr int patience = 60'000; // milliseconds, against a hang

/// A window whose state folder cannot be made, because a file has its name.
struct Unprotected : TestWindow {
    Unprotected()
    {
        show();
        [[maybe_unused]] const bool made = inTheWay.open(QIODevice::WriteOnly);
        app::Journal::Limits limits;
        limits.retry = std::chrono::milliseconds(20);
        recovery.emplace(*window, inTheWay.fileName(), limits);
        cell = window->findChild<WarningButton*>();
        open(twoLines());
    }
    ~Unprotected() { recovery.reset(); }
    void edit() const
    {
        app::Session& session = window->session();
        session.history.push(new app::MoveObjects(session.document, {0}, {1, 0}));
    }
    bool warns() const { return cell->isVisible() && cell->sentence().contains("not protected"); }

    QFile inTheWay{folder.filePath("unsaved")};
    std::optional<Recovery> recovery;
    WarningButton* cell = nullptr;
};

} // namespace

class ProtectionTest : public QObject {
    Q_OBJECT

private slots:
    void theWarningStaysAsLongAsItIsTrue()
    {
        Unprotected t;
        QVERIFY(t.cell && !t.warns()); // there is nothing to lose yet
        t.edit();
        QVERIFY(t.warns());
        QCOMPARE(t.window->message(), t.cell->sentence());
        t.edit();
        QVERIFY(t.warns());
        QCOMPARE(t.window->message(), t.cell->sentence());
        t.window->tell({Message::Kind::Done, "Something else."});
        QVERIFY(t.warns());
        t.cell->click();
        QCOMPARE(t.window->message(), t.cell->sentence());
        QVERIFY(t.saved());
        QVERIFY(!t.warns());
        QVERIFY(!t.window->message().contains("not protected"));
        t.edit();
        QVERIFY(t.warns());
    }
    void itComesForEveryDrawing()
    {
        Unprotected t;
        t.edit();
        t.answers->answer = Questions::Answer::DontSave;
        t.open(t.twoLines());
        QVERIFY(!t.warns());
        t.edit();
        QVERIFY(t.warns());
        QCOMPARE(t.window->message(), t.cell->sentence());
    }
    void itGoesWhenTheFolderCanBeWritten()
    {
        Unprotected t;
        t.edit();
        QVERIFY(t.warns());
        QVERIFY(t.inTheWay.remove());
        QTRY_VERIFY_WITH_TIMEOUT(!t.warns(), patience); // without another step
        QVERIFY(t.window->message().isEmpty());
        t.edit();
        QVERIFY(!t.warns());
    }
};

} // namespace editor_protection_test

TEST_CLASS(editor_protection_test::ProtectionTest, Widgets)
#include "tests/ui/editor/protection_test.moc"
