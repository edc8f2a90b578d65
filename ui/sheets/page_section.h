// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/page_steps.h"

#include <QMap>
#include <QVBoxLayout>
#include <QWidget>

class QLabel;

namespace ui {

class LengthField;
class LookLabel;
class RefusalFrame;

/// A titled part of the sheet *Page*, which shows a part of the page and changes it.
class PageSection : public QWidget {
    Q_OBJECT

public:
    PageSection(const QString& title, app::Session& session, app::PageEditing& editing);

    virtual void follow() = 0; ///< shows the page as it is now

signals:
    void entered(); ///< Enter was pressed in a field whose number was taken

protected:
    const app::Page& page() const { return session_.now().page(); }
    app::Session& session() { return session_; }
    QVBoxLayout& column() { return *column_; }
    QHBoxLayout* addRow(); ///< parts of it are beside each other
    /// Takes another page; why not is said under the field, which has its old number again.
    void take(const app::Result<app::Page>& page, QWidget& field);
    /// Says under this section what a field refuses, and passes its Enter on.
    void listen(LengthField& field);
    /// Shows a number, unless another one is being typed there.
    void fill(LengthField& field, double number, app::Unit unit);
    app::Unit paperUnit() const { return page().paperUnit(session_.display().unit); }

private:
    void refuse(QWidget& field, const QString& sentence);
    void withdraw();

    app::Session& session_;
    app::PageEditing& editing_;
    QVBoxLayout* column_;
    LookLabel* refusal_;
    QMap<QWidget*, RefusalFrame*> frames_;
    bool refusing_ = false; ///< what was typed gives way to the number before
};

} // namespace ui
