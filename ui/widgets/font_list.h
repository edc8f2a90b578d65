// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets/tool_list.h"

namespace ui {

/// The fonts of texts: those of single strokes, then those that are installed, each kind below a
/// heading. Typed letters choose a font that begins with them.
class FontList : public ToolList {
    Q_OBJECT

public:
    explicit FontList(QWidget* parent = nullptr);

    /// A font that is not installed is named, but chooses none.
    void show(const QString& font);
    QString font() const; ///< empty: none is chosen

protected:
    bool event(QEvent* event) override;

private:
    void fill();
    void addHeading(const QString& text);
};

} // namespace ui
