// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/formulas/expression.h"

namespace app::formulas {

Names::Names()
{
    for (const char* name : {"x1", "y1", "x2", "y2", "xmin", "ymin", "xmax", "ymax"})
        slotOf(name);
}

int Names::slotOf(const std::string& name)
{
    const auto [at, isNew] = slots_.try_emplace(name, int(names_.size()));
    if (isNew)
        names_.push_back(name);
    return at->second;
}

int Names::find(std::string_view name) const
{
    const auto at = slots_.find(name);
    return at == slots_.end() ? -1 : at->second;
}

} // namespace app::formulas
