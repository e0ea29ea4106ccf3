#include "bench/sweep/description.h"

#include <stdexcept>

#include "bench/sweep/json_fields.h"

namespace cnrg::bench {

std::string to_json(const std::vector<SystemInfo>& systems) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const SystemInfo& s : systems) {
    nlohmann::ordered_json info{{"name", s.name},       {"title", s.title},       {"guarantee", s.guarantee},
                                {"version", s.version}, {"rounding", s.rounding}, {"regularized", s.regularized},
                                {"absent", s.absent}};
    if (!s.varies.of.empty()) info["varies"] = {{"of", s.varies.of}, {"rule", s.varies.rule}, {"on", s.varies.on}};
    out.push_back(std::move(info));
  }
  return json_text(out, 1);
}

std::string to_json(const std::vector<FamilyInfo>& families) {
  nlohmann::ordered_json out = nlohmann::ordered_json::array();
  for (const FamilyInfo& f : families) {
    out.push_back({{"name", f.name},
                   {"title", f.title},
                   {"size_means", f.size_means},
                   {"distance_means", f.distance_means},
                   {"growth", f.growth}});
  }
  return json_text(out, 1);
}

std::string to_json(const MachineInfo& m) {
  const nlohmann::ordered_json out{
      {"cpu", m.cpu},       {"cores", m.cores},       {"memory_bytes", m.memory_bytes},
      {"system", m.system}, {"compiler", m.compiler}, {"commit", m.commit},
      {"date", m.date},     {"command", m.command},   {"left_out", m.left_out}};
  return json_text(out, 1);
}

namespace {

nlohmann::json list_of_json(const std::string& text) {
  nlohmann::json list = parse_json(text);
  if (!list.is_array()) throw std::runtime_error("no JSON list");
  return list;
}

}  // namespace

std::vector<FamilyInfo> families_of_json(const std::string& text) {
  std::vector<FamilyInfo> families;
  for (const nlohmann::json& object : list_of_json(text)) {
    const JsonFields in(object, "a family");
    families.push_back(
        {in.text("name"), in.text("title"), in.text("size_means"), in.text("distance_means"), in.text("growth")});
  }
  return families;
}

std::vector<SystemInfo> systems_of_json(const std::string& text) {
  std::vector<SystemInfo> systems;
  for (const nlohmann::json& object : list_of_json(text)) {
    const JsonFields in(object, "a system");
    systems.push_back({in.text("name"), in.text("title"), in.text("guarantee"), in.text("version"),
                       in.not_negative("rounding"), in.flag("regularized"), in.text("absent")});
    if (!object.contains("varies")) continue;
    const JsonFields varies(object["varies"], "a system's varies");
    systems.back().varies = {varies.text("of"), varies.text("rule"), varies.flag("on")};
  }
  return systems;
}

MachineInfo machine_of_json(const std::string& text) {
  const nlohmann::json object = parse_json(text);
  const JsonFields in(object, "the machine");
  MachineInfo m;
  m.cpu = in.text("cpu");
  m.cores = in.integer<unsigned>("cores");
  m.memory_bytes = in.integer<std::size_t>("memory_bytes");
  m.system = in.text("system");
  m.compiler = in.text("compiler");
  m.commit = in.text("commit");
  m.date = in.text("date");
  m.command = in.text("command");
  for (const nlohmann::json& one : in.list("left_out")) {
    if (!one.is_array() || one.size() != 2 || !one[0].is_string() || !one[1].is_string())
      in.fail("left_out", "a list of pairs of texts");
    m.left_out.emplace_back(one[0], one[1]);
  }
  return m;
}

}  // namespace cnrg::bench
