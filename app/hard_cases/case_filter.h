// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/hard_case.h"

namespace app {

/// Which hard cases are shown.
struct CaseFilter {
    QString words{};               ///< each word must occur in title, origin or reason; in any case
    QString variant{};             ///< key of a variant that fails at the case; empty: any
    std::optional<Ruling> fault{}; ///< the kind of failure, of any variant (or of that one)

    bool lets(const HardCase& hard) const;
    friend bool operator==(const CaseFilter&, const CaseFilter&) = default;
};

/// The cases that pass the filter, in the order of the gallery.
std::vector<const HardCase*> casesFor(const CaseFilter& filter);

/// A filter that can be chosen: all cases, the cases at which one published form or known misprint
/// fails, or the cases with one kind of fault. Its name has the number of cases: "CS as published
/// fails (17)".
struct CaseChoice {
    QString name;
    CaseFilter filter;
};
std::vector<CaseChoice> caseChoices();

} // namespace app
