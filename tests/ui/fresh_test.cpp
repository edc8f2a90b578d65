// SPDX-License-Identifier: GPL-3.0-or-later
// Every widget of the program is open while everything changes elsewhere. After each change it must
// show the same as one that is made then: the same texts, states, items, and pixels on the screen.
// CLEARCUT_CHANGES and CLEARCUT_SEED set the number of changes and the seed.
#include "ui/sheets/sheets.h"

#include <QDirIterator>
#include <QMenuBar>
#include <QRegularExpression>

#include "tests/test_class.h"
#include "tests/ui/fresh/changes.h"
#include "tests/ui/fresh/lived.h"

namespace fresh_test {

using namespace ui;

namespace {

quint64 fromEnvironment(const char* name, quint64 usual)
{
    return qEnvironmentVariableIsSet(name) ? qEnvironmentVariable(name).toULongLong() : usual;
}

/// Each change once, in random order, again and again.
class Changes {
public:
    explicit Changes(Desk& desk) : desk_(desk) {}

    quint64 number() const { return fromEnvironment("CLEARCUT_CHANGES", all_.size()); }
    QString makeOne()
    {
        if (made_ % all_.size() == 0)
            std::ranges::shuffle(all_, desk_.random());
        const DeskChange& change = all_[made_ % all_.size()];
        change.make(desk_);
        return QStringLiteral("%1, %2: ").arg(made_++).arg(change.name);
    }

private:
    Desk& desk_;
    std::vector<DeskChange> all_ = deskChanges();
    std::size_t made_ = 0;
};

/// The classes of widgets that the sources declare, with their base classes.
QMap<QString, QString> widgetClasses()
{
    static const QRegularExpression head(
        QStringLiteral("^(?:class|struct) ([\\w:]+)(?: final)? : public (\\w+).*\\{$"));
    QMap<QString, QString> all;
    QDirIterator files(QStringLiteral(SOURCE_DIR "/ui"), {"*.h", "*.cpp"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        [[maybe_unused]] const bool isOpen = file.open(QIODevice::ReadOnly);
        for (const QString& line : QString::fromUtf8(file.readAll()).split(u'\n'))
            if (const auto match = head.match(line); match.hasMatch())
                all[match.captured(1)] = match.captured(2);
    }
    const auto isWidget = [&all](QString name) {
        static const QStringList other{
            "QObject",      "QStyledItemDelegate", "QAbstractTableModel", "QProxyStyle",
            "QApplication", "QIconEngine",         "QAbstractListModel",  "QUndoCommand",
            "QMenu"};
        while (all.contains(name))
            name = all[name];
        return name.startsWith(u'Q') && !other.contains(name);
    };
    QMap<QString, QString> widgets;
    for (const auto& [name, base] : all.asKeyValueRange())
        if (isWidget(name))
            widgets[name] = base;
    return widgets;
}

/// "ui::CodeView::Numbers", "ui::(anonymous namespace)::Chip": the last part.
QString lastPart(const QString& name) { return name.section(QStringLiteral("::"), -1); }

/// The state of all commands, and what the window shows.
Shown stateOf(const MainWindow& window)
{
    Shown shown = shownBy(window, onScreen(window));
    shown.facts.push_back({"window", "title", window.windowTitle()});
    shown.facts.push_back({"window", "modified", window.isWindowModified()});
    for (const QAction* action : window.findChildren<QAction*>()) {
        const QString name = action->objectName() + ' ' + action->text();
        if (name == u" ")
            continue;
        shown.facts.push_back({name, "enabled", action->isEnabled()});
        shown.facts.push_back({name, "checked", action->isChecked()});
        shown.facts.push_back({name, "why not", action->statusTip()});
    }
    return shown;
}

/// Tells every part of the window that what it shows may have changed.
void refresh(MainWindow& window)
{
    app::Session& session = window.session();
    emit session.displayChanged();
    emit session.selectionChanged();
    emit session.inspectedChanged();
    emit session.previewChanged();
    emit session.fileChanged();
    emit session.nodes.changed();
    emit session.entered.changed();
    emit session.course.changed();
    emit session.microscope.stepChanged();
    emit window.canvas().toolChanged();
    emit window.canvas().panesChanged();
    emit window.canvas().snappingChanged();
    emit window.canvas().stepsChanged();
    emit window.canvas().viewChanged();
    emit window.drawnLine().refreshed();
    emit window.files().nameChanged();
    emit window.sheets().changed();
    window.refreshActions();
}

} // namespace

class FreshTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        Timers::watch();
        dropRemarksOfThePlatform();
    }
    void cleanup() { QLocale::setDefault(usual_); }

    void whatLivesLongShowsWhatAFreshOneShows()
    {
        Lived lived(fromEnvironment("CLEARCUT_SEED", 1));
        QStringList faults = lived.faults(Lived::Which::All);
        Changes changes(lived.desk);
        for (quint64 i = 0; i < changes.number(); ++i) {
            if (lived.desk.likes(1, 4))
                lived.resize();
            const QString change = changes.makeOne();
            const bool all = i % 8 == 0 || change.contains("theme");
            for (const QString& fault : lived.faults(all ? Lived::Which::All : Lived::Which::Quick))
                faults << change + fault;
        }
        for (const QString& fault : faults)
            qWarning("%s", qPrintable(fault));
        QCOMPARE(faults.size(), 0);
    }

    void aWindowThatHasFollowedHasNothingToRefresh()
    {
        TestWindow test;
        test.show();
        test.run("settings");
        Desk desk(fromEnvironment("CLEARCUT_SEED", 2), *test.window);
        Changes changes(desk);
        for (quint64 i = 0; i < changes.number(); ++i) {
            const QString change = changes.makeOne();
            QVERIFY2(settle(), qPrintable(change));
            const Shown before = stateOf(*test.window);
            refresh(*test.window);
            settle();
            const QString difference = differenceBetween(before, stateOf(*test.window));
            QVERIFY2(difference.isEmpty(), qPrintable(change + difference));
        }
    }

    /// A new widget cannot be forgotten: it is in the catalogue, or stands here with its reason.
    void everyClassIsLookedAt()
    {
        QSet<QString> seen;
        const Lived lived(1);
        for (const QString& name : lived.classes())
            seen << lastPart(name);
        TestWindow test;
        for (const SheetInfo& sheet : sheets())
            showSheet(*test.window, sheet.key);
        for (const QWidget* part : test.window->findChildren<QWidget*>())
            seen << lastPart(classOf(*part));
        seen << "MainWindow";
        const QSet<QString> elsewhere{
            "ChoiceButton",      // only while a question is asked
            "Chip",              // beside the pointer while a colour is taken
            "GlSurface",         // needs a graphics card
            "Palette",           // a popup, filled anew when it is opened
            "RepeatDialog",      // modal, as the next ones: nothing changes elsewhere
            "MarginDialog",      //
            "JoinDialog",        //
            "WaitingDialog",     //
            "ExportStepsDialog", //
            "LineNumber",        // only while the next line is asked
            "PlaceSlider",       // only while the place of a cut is asked
            "PointerMark",       // only while steps are shown (tests/ui/showing)
            "Desk",    // holds windows, as the next one; editor/desk_test.cpp looks at both
            "TabMark", //
        };
        QStringList missing;
        const auto widgets = widgetClasses();
        QVERIFY(widgets.size() > 100);
        for (const auto& [name, base] : widgets.asKeyValueRange()) {
            const bool isBase = widgets.values().contains(name);
            if (!seen.contains(lastPart(name)) && !elsewhere.contains(name) && !isBase)
                missing << name;
        }
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join(' ')));
        for (const QString& name : elsewhere)
            QVERIFY2(widgets.contains(name) && !seen.contains(name), qPrintable(name));
    }

private:
    const QLocale usual_;
};

} // namespace fresh_test

TEST_CLASS(fresh_test::FreshTest, Widgets)
#include "tests/ui/fresh_test.moc"
