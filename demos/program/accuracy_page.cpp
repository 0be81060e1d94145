#include "program/accuracy_page.h"

#include <cstdint>

#include "program/accuracy_table.h"
#include "program/rounded.h"

namespace hooke::program {
namespace {

constexpr const char* style =
    "body{font:16px/1.5 sans-serif;max-width:70rem;margin:2rem auto;padding:0 1rem;color:#1a1a1a}"
    "table{border-collapse:collapse;font-size:.85rem}"
    "td,th{padding:.15rem .6rem;border-bottom:1px solid #ddd;text-align:right}"
    "td:nth-child(-n+2),th:nth-child(-n+2),.facts td{text-align:left}"
    "figure{margin:1.5rem 0}img{max-width:100%}figcaption{font-size:.9rem;color:#444}"
    ".answer{font-size:1.2rem;padding:.8rem 1rem;border-left:.3rem solid #1b6ca8;background:#f2f6fa}"
    "code{background:#f4f4f4;padding:.1rem .3rem}";

std::string element(const std::string& name, const std::string& inside) {
  return "<" + name + ">" + inside + "</" + name + ">";
}

std::string fact(const std::string& name, const std::string& value) {
  return element("tr", element("td", html_text(name)) + element("td", value)) + "\n";
}

std::string facts(const AccuracyReport& report) {
  const AccuracyStudy& study = report.study;
  std::string rows = fact("scene", html_text(report.study.scene) + ": " + std::to_string(study.particles) +
                                       " particles, " + std::to_string(study.springs) + " springs, size " +
                                       rounded(study.scene_size) + " m") +
                     fact("command", element("code", html_text(report.command))) +
                     fact("machine", html_text(report.processor) + ", " + std::to_string(study.threads) +
                                         (study.threads == 1 ? " thread" : " threads")) +
                     fact("compiler", html_text(report.compiler)) +
                     fact("precision, accumulation", "double, " + html_text(report.accumulation)) +
                     fact("asked for", "tolerance " + rounded(study.tolerance) + ", horizon " +
                                           rounded(study.horizon) + " s, budget " + rounded(study.budget) +
                                           " s; took " + rounded(study.seconds) + " s");
  for (std::size_t i = 0; i < study.reference.choices.size(); ++i) {
    rows += fact("reference " + std::to_string(i + 1),
                 html_text(to_string(study.reference.choices[i])) + ": " +
                     std::to_string(study.reference.force_evaluations[i]) + " force evaluations, " +
                     rounded(study.reference.seconds[i]) + " s");
  }
  return "<table class=\"facts\">\n" + rows + "</table>\n";
}

std::string table(const std::vector<TableRow>& rows) {
  std::string text;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::string cells;
    for (const std::string& cell : rows[r]) cells += element(r == 0 ? "th" : "td", html_text(cell));
    text += element("tr", cells) + "\n";
  }
  return "<table>\n" + text + "</table>\n";
}

std::string figure(const PagePicture& picture) {
  if (picture.svg.empty()) {
    return "<p>" + html_text(picture.caption) +
           " <strong>Not drawn: there is no gnuplot, or it failed.</strong> Its script lies beside this "
           "page.</p>\n";
  }
  return "<figure><img alt=\"" + html_text(picture.caption) + "\" src=\"data:image/svg+xml;base64," +
         base64(picture.svg) + "\"><figcaption>" + html_text(picture.caption) + "</figcaption></figure>\n";
}

std::string run_tables(const AccuracyStudy& study) {
  std::string text;
  for (std::size_t h = study.horizons.size(); h-- > 0;) {
    text +=
        element("h2", "Runs over " + rounded(study.horizons[h]) + " s") +
        "<p>Errors of positions are shares of the scene's size, those of energy and momentum shares of the "
        "most that the reference has (" +
        rounded(study.energy_scale) + " J, " + rounded(study.momentum_scale) + " kg m/s).</p>\n" +
        table(run_rows(study, study.horizons[h]));
  }
  return text;
}

std::string long_run_table(const AccuracyStudy& study) {
  if (study.long_runs.empty()) return "";
  return element("h2", "From " + rounded(study.reference.trusted_until) + " s to " + rounded(study.horizon) +
                           " s: energies") +
         "<p>No positions can be compared here. How far the references and the methods differ in a column "
         "says how "
         "far it can be trusted.</p>\n" +
         table(long_run_rows(study));
}

std::string agreement_table(const Reference& reference) {
  std::vector<TableRow> rows{{"time [s]", "RMS difference of the references / scene size"}};
  for (std::size_t i = 0; i < reference.times.size(); ++i)
    rows.push_back({rounded(reference.times[i]), rounded(reference.agreement[i])});
  return element("h2", "How far the references agree") + table(rows);
}

std::string omitted_list(const AccuracyStudy& study) {
  if (study.omitted.empty()) return "";
  std::string items;
  for (const OmittedRun& run : study.omitted)
    items += element("li", html_text(to_string(run.choice) + ": " + run.reason)) + "\n";
  return element("h2", "Omitted") + element("ul", items);
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t b = 0; b < 3; ++b)
      group = group << 8 | (i + b < bytes.size() ? static_cast<unsigned char>(bytes[i + b]) : 0u);
    for (std::size_t d = 0; d < 4; ++d)
      text += i + d <= bytes.size() ? digits[group >> (18 - 6 * d) & 63u] : '=';
  }
  return text;
}

std::string accuracy_page(const AccuracyReport& report, const std::vector<PagePicture>& pictures) {
  const AccuracyStudy& study = report.study;
  const std::string title = "What accuracy costs: " + html_text(report.study.scene);
  std::string body = element("h1", title) + "<p class=\"answer\">" + html_text(study.answer.text) + "</p>\n" +
                     element("p", html_text(study.reference.verdict)) + "\n";
  if (study.stopped) body += "<p><strong>Stopped early: what is shown is of the runs so far.</strong></p>\n";
  body += facts(report);
  for (const PagePicture& picture : pictures) body += figure(picture);
  body += run_tables(study) + long_run_table(study) + omitted_list(study) + agreement_table(study.reference);
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title +
         "</title><style>" + style + "</style></head><body>\n" + body + "</body></html>\n";
}

}  // namespace hooke::program
