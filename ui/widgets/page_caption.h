// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QLabel>

namespace ui {

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
