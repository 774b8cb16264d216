#include "app/report/accuracy_tables.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace hazer::app {
namespace {

using nlohmann::ordered_json;

ordered_json rowJson(const std::string& scene, const AccuracyRow& row) {
    return {{"scene", scene},
            {"integrator", row.integrator},
            {"setting", row.setting},
            {"samples", row.samples},
            {"ms_median", row.msMedian},
            {"rms_rel", row.error.rmsRel},
            {"p99_rel", row.error.p99Rel},
            {"max_rel", row.error.maxRel},
            {"unlit_max_rel", row.error.unlitMaxRel},
            {"frame_ms_median", row.frameMsMedian},
            {"frames", row.frames},
            {"lit_pixels", row.error.litPixels}};
}

ordered_json oracleJson(const std::string& scene, const char* light, const OracleCheck& check) {
    return {{"scene", scene},          {"light", light},
            {"pixels", check.pixels},  {"outlines", check.outlines},
            {"rms_rel", check.rmsRel}, {"max_rel", check.maxRel}};
}

ordered_json equalErrorJson(const std::string& scene, const EqualError& equal) {
    return {{"scene", scene},
            {"rms_rel", equal.angle->error.rmsRel},
            {"angle_ms", equal.angle->msMedian},
            {"uniform_ms", equal.uniform.ms},
            {"uniform_reaches_it", equal.uniform.isReached},
            {"uniform_rms_rel", equal.uniform.rmsRel},
            {"times_faster", equal.timesFaster}};
}

/// Fields with a comma or a quote are quoted (RFC 4180).
std::string field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted.append(c == '"' ? 2 : 1, c);
    return quoted + '"';
}

}  // namespace

ordered_json accuracyJson(const AccuracyReport& report) {
    ordered_json json{{"device", report.device},
                      {"size", {report.width, report.height}},
                      {"rows", ordered_json::array()},
                      {"oracle", ordered_json::array()},
                      {"equal_error", ordered_json::array()},
                      {"notes", ordered_json::array()}};
    for (const AccuracyScene& scene : report.scenes) {
        for (const AccuracyRow& row : scene.rows) json["rows"].push_back(rowJson(scene.name, row));
        if (scene.oracle) json["oracle"].push_back(oracleJson(scene.name, "air", *scene.oracle));
        if (scene.wholeOracle) {
            json["oracle"].push_back(oracleJson(scene.name, "air and surfaces", *scene.wholeOracle));
        }
        if (const auto equal = equalError(scene)) {
            json["equal_error"].push_back(equalErrorJson(scene.name, *equal));
        }
        for (const std::string& note : scene.notes) {
            json["notes"].push_back({{"scene", scene.name}, {"note", note}});
        }
    }
    return json;
}

std::string accuracyCsv(const AccuracyReport& report) {
    std::string text =
        "scene,integrator,setting,samples,ms_median,rms_rel,p99_rel,max_rel,unlit_max_rel,frame_ms_median,"
        "frames,lit_pixels\n";
    for (const AccuracyScene& scene : report.scenes) {
        for (const AccuracyRow& row : scene.rows) {
            text += fmt::format("{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{}\n",
                                field(scene.name), field(row.integrator), field(row.setting), row.samples,
                                row.msMedian, row.error.rmsRel, row.error.p99Rel, row.error.maxRel,
                                row.error.unlitMaxRel, row.frameMsMedian, row.frames, row.error.litPixels);
        }
    }
    return text;
}

}  // namespace hazer::app
