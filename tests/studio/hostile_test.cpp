#include <chrono>
#include <filesystem>
#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/program.h"
#include "tests/studio/client.h"

/// Requests of those who should not ask, and of those who ask badly. None may succeed, and the
/// server must answer its own page afterwards.
namespace hada {
namespace {

using testing::HasSubstr;
using testing::Not;

// A folder with a log inside, and a secret beside it that a link leads to.
class Hostile : public testing::Test {
 protected:
  Hostile() {
    put(scratch_ / "folder/boat.json", R"({"hada": "fold_log/1", "steps": []})");
    put(scratch_ / "secret.json", R"({"hada": "fold_log/1", "title": "secret", "steps": []})");
    std::filesystem::create_symlink(scratch_ / "secret.json", scratch_ / "folder/link.json");
    std::filesystem::create_directory_symlink(scratch_.path(), scratch_ / "folder/out");
    put(scratch_ / "folder/.hidden.json", R"({"hada": "fold_log/1", "steps": []})");
    studio_ = std::make_unique<RunningStudio>(scratch_ / "folder");
  }
  ~Hostile() override { EXPECT_EQ(status_of(get(*studio_, "api/fold/state")), 200); }

  // The request as our page would send it, with one part of it exchanged.
  std::string exchanged(std::string text, const std::string& part, const std::string& by) const {
    const std::size_t place = text.find(part);
    EXPECT_NE(place, std::string::npos) << part;
    return text.replace(place, part.size(), by);
  }
  int status(const std::string& text) const { return status_of(answer_to(*studio_, text)); }
  std::string fair_get() const { return get_text(*studio_, "api/fold/state"); }
  std::string fair_post() const { return post_text(*studio_, "api/fold/new", "{}"); }

  const TemporaryFolder scratch_;
  std::unique_ptr<RunningStudio> studio_;
};

TEST_F(Hostile, OurOwnPageIsAnswered) {
  EXPECT_EQ(status(fair_get()), 200);
  EXPECT_EQ(status(fair_post()), 200);
  EXPECT_EQ(status_of(post(*studio_, "api/fold/open", R"({"name": "boat.json"})")), 200);
}

TEST_F(Hostile, NothingIsCompressedOnTheWayToTheSameMachine) {
  const std::string answer = answer_to(
      *studio_, exchanged(fair_get(), "\r\n\r\n", "\r\nAccept-Encoding: br, gzip\r\n\r\n"));
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_THAT(answer, Not(HasSubstr("Content-Encoding")));
}

TEST_F(Hostile, WithoutTheTokenNothingIsSaid) {
  const std::string base = studio_->base();
  EXPECT_EQ(status(exchanged(fair_get(), base, "/")), 404);
  EXPECT_EQ(status(exchanged(fair_get(), base, "/" + std::string(32, '0') + "/")), 404);
  EXPECT_EQ(status(exchanged(fair_get(), base, base.substr(0, 20) + "/")), 404);
  EXPECT_EQ(status(exchanged(fair_get(), base, "//")), 404);
  EXPECT_EQ(status(exchanged(fair_get(), base, "/%2e%2e" + base)), 404);
}

TEST_F(Hostile, AnotherNameOfThisMachineIsRefused) {
  for (const std::string& name :
       {"evil.example:" + std::to_string(studio_->port()), std::string("127.0.0.1"),
        std::string("127.0.0.1:1"), "127.0.0.1.evil.example:" + std::to_string(studio_->port())}) {
    const std::string host = "Host: " + studio_->host();
    EXPECT_EQ(status(exchanged(fair_get(), host, "Host: " + name)), 403) << name;
  }
  EXPECT_EQ(status(exchanged(fair_get(), "\r\n\r\n", "\r\nHost: evil.example\r\n\r\n")), 403);
}

TEST_F(Hostile, OtherPagesMayNotAsk) {
  const std::string origin = "Origin: http://" + studio_->host();
  for (const char* other : {"Origin: http://evil.example", "Origin: null",
                            "Origin: https://127.0.0.1:1", "X-Nothing: here"}) {
    EXPECT_EQ(status(exchanged(fair_post(), origin, other)), 403) << other;
  }
  EXPECT_EQ(status(exchanged(fair_get(), "\r\n\r\n", "\r\nOrigin: http://evil.example\r\n\r\n")),
            403);
  EXPECT_EQ(status(exchanged(fair_get(), "\r\n\r\n", "\r\nSec-Fetch-Site: cross-site\r\n\r\n")),
            403);
  // What a form of another page can send without asking first.
  EXPECT_EQ(status(exchanged(fair_post(), "application/json", "text/plain")), 415);
}

TEST_F(Hostile, PathsDoNotLeaveTheFolder) {
  for (const char* name :
       {"../secret.json", "..", "/etc/passwd", "link.json", "out/secret.json", ".hidden.json",
        "boat.json/../../secret.json", "./../secret.json", "out/folder/../secret.json",
        "boat.json\\u0000.png", "missing.json", "..\\\\secret.json", ""}) {
    const std::string said =
        post(*studio_, "api/fold/open", std::string(R"({"name": ")") + name + "\"}");
    EXPECT_EQ(status_of(said), 422) << name;
    EXPECT_THAT(said, Not(HasSubstr("secret\""))) << name;
    EXPECT_THAT(said, Not(HasSubstr(scratch_.path().string()))) << name;
  }
  for (const char* page : {"../../secret.json", "%2e%2e/%2e%2e/secret.json", "..%2fsecret.json",
                           "boat.json", "api/../boat.json"}) {
    const int code = status_of(get(*studio_, page));
    EXPECT_TRUE(code == 404 || code == 422 || code == 400) << page << " " << code;
  }
}

TEST_F(Hostile, HugeBodiesAreNotTakenIn) {
  const std::string length = "Content-Length: 2";
  EXPECT_EQ(status(exchanged(fair_post(), length, "Content-Length: 99999999999")), 413);
  EXPECT_EQ(status(exchanged(fair_post(), length, "Content-Length: -1")), 400);
  EXPECT_EQ(status(exchanged(fair_post(), length, "Content-Length: 2\r\nContent-Length: 9")), 400);
  EXPECT_EQ(status(exchanged(fair_post(), length, "Transfer-Encoding: chunked")), 411);
  EXPECT_EQ(status(exchanged(fair_post(), length, "Content-Encoding: gzip\r\n" + length)), 411);
  EXPECT_EQ(status(exchanged(fair_get(), "\r\n\r\n", "\r\nRange: bytes=0-,0-,0-,0-\r\n\r\n")), 416);
  // A head without end, and a body that is larger than it says: what follows is no request.
  Connection endless(studio_->port());
  endless.say("GET / HTTP/1.1\r\n");
  bool taken = true;
  for (int i = 0; i < 20000 && taken; ++i)
    taken = endless.say("X-More: " + std::string(1000, 'x') + "\r\n");
  EXPECT_FALSE(taken);
}

TEST_F(Hostile, OtherMethodsAndNonsenseAreRefused) {
  for (const char* method : {"PUT", "DELETE", "OPTIONS", "PATCH", "HEAD"}) {
    EXPECT_NE(status(exchanged(fair_get(), "GET", method)), 200) << method;
  }
  for (const char* text :
       {"\r\n\r\n", "GET\r\n\r\n", "GET / HTTP/9.9\r\n\r\n", "\x16\x03\x01\x02"}) {
    EXPECT_NE(status(text), 200);
  }
}

TEST_F(Hostile, BadJsonIsAnsweredInASentence) {
  const std::string deep(100000, '[');
  for (const std::string& body : std::vector<std::string>{
           "", "{", "[]", "null", "{\"at\": \"one\"}", "{\"at\": 1e400}", "{\"at\": 1, \"at\": 2}",
           "{\"at\": 0.5}", "{\"at\": 1, \"more\": 2}", deep, "\xff\xfe", "{\"a\":" + deep}) {
    const std::string said = post(*studio_, "api/fold/go", body);
    EXPECT_TRUE(status_of(said) == 422 || status_of(said) == 400) << body.substr(0, 40) << said;
  }
  for (const char* step :
       {R"({"do": "through", "from": [1e308, 1], "to": [-1e308, 0]})",
        R"({"do": "swing", "from": [0.5, 0.5], "to": [9, 9], "degrees": 1e9})",
        R"({"do": "swing", "from": [7, 7], "to": [9, 9], "degrees": 10})",
        R"({"do": "score", "eye": [0, 0, 0], "from": [0, 0, 0], "to": [0, 0, 0]})",
        R"({"do": "squash", "share": 1e300})", R"({"do": "turn", "from": [0, 0], "to": [1, 1]})"}) {
    EXPECT_EQ(status_of(post(*studio_, "api/fold/do", step)), 422) << step;
  }
  EXPECT_THAT(get(*studio_, "api/fold/state"), HasSubstr("\"at\":0"));
}

TEST_F(Hostile, SlowClientsDoNotKeepOthersWaiting) {
  // One never stops sending a little; others, more than are served at a time, stop half way.
  Connection drip(studio_->port());
  drip.say("GET / HTTP/1.1\r\n");
  std::vector<std::unique_ptr<Connection>> slow;
  for (int i = 0; i < 80; ++i) {
    slow.push_back(std::make_unique<Connection>(studio_->port()));
    slow.back()->say("GET " + studio_->base() + " HTTP/1.1\r\nHo");
  }
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(status(fair_get()), 200);
  // They are let go after 5 seconds.
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(8));
  bool taken = true;
  for (int i = 0; i < 20 && taken; ++i) {
    taken = drip.say("X");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_FALSE(taken);
}

}  // namespace
}  // namespace hada
