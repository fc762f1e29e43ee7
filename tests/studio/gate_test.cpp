#include "studio/gate.h"

#include <algorithm>
#include <map>
#include <string>

#include <gtest/gtest.h>

namespace hada {
namespace {

const Gate gate{.port = 4000, .token = "0123456789abcdef0123456789abcdef", .body_bytes = 100};

HttpRequest asked(const std::string& method, const std::string& rest,
                  std::map<std::string, std::string> headers = {}) {
  headers.emplace("host", "127.0.0.1:4000");
  HttpRequest request;
  request.method = method;
  request.path = "/" + gate.token + "/" + rest;
  request.headers = std::move(headers);
  return request;
}

HttpRequest posted(const std::string& length) {
  return asked("POST", "api/fold/do",
               {{"origin", "http://127.0.0.1:4000"},
                {"content-type", "application/json"},
                {"content-length", length}});
}

int status_of(const HttpRequest& request) {
  const auto answer = refusal(gate, request);
  return answer ? answer->status : 200;
}

TEST(Gate, LetsOurOwnPageIn) {
  EXPECT_EQ(status_of(asked("GET", "")), 200);
  EXPECT_EQ(status_of(posted("100")), 200);
  EXPECT_EQ(path_within(gate, asked("GET", "api/fold/state")), "api/fold/state");
}

TEST(Gate, KnowsItsOwnNameOnly) {
  for (const std::string host :
       {"evil.example:4000", "127.0.0.1:4001", "127.0.0.1", "127.0.0.1:4000.evil.example", ""}) {
    HttpRequest request = asked("GET", "");
    request.headers["host"] = host;
    EXPECT_EQ(status_of(request), 403) << host;
  }
}

TEST(Gate, LetsNoOtherPageAsk) {
  EXPECT_EQ(status_of(asked("GET", "", {{"origin", "http://evil.example"}})), 403);
  EXPECT_EQ(status_of(asked("GET", "", {{"origin", "null"}})), 403);
  EXPECT_EQ(status_of(asked("GET", "", {{"sec-fetch-site", "cross-site"}})), 403);
  // Whatever changes something must say where it comes from.
  EXPECT_EQ(status_of(asked("POST", "api/fold/do",
                            {{"content-type", "application/json"}, {"content-length", "2"}})),
            403);
}

TEST(Gate, OpensWithTheWholeTokenOnly) {
  HttpRequest request = asked("GET", "");
  for (const std::string path :
       {"/", "/api/fold/state", "/0123456789abcdef/", "/0123456789abcdef0123456789abcdee/", ""}) {
    request.path = path;
    EXPECT_EQ(status_of(request), 404) << path;
  }
}

TEST(Gate, TakesPlainBodiesOfAKnownLength) {
  EXPECT_EQ(status_of(posted("101")), 413);
  EXPECT_EQ(status_of(posted("-1")), 400);
  EXPECT_EQ(status_of(posted("99999999999999999999")), 400);
  EXPECT_EQ(status_of(posted("")), 411);
  HttpRequest packed = posted("10");
  packed.headers["content-encoding"] = "gzip";
  EXPECT_EQ(status_of(packed), 411);
  EXPECT_EQ(status_of(asked("GET", "", {{"content-length", "1"}})), 400);
  EXPECT_EQ(status_of(asked("DELETE", "")), 405);
  EXPECT_EQ(status_of(asked("GET", "", {{"range", "bytes=0-1"}})), 416);
}

TEST(Gate, MakesTokensThatNobodyGuesses) {
  const std::string one = random_token(), other = random_token();
  EXPECT_EQ(one.size(), 32u);
  EXPECT_NE(one, other);
  EXPECT_EQ(one.find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(Gate, AllowsABrowserOnlyWhatComesFromHere) {
  const auto answer = guarded({});
  const auto policy = std::find_if(answer.headers.begin(), answer.headers.end(), [](const auto& h) {
    return h.first == "Content-Security-Policy";
  });
  ASSERT_NE(policy, answer.headers.end());
  EXPECT_NE(policy->second.find("default-src 'none'"), std::string::npos);
}

}  // namespace
}  // namespace hada
