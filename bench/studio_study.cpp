#include "bench/studio_study.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <memory>

#include "core/error.h"
#include "core/quantile.h"
#include "io/json.h"
#include "tests/app/program.h"
#include "tests/studio/client.h"

namespace hada {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

Json asked(const RunningStudio& studio, const std::string& what, const Json& body) {
  const std::string answer = post(studio, "api/" + what, body.dump());
  if (status_of(answer) != 200) throw Error(what + ": " + body_of(answer));
  return Json::parse(body_of(answer));
}

// A ray that looks straight down on a place.
Json down_to(double x, double y) {
  return {{"eye", {x, y, 3.0}}, {"way", {0.0, 0.0, -1.0}}};
}

bool held(const RunningStudio& studio, double x, double y) {
  return status_of(post(studio, "api/fold/hold", down_to(x, y).dump())) == 200;
}

// What those would send who should not ask, and those who ask badly.
std::vector<std::string> hostile_requests(const RunningStudio& studio) {
  const std::string base = studio.base(), host = "Host: " + studio.host(),
                    origin = "Origin: http://" + studio.host();
  const std::string fair_get = get_text(studio, "api/fold/state");
  const std::string fair_post = post_text(studio, "api/fold/new", "{}");
  const auto exchanged = [](std::string text, const std::string& part, const std::string& by) {
    return text.replace(text.find(part), part.size(), by);
  };
  std::vector<std::string> requests;
  for (const std::string& path :
       {std::string("/"), "/" + std::string(32, '0') + "/", base.substr(0, 20) + "/",
        std::string("//"), "/%2e%2e" + base, base + "../" + base.substr(1) + "x/"}) {
    requests.push_back(exchanged(fair_get, base, path));
  }
  for (const char* other : {"evil.example", "localhost.evil.example", "127.0.0.1", "[::1]", ""}) {
    requests.push_back(exchanged(fair_get, host, std::string("Host: ") + other));
  }
  for (const char* other : {"Origin: http://evil.example", "Origin: null", "X-Nothing: 1",
                            "Origin: http://127.0.0.1:1"}) {
    requests.push_back(exchanged(fair_post, origin, other));
  }
  requests.push_back(exchanged(fair_post, origin, origin + "\r\nSec-Fetch-Site: cross-site"));
  for (const char* type :
       {"text/plain", "application/x-www-form-urlencoded", "multipart/form-data"}) {
    requests.push_back(exchanged(fair_post, "application/json", type));
  }
  for (const char* name :
       {"../secret.json", "..", "/etc/passwd", "link.json", "out/secret.json", ".hidden.json",
        "out", "sub/../../secret.json", "boat.json\\u0000.png"}) {
    const std::string body = std::string(R"({"name": ")") + name + "\"}";
    for (const char* verb : {"fold/open", "material/open", "surface/maps", "spectrum/measure"}) {
      requests.push_back(post_text(studio, std::string("api/") + verb, body));
    }
    requests.push_back(get_text(studio, std::string("api/capture/picture?name=") + name));
    requests.push_back(
        post_text(studio, "api/job/calibrate", std::string(R"({"capture": ")") + name + "\"}"));
    requests.push_back(post_text(studio, "api/job/reconstruct",
                                 std::string(R"({"capture": "", "out": ")") + name + "\"}"));
  }
  for (const std::string& body :
       {std::string("{"), std::string("[]"), std::string("nonsense"), std::string(2000, '['),
        std::string(R"({"at": 1e999})"), std::string(R"({"at": "1"})"),
        std::string(R"({"at": 1, "at": 2})")}) {
    requests.push_back(post_text(studio, "api/fold/go", body));
  }
  const std::string length = "Content-Length: 2";
  for (const char* other : {"Content-Length: 999999999999", "Content-Length: -2",
                            "Transfer-Encoding: chunked", "Content-Length: two"}) {
    requests.push_back(exchanged(fair_post, length, other));
  }
  requests.push_back(exchanged(fair_get, host, host + "\r\nX-Long: " + std::string(40000, 'x')));
  requests.push_back(exchanged(fair_get, host, host + "\r\nRange: bytes=0-1"));
  requests.push_back(exchanged(fair_get, "GET", "DELETE"));
  return requests;
}

}  // namespace

DragFigures study_drag(const std::filesystem::path& folds) {
  const RunningStudio studio(folds);
  asked(studio, "fold/open", {{"name", "crane.json"}});
  Json state = asked(studio, "fold/go", {{"at", 20}});
  for (const double x : {0.35, 0.42, 0.46, 0.55}) {
    state = asked(studio, "fold/stroke",
                  {{"does", "score"},
                   {"eye", {x, 0.5, 9.0}},
                   {"from", {x, -0.2, 0.0}},
                   {"to", {x, 0.9, 0.0}}});
  }
  DragFigures figures;
  figures.faces = int(state["faces"].size());
  bool holds = false;
  for (const double y : {0.6, 0.55, 0.65}) holds = holds || held(studio, 0.58, y);
  if (!holds) throw Error("no face of the crane can be held; look at its log");
  Connection hand(studio.port());
  const auto timed = [&](const std::string& verb, const Json& body, std::vector<double>& times) {
    const std::string text = post_text(studio, "api/fold/" + verb, body.dump());
    const auto start = Clock::now();
    hand.say(text);
    const std::string answer = hand.hear();
    times.push_back(ms_since(start));
    if (status_of(answer) != 200) throw Error(verb + ": " + body_of(answer));
    return Json::parse(body_of(answer));
  };
  std::vector<double> aims, drags;
  for (int i = 0; i < 40; ++i) {
    const Json ray = {{"eye", {3.0, -3.0, 2.0}}, {"way", {-2.5 + 0.01 * i, 3.5, -1.9}}};
    const Json shape = timed("drag", ray, drags);
    figures.strain_dragging =
        std::max(figures.strain_dragging, shape["strain"]["most"].get<double>());
    Json aim = down_to(0.3 + 0.01 * i, 0.4);
    aim.update({{"edge_parts", 4}, {"corner_parts", 4}, {"reach", 0.02}});
    timed("aim", aim, aims);
  }
  figures.drag_ms = median(drags);
  figures.aim_ms = median(aims);
  figures.strain_released =
      asked(studio, "fold/drop", Json::object())["strain"]["most"].get<double>();
  return figures;
}

PreviewFigures study_previews() {
  const TemporaryFolder scratch;
  const RunningStudio studio(scratch.path());
  const auto seconds = [&](const Json& request) {
    const std::string text = post_text(studio, "api/material/preview", request.dump());
    const auto start = Clock::now();
    if (status_of(answer_to(studio, text)) != 200) throw Error("a preview was refused");
    return ms_since(start);
  };
  PreviewFigures figures;
  const Json tables = Json::parse(body_of(get(studio, "api/material/tables")));
  for (const Json& table : tables["materials"]) {
    Json request = {
        {"file",
         {{"hada", "material/1"}, {"material", table["name"]}, {"parameters", table["defaults"]}}},
        {"size_px", 512},
        {"pitch", 0.1},
        {"seed", 1}};
    seconds(request);  // the first one: steel is forged for it
    std::vector<double> times;
    for (int i = 0; i < 9; ++i) {
      auto& value = request["file"]["parameters"][table["fields"].back()["name"]];
      value = (value.is_null() ? 0.0 : value.get<double>()) + 1e-4;  // what is left out is 0
      times.push_back(seconds(request));
    }
    figures.material_ms.emplace_back(table["name"], median(times));
    if (table["name"] != "forged") continue;
    std::vector<double> folds;
    for (const char* sequence : {"CRC", "RCC", "CRCC"}) {
      request["file"]["parameters"]["sequence"] = sequence;
      folds.push_back(seconds(request));
    }
    figures.other_folds_ms = median(folds);
  }
  return figures;
}

HostileFigures study_hostile() {
  namespace fs = std::filesystem;
  const TemporaryFolder scratch;
  const std::string log = R"({"hada": "fold_log/1", "steps": []})";
  put(scratch / "folder/boat.json", log);
  put(scratch / "folder/.hidden.json", log);
  put(scratch / "secret.json", log);
  fs::create_symlink(scratch / "secret.json", scratch / "folder/link.json");
  fs::create_directory_symlink(scratch.path(), scratch / "folder/out");
  const RunningStudio studio(scratch / "folder");
  HostileFigures figures;
  for (const std::string& request : hostile_requests(studio)) {
    ++figures.tried;
    figures.succeeded += status_of(answer_to(studio, request)) == 200;
  }
  figures.alive = status_of(get(studio, "api/fold/state")) == 200;
  return figures;
}

double seconds_to_page(const std::filesystem::path& program) {
  const TemporaryFolder scratch;
  const std::string command = "'" + program.string() + "' studio --no-browser --json '" +
                              scratch.path().string() + "' & echo $!; wait";
  const auto start = Clock::now();
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  const auto line = [&] {
    std::string text;
    for (int c = 0; pipe && (c = std::fgetc(pipe.get())) != EOF && c != '\n';) text += char(c);
    return text;
  };
  const int process = std::stoi(line());
  const std::string address = Json::parse(line())["address"];
  const std::size_t colon = address.find(':', 7), slash = address.find('/', colon);
  Connection page(std::stoi(address.substr(colon + 1, slash - colon - 1)));
  page.say("GET " + address.substr(slash) + " HTTP/1.1\r\nHost: " + address.substr(7, slash - 7) +
           "\r\n\r\n");
  const int status = status_of(page.hear());
  const double seconds = ms_since(start) / 1000.0;
  kill(process, SIGTERM);
  if (status != 200) throw Error("the page of the studio is not answered");
  return seconds;
}

}  // namespace hada
