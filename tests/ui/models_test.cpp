// SPDX-License-Identifier: GPL-3.0-or-later
// Every model answers every question about every cell, also about cells that do not exist.
#include "app/commands/add_and_remove.h"
#include "ui/docks/algorithm_list.h"
#include "ui/docks/compare_model.h"
#include "ui/docks/difference_model.h"
#include "ui/docks/exactness_model.h"
#include "ui/docks/history_model.h"
#include "ui/docks/layer_model.h"
#include "ui/docks/window_model.h"
#include "ui/explanation/help_contents.h"
#include "ui/hard_cases/answer_table.h"
#include "ui/hard_cases/case_list.h"
#include "ui/menus/palette_list.h"
#include "ui/microscope/variable_model.h"
#include "ui/sheets/key_model.h"
#include "ui/widgets/table_model.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QDirIterator>
#include <QDockWidget>
#include <QRegularExpression>
#include <QTableView>
#include <QTreeView>

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"
#include "tests/verify.h"

namespace models_test {

using namespace ui;

namespace {

/// Two lines across the window, of which published KWC loses one.
app::Sheet twoLines()
{
    app::Sheet sheet;
    sheet.window = {{0, 0}, {100, 100}};
    for (const double lean : {0.5, 30.}) {
        app::Shape line;
        line.paths = {{{20, 40}, {{{20 + lean, 90}}}}};
        line.style.stroke = app::Colour{};
        sheet.shapes.push_back(std::move(line));
    }
    return sheet;
}

struct Drawing {
    explicit Drawing(const app::Sheet& sheet)
    {
        load(session.document, sheet);
        session.differences.setWindow(sheet.window);
        session.differences.ask(app::Comparison{*app::findVariant("kwc:published")});
        session.exactness.setWindow(sheet.window);
        session.exactness.ask(app::LiveExactness::Question{*app::findVariant("kwc:published")});
        session.differences.finish();
        session.exactness.finish();
    }
    app::Session session;
};

app::TracedLine crossing()
{
    return {app::exactVariant(), {{-10, 20}, {120, 80}}, {{0, 0}, {100, 100}}};
}

using Model = std::unique_ptr<QAbstractItemModel>;

/// One row for each class of a model: as many rows as its content has, and none.
struct Row {
    const char* name;
    Model (*full)(app::Session&);
    Model (*empty)(app::Session&); ///< null: it always has rows
};

template <class Shown>
Model ofSession(app::Session& session)
{
    return std::make_unique<Shown>(session);
}

template <class Shown>
Model alone(app::Session&)
{
    return std::make_unique<Shown>();
}

const std::vector<Row>& rows()
{
    static const std::vector<Row> all{
        {"AlgorithmModel",
         [](app::Session& session) -> Model {
             return std::make_unique<AlgorithmModel>(session, nullptr);
         },
         nullptr},
        {"AnswerModel",
         [](app::Session&) -> Model {
             auto model = std::make_unique<AnswerModel>();
             model->show(*app::casesFor({}).front());
             return model;
         },
         alone<AnswerModel>},
        {"CaseModel", alone<CaseModel>,
         [](app::Session&) -> Model {
             auto model = std::make_unique<CaseModel>();
             model->setFilter({.words = QStringLiteral("zzzz")});
             return model;
         }},
        {"CompareModel",
         [](app::Session& session) -> Model {
             app::Race race({app::exactVariant()});
             race.begin({session.scene.lines(), {{0, 0}, {100, 100}}});
             while (!race.step()) {
             }
             auto model = std::make_unique<CompareModel>();
             model->show(race.rows(), 2);
             return model;
         },
         alone<CompareModel>},
        {"DifferenceModel", ofSession<DifferenceModel>, ofSession<DifferenceModel>},
        {"ExactnessModel", ofSession<ExactnessModel>, ofSession<ExactnessModel>},
        {"HelpModel", alone<HelpModel>, nullptr},
        {"HistoryModel",
         [](app::Session& session) -> Model {
             return std::make_unique<HistoryModel>(session.history);
         },
         nullptr},
        {"KeyModel",
         [](app::Session&) -> Model {
             auto model = std::make_unique<KeyModel>();
             model->show(app::KeyTable({{QStringLiteral("save"),
                                         QStringLiteral("Save"),
                                         QStringLiteral("File"),
                                         {},
                                         {}}}),
                         {});
             return model;
         },
         alone<KeyModel>},
        {"LayerModel", ofSession<LayerModel>, nullptr},
        {"PaletteModel",
         [](app::Session&) -> Model {
             auto model = std::make_unique<PaletteModel>();
             model->show({{.name = QStringLiteral("Undo"), .match = {.letters = {0, 1}}}}, {});
             return model;
         },
         alone<PaletteModel>},
        {"TableModel",
         [](app::Session&) -> Model {
             auto model = std::make_unique<TableModel>();
             app::Table table;
             table.names = {QStringLiteral("algorithm"), QStringLiteral("lost")};
             table.rows = {{QStringLiteral("exact"), QStringLiteral("0")}};
             model->show(std::move(table));
             return model;
         },
         alone<TableModel>},
        {"VariableModel",
         [](app::Session&) -> Model {
             auto model = std::make_unique<VariableModel>();
             app::TracedLine traced = crossing();
             traced.variant = {clipping::findAlgorithm("liang-barsky")};
             model->show(app::narrationOf(traced).steps.back().variables);
             return model;
         },
         alone<VariableModel>},
        {"WindowModel", ofSession<WindowModel>, ofSession<WindowModel>}};
    return all;
}

app::Sheet nothing()
{
    app::Sheet sheet;
    sheet.layers = {{}};
    return sheet;
}

/// Asks the model for everything about a cell and a heading.
void askAll(const QAbstractItemModel& model, const QModelIndex& index, int section)
{
    for (int role = 0; role < Qt::UserRole + 16; ++role) {
        (void)model.data(index, role);
        for (const auto orientation : {Qt::Horizontal, Qt::Vertical})
            (void)model.headerData(section, orientation, role);
    }
    (void)model.flags(index);
}

/// The index of a cell, as a view keeps it although the row is gone.
class Foreign : public QAbstractListModel {
public:
    int rowCount(const QModelIndex&) const override { return 1000; }
    QVariant data(const QModelIndex&, int) const override { return {}; }
};

/// An index of this model, whether the cell exists or not.
class Maker : public QAbstractItemModel {
public:
    static QModelIndex indexOf(const QAbstractItemModel& model, int row, int column)
    {
        const auto make =
            static_cast<QModelIndex (QAbstractItemModel::*)(int, int, const void*) const>(
                &Maker::createIndex);
        return (model.*make)(row, column, nullptr);
    }
};

void probe(QAbstractItemModel& model)
{
    const int rows = model.rowCount(), columns = model.columnCount();
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            askAll(model, model.index(row, column), column);
    const Foreign foreign;
    for (const QModelIndex& index :
         {QModelIndex(), Maker::indexOf(model, rows, 0), Maker::indexOf(model, rows + 1000, 0),
          Maker::indexOf(model, 0, columns), Maker::indexOf(model, 0, columns + 1000),
          Maker::indexOf(model, -1, 0), foreign.index(0)}) {
        askAll(model, index, index.column());
        QCOMPARE(model.data(index), QVariant());
        QCOMPARE(model.flags(index), Qt::NoItemFlags);
        QVERIFY(!model.setData(index, QStringLiteral("x")));
        for (int role = Qt::UserRole; role < Qt::UserRole + 8; ++role)
            QVERIFY(!model.setData(index, 1, role));
    }
    for (const int section : {-1, columns, columns + 1000})
        askAll(model, {}, section);
    for (const int column : {-1, 0, columns - 1, columns, columns + 1000})
        for (const auto order : {Qt::AscendingOrder, Qt::DescendingOrder})
            model.sort(column, order);
}

} // namespace

class ModelsTest : public QObject {
    Q_OBJECT

private slots:
    /// A model that does not check is asked about rows that do not exist, and crashes.
    void everyModelIsCheckedAndTested()
    {
        const QRegularExpression derived(
            QStringLiteral(R"(class (\w+)(?: final)? : public (\w*(?:Model|ModelBase))\b)"));
        QStringList found, tested;
        for (const char* folder : {SOURCE_DIR "/ui", SOURCE_DIR "/app"})
            for (QDirIterator files(QString::fromUtf8(folder), {"*.h", "*.cpp"}, QDir::Files,
                                    QDirIterator::Subdirectories);
                 files.hasNext();) {
                QFile file(files.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                const QString text = QString::fromUtf8(file.readAll());
                for (auto match = derived.globalMatch(text); match.hasNext();) {
                    const auto names = match.next();
                    if (names.captured(1) == u"CheckedModel")
                        continue;
                    QCOMPARE(names.captured(2), QStringLiteral("CheckedModel"));
                    found << names.captured(1);
                }
            }
        for (const Row& row : rows())
            tested << QString::fromLatin1(row.name);
        found.sort();
        QCOMPARE(tested, found);
    }
    void everyQuestionIsAnswered_data()
    {
        QTest::addColumn<int>("number");
        for (int i = 0; i < int(rows().size()); ++i)
            QTest::newRow(rows()[std::size_t(i)].name) << i;
    }
    void everyQuestionIsAnswered()
    {
        QFETCH(int, number);
        const Row& row = rows()[std::size_t(number)];
        Drawing drawing(twoLines());
        const Model full = row.full(drawing.session);
        QVERIFY(full->rowCount() > 0);
        probe(*full);
        const QAbstractItemModelTester tester(
            full.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        if (!row.empty)
            return;
        Drawing blank(nothing());
        app::Edit edit;
        edit.windows = app::ClipWindows{};
        blank.session.document.apply(edit);
        const Model empty = row.empty(blank.session);
        QCOMPARE(empty->rowCount(), 0);
        const QAbstractItemModelTester alsoEmpty(
            empty.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        probe(*empty);
    }
    /// The tester listens while the drawing, its layers, its windows and its display change.
    void changesAreToldAsQtWantsThem()
    {
        Drawing drawing(twoLines());
        app::Session& session = drawing.session;
        std::vector<Model> models;
        std::vector<std::unique_ptr<QAbstractItemModelTester>> testers;
        for (const Row& row : rows()) {
            models.push_back(row.full(session));
            testers.push_back(std::make_unique<QAbstractItemModelTester>(
                models.back().get(), QAbstractItemModelTester::FailureReportingMode::QtTest));
        }
        const auto inches = [](app::Display& display) { display.unit = app::Unit::Inch; };
        session.changeDisplay(inches);
        session.history.push(new app::RemoveObjects(session.document, app::ObjectRanges({0, 1})));
        session.history.undo();
        load(session.document, nothing());
        session.changeDisplay([](app::Display& display) { display.unit = app::Unit::Mm; });
        load(session.document, twoLines());
        for (const Model& model : models)
            probe(*model);
    }
    void copyingFromAListWithoutACurrentRow()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        QGuiApplication::clipboard()->setText(QStringLiteral("as before"));
        for (auto* view : t.window->findChildren<QAbstractItemView*>()) {
            QAbstractItemModel* model = view->model();
            if (!model)
                continue;
            view->selectionModel()->clear();
            QCOMPARE(view->currentIndex(), QModelIndex());
            QTest::keyClick(view, Qt::Key_C, Qt::ControlModifier);
            const auto* table = qobject_cast<QTableView*>(view);
            const bool whole = table && table->selectionMode() == QAbstractItemView::NoSelection;
            if (!whole)
                QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("as before"));
        }
    }
};

} // namespace models_test

TEST_CLASS(models_test::ModelsTest, Widgets)
#include "tests/ui/models_test.moc"
