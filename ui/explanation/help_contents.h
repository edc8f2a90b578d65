// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/help_search.h"
#include "ui/widgets/checked_model.h"

#include <QStyledItemDelegate>

class QListView;

namespace ui {

class SearchField;

/// The pages of the help below the headings of their parts; or, while something is sought, the
/// pages that have it, with the words around it.
class HelpModel : public CheckedModel {
    Q_OBJECT

public:
    enum Role { IsPageRole = Qt::UserRole, WhyRole };

    explicit HelpModel(QObject* parent = nullptr);

    void setCommands(const app::HelpCommands& commands) { commands_ = commands; }
    void find(const QString& typed);          ///< empty: all pages
    int found() const;                        ///< the number of pages
    const app::HelpPage* page(int row) const; ///< null: a heading
    int rowOf(const QString& link) const;     ///< -1: it is not listed
    int firstPage() const { return rowOf({}); }

protected:
    int rows() const override { return int(lines_.size()); }
    QVariant cell(int row, int column, int role) const override;

private:
    struct Line {
        QString text; ///< of a heading, or the words that were found
        const app::HelpPage* page = nullptr;
    };
    std::vector<Line> lines_;
    app::HelpCommands commands_;
};

/// The contents of the help at the left of its pages, with a field that searches them.
class HelpContents : public QWidget {
    Q_OBJECT

public:
    explicit HelpContents(QWidget* parent = nullptr);

    void setCommands(const app::HelpCommands& commands);
    void showPlace(const QString& link); ///< the page that is read
    void search();                       ///< gives the focus to the field
    QListView& list() { return *list_; }

signals:
    void chosen(const QString& link);

private:
    void find();

    SearchField* field_;
    QListView* list_;
    HelpModel* model_;
    QString place_;
};

} // namespace ui
