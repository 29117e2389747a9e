// SPDX-License-Identifier: GPL-3.0-or-later
// index.html of a batch.
#include <algorithm>
#include <filesystem>

#include "src/batch/batch_summary.hpp"
#include "src/io/escape_xml.hpp"
#include "src/io/number_text.hpp"
#include "src/report/report_page.hpp"

namespace abut {

namespace {

constexpr const char* batch_style = R"(
main { max-width: 1720px; }
.table { max-height: none; }
.table table { width: 100%; }
.filters { display: flex; flex-wrap: wrap; gap: 6px 14px; align-items: center; margin: 14px 0; }
.filters input[type=search] { font: inherit; padding: 4px 8px; width: 260px; border: 1px solid var(--rule); border-radius: 4px; }
.filters label { padding: 2px 10px; border: 1px solid var(--rule); border-radius: 12px; font-size: 13px; cursor: pointer; }
.filters .shown { color: var(--soft); font-size: 13px; }
th button { all: unset; cursor: pointer; font-weight: 600; }
th button:focus-visible { outline: 2px solid var(--accent); }
th[aria-sort=ascending] button::after { content: " \25B2"; font-size: 9px; }
th[aria-sort=descending] button::after { content: " \25BC"; font-size: 9px; }
tbody td { vertical-align: middle; }
td.picture { width: 112px; padding-right: 10px; }
td.picture img { display: block; background: #fff; }
.filters input { color: var(--ink); background: var(--panel); }
td.message { min-width: 220px; font-size: 12px; }
.table td a { display: inline-block; min-width: 6em; }
td.job { min-width: 100px; }
th, th.n { white-space: normal; }
.status { display: inline-block; white-space: nowrap; padding: 1px 9px; border-radius: 9px; font-size: 12px; background: var(--good-paper); border: 1px solid var(--good); }
.status.solved_but, .status.differs { background: var(--doubt-paper); border-color: var(--doubt); }
.status.failed, .status.refused, .status.broken { background: var(--bad-paper); border-color: var(--bad); font-weight: 600; }
)";

/// Sorting and filtering. Each cell that sorts otherwise than by its text has its key in data-k.
constexpr const char* script = R"(
const body = document.querySelector("tbody"), rows = [...body.rows], heads = [...document.querySelectorAll("th")];
const search = document.querySelector("input[type=search]");
const boxes = [...document.querySelectorAll(".filters input[type=checkbox]")];
function key(row, i) {
  const cell = row.cells[i];
  if (cell.dataset.k === undefined) return cell.textContent;
  return cell.dataset.k === "" ? NaN : +cell.dataset.k;
}
const order = (a, b) => typeof a === "string" ? a.localeCompare(b, undefined, {numeric: true}) : a - b;
function sort(i) {
  const up = heads[i].getAttribute("aria-sort") !== "ascending";
  heads.forEach(h => h.removeAttribute("aria-sort"));
  heads[i].setAttribute("aria-sort", up ? "ascending" : "descending");
  const keyed = rows.map((r, n) => [key(r, i), n, r]), last = k => Number.isNaN(k) || k === "";
  keyed.sort((a, b) => last(a[0]) - last(b[0]) || (last(a[0]) ? 0 : (up ? 1 : -1) * order(a[0], b[0])) || a[1] - b[1]);
  body.append(...keyed.map(k => k[2]));
}
function filter() {
  const words = search.value.toLowerCase().split(/\s+/), on = new Set(boxes.filter(b => b.checked).map(b => b.value));
  let n = 0;
  for (const r of rows) {
    const text = r.textContent.toLowerCase();
    r.hidden = !on.has(r.dataset.status) || !words.every(w => text.includes(w));
    n += !r.hidden;
  }
  document.querySelector(".shown").textContent = n + " of " + rows.length + " shown";
}
heads.forEach((h, i) => h.firstElementChild && (h.firstElementChild.onclick = () => sort(i)));
search.oninput = filter;
boxes.forEach(b => b.onchange = filter);
filter();
)";

/// Bytes of a path as they may stand in a link.
std::string url_path(const std::string& path) {
    std::string url;
    for (const char c : path) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           std::string("-_.~/").find(c) != std::string::npos;
        constexpr const char* digits = "0123456789ABCDEF";
        const auto byte = static_cast<unsigned char>(c);
        url += plain ? std::string(1, c) : std::string{'%', digits[byte >> 4], digits[byte & 15]};
    }
    return url;
}

bool holds(const JobRecord& job, const std::string& file) {
    return std::find(job.files.begin(), job.files.end(), file) != job.files.end();
}

std::string link_of(const JobRecord& job) {
    for (const char* file : {"report.html", "contacts.svg", "result.json", "contacts.json"})
        if (holds(job, file)) return url_path("jobs/" + job.name + "/" + file);
    return url_path("jobs/" + job.name + "/job.json");
}

std::string number_cell(const std::optional<double>& value, int digits) {
    if (!value) return "<td class=\"n\" data-k=\"\"></td>";
    return "<td class=\"n\" data-k=\"" + number_text(*value, 9) + "\">" + number_text(*value, digits) + "</td>";
}
std::string number_cell(const std::optional<int>& value) {
    return value ? number_cell(std::optional<double>(*value), 9) : number_cell(std::optional<double>(), 1);
}

std::string error_cell(const std::optional<double>& error) {
    if (!error) return "<td class=\"n\" data-k=\"\"></td>";
    return "<td class=\"n\" data-k=\"" + number_text(*error, 6) + "\">" + number_text(100 * *error, 2) + " %</td>";
}

std::string parameters_text(const JobRecord& job) {
    std::string text;
    for (const auto& [name, value] : job.parameters) text += (text.empty() ? "" : ", ") + name + " = " + number_text(value, 6);
    return text;
}

/// Messages begin with the file, which is long where it lies deep; its name and the job's tell which one it is.
std::string without_folder(const JobRecord& job) {
    const std::size_t folder = job.file.rfind('/') + 1;  // 0: none
    return job.message.starts_with(job.file) ? job.message.substr(folder) : job.message;
}

std::string words_of(const JobRecord& job) {
    std::string text = escape_xml(without_folder(job));
    const auto add = [&](const std::string& line) { text += (text.empty() ? "" : "<br/>") + escape_xml(line); };
    if (job.expectation)
        for (const std::string& line : job.expectation->differences) add(line);
    for (const std::string& line : job.warnings) add("warning: " + line);
    return text;
}

/// A column of numbers; those that no job has a number for are left out of the page, as pressures of contact detection.
struct Column {
    const char* title;
    std::string (*cell)(const JobRecord&);
    bool (*is_known)(const JobRecord&);
};

constexpr Column batch_columns[] = {
    {"parts", [](const JobRecord& j) { return number_cell(j.parts); }, [](const JobRecord& j) { return j.parts.has_value(); }},
    {"pairs", [](const JobRecord& j) { return number_cell(j.pairs); }, [](const JobRecord& j) { return j.pairs.has_value(); }},
    {"closed", [](const JobRecord& j) { return number_cell(j.closed); },
     [](const JobRecord& j) { return j.closed.has_value(); }},
    {"peak pressure", [](const JobRecord& j) { return number_cell(j.max_pressure, 4); },
     [](const JobRecord& j) { return j.max_pressure.has_value(); }},
    {"worst estimated error", [](const JobRecord& j) { return error_cell(j.error_estimate); },
     [](const JobRecord& j) { return j.error_estimate.has_value(); }},
    {"warnings", [](const JobRecord& j) { return number_cell(static_cast<int>(j.warnings.size())); },
     [](const JobRecord&) { return true; }},
    {"seconds", [](const JobRecord& j) { return number_cell(j.seconds, 2); }, [](const JobRecord&) { return true; }}};

std::vector<const Column*> known_columns(const BatchSummary& summary) {
    std::vector<const Column*> known;
    for (const Column& column : batch_columns)
        if (std::any_of(summary.jobs.begin(), summary.jobs.end(), column.is_known)) known.push_back(&column);
    return known;
}

std::string row(const JobRecord& job, bool parameters, const std::vector<const Column*>& numbers) {
    const std::string word = status_word(job.status), link = link_of(job);
    std::string html = "<tr data-status=\"" + word + "\"><td class=\"picture\">";
    if (holds(job, "thumbnail.svg"))
        html += "<a href=\"" + link + "\"><img loading=\"lazy\" alt=\"\" src=\"" +
                url_path("jobs/" + job.name + "/thumbnail.svg") + "\"/></a>";
    html += "</td><td class=\"job\"><a href=\"" + link + "\">" + escape_xml(job.name) + "</a></td><td data-k=\"" +
            std::to_string(-static_cast<int>(job.status)) + "\"><span class=\"status " + word + "\">" + word + "</span></td>";
    if (parameters) html += "<td>" + escape_xml(parameters_text(job)) + "</td>";
    for (const Column* column : numbers) html += column->cell(job);
    return html + "<td class=\"message\">" + words_of(job) + "</td></tr>\n";
}

std::string head_cell(const std::string& title, bool number) {
    return std::string("<th") + (number ? " class=\"n\"" : "") + "><button type=\"button\">" + escape_xml(title) +
           "</button></th>";
}

std::string head(bool parameters, const std::vector<const Column*>& numbers) {
    std::string html = "<thead><tr><th></th>" + head_cell("job", false) + head_cell("status", false);
    if (parameters) html += head_cell("parameters", false);
    for (const Column* column : numbers) html += head_cell(column->title, true);
    return html + head_cell("message", false) + "</tr></thead>\n";
}

std::string filters(const BatchSummary& summary) {
    std::string html =
        "<div class=\"filters\"><input type=\"search\" placeholder=\"words in any column\" aria-label=\"filter\"/>";
    for (std::size_t i = summary.count.size(); i-- > 0;) {
        if (summary.count[i] == 0) continue;
        const std::string word = status_word(static_cast<JobRecord::Status>(i));
        html += "<label><input type=\"checkbox\" checked value=\"" + word + "\"/> " + word + " " +
                std::to_string(summary.count[i]) + "</label>";
    }
    return html + "<span class=\"shown\"></span></div>\n";
}

std::string verdict(const BatchSummary& summary) {
    const bool doubtful =
        !summary.missing.empty() || summary.count[static_cast<std::size_t>(JobRecord::Status::solved_but)] > 0;
    const char* mood = !all_well(summary) ? " failed" : doubtful ? " doubtful" : "";
    std::string text = std::to_string(summary.jobs.size()) + " jobs: " + count_text(summary);
    if (!summary.missing.empty()) text += "; " + std::to_string(summary.missing.size()) + " are not done";
    std::string html = std::string("<p class=\"verdict") + mood + "\">" + escape_xml(text) + "</p>\n";
    if (summary.expectation) html += "<p>" + escape_xml(expectation_text(*summary.expectation)) + "</p>\n";
    return html;
}

/// The worst first; jobs of one status in the batch's order.
std::vector<const JobRecord*> failures_first(const BatchSummary& summary) {
    std::vector<const JobRecord*> jobs;
    for (const JobRecord& job : summary.jobs) jobs.push_back(&job);
    std::stable_sort(jobs.begin(), jobs.end(), [](const JobRecord* a, const JobRecord* b) { return a->status > b->status; });
    return jobs;
}

}  // namespace

std::string index_html(const BatchSummary& summary, const std::string& title) {
    const std::string name = escape_xml("Batch" + (title.empty() ? "" : " " + title));
    const bool parameters =
        std::any_of(summary.jobs.begin(), summary.jobs.end(), [](const JobRecord& job) { return !job.parameters.empty(); });
    const std::vector<const Column*> numbers = known_columns(summary);
    std::string body =
        verdict(summary) + filters(summary) + "<div class=\"table\"><table>\n" + head(parameters, numbers) + "<tbody>\n";
    for (const JobRecord* job : failures_first(summary)) body += row(*job, parameters, numbers);
    return report::html_page(name, body + "</tbody></table></div>\n",
                             "Made by abut batch. Pressures are in each scene's own units; errors are estimates.",
                             "<script>" + std::string(script) + "</script>\n", batch_style);
}

}  // namespace abut
