// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLabel>
#include <QWidget>

class QHBoxLayout;

namespace app {
class Session;
}

namespace ui {

/// The title of a part of a page, in the style of dock titles; a muted remark may follow it, and a
/// link may be at its right.
class Heading : public QWidget {
    Q_OBJECT

public:
    explicit Heading(const QString& title, QWidget* parent = nullptr);
    void setRemark(const QString& remark);
    void add(QWidget* widget);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QHBoxLayout* row_;
    QLabel* remark_;
};

/// Says where a panel compares, or that it does not, and why; visible only if that is not the one
/// clip window of the drawing. AtThePage: for a panel that refers to the page then.
class PageCaption : public QLabel {
    Q_OBJECT

public:
    enum class Elsewhere : std::uint8_t { NotCompared, AtThePage };

    explicit PageCaption(const app::Session& session, Elsewhere elsewhere = Elsewhere::NotCompared,
                         QWidget* parent = nullptr);

private:
    void follow();

    const app::Session& session_;
    Elsewhere elsewhere_;
};

} // namespace ui
