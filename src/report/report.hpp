// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/results/case_result.hpp"
#include "src/results/model_facts.hpp"

namespace abut {

/// What the script of a report shows; empty where there is nothing to show. model: what was analysed; the report does without
/// where it is not known.
std::string report_data(const Result& result, const ModelFacts& model = {});
/// The text of report.html: one file, no network. data: its report_data; null: it is made, beside the other sections on
/// `threads` threads.
std::string report_html(const Result& result, const ModelFacts& model = {}, int threads = 1, const std::string* data = nullptr);

/// The text of the page over the load cases of a scene: what each came to, with a link to its own page
/// (CASE_FOLDER/report.html), and what is largest in any; with a script all of them in one instrument, by tabs and a slider,
/// and curves over them. models, data: what was analysed and report_data of each.
std::string cases_html(const std::vector<CaseResult>& cases, const std::vector<ModelFacts>& models,
                       const std::vector<std::string>& data);

}  // namespace abut
