// `cnrg locate` as a filter: answers as lines come, in bounded memory, and honest ends.
#include <algorithm>
#include <string>

#include "tests/app/program.h"
#include "tests/catch.h"

namespace cnrg {
namespace {

using Catch::Contains;
using Catch::StartsWith;

const char* const kBoxTree = "cnrg: 1\nnodes: {a: {box: {min: [0, 0, 0], max: [2, 2, 2]}}}\nresult: a\n";
const std::string kLocate = "'" CNRG_PROGRAM "' locate t.yaml";

TEST_CASE("locate answers while it reads", "[app][locate]") {
  const Workshop w;
  w.write("t.yaml", kBoxTree);
  const Outcome endless = w.shell("yes '1 1 1' | " + kLocate + " 2>.err | head -1 >.out");
  CHECK(endless.out == "3 r0 1 a\n");
  CHECK(endless.err.empty());
  // The first line is answered although the second one does not come.
  const Outcome typed = w.shell(
      "rm .out; mkfifo points && { { echo 1 1 1; n=0; while [ ! -s .out ] && [ $n -lt 100 ]; do sleep 0.1; "
      "n=$((n+1)); "
      "done; "
      "cp .out early; echo 3 3 3; } >points & } && " +
      kLocate + " <points >.out 2>.err; wait");
  CHECK(w.read("early") == "3 r0 1 a\n");
  CHECK(typed.out == "3 r0 1 a\n3 r1 0\n");
}

TEST_CASE("a reader that leaves ends locate without a word", "[app][locate]") {
  const Workshop w;
  w.write("t.yaml", kBoxTree);
  const Outcome o = w.shell("{ trap '' PIPE; yes '1 1 1' 2>/dev/null | " + kLocate +
                            " 2>.err; echo $? >status; } | head -1 >.out; sleep 0.3");
  CHECK(o.out == "3 r0 1 a\n");
  CHECK(o.err.empty());
  CHECK(w.read("status") == "3\n");
}

TEST_CASE("memory of locate does not grow with the points", "[app][locate]") {
  const Workshop w;
  w.write("t.yaml", kBoxTree);
  // With as much memory as a few points need.
  const Outcome bounded = w.shell("yes '1 1 1' | head -500000 | ( ulimit -d 60000; " + kLocate +
                                  " --threads 1 2>.err ) | wc -l >.out");
  CHECK(bounded.err.empty());
  CHECK_THAT(bounded.out, Contains("500000"));
}

TEST_CASE("input that cannot be read is no end of input", "[app][locate][errors]") {
  const Workshop w;
  w.write("t.yaml", kBoxTree);
  const Outcome o = w.shell(kLocate + " <. >.out 2>.err");
  CHECK(o.status == 3);
  CHECK(o.out.empty());
  CHECK(o.err == "<stdin>:1:1: error: the points cannot be read: Is a directory\n");
  const Outcome zeros = w.shell(kLocate + " </dev/zero >.out 2>.err");
  CHECK(zeros.status == 2);
  CHECK_THAT(zeros.err, StartsWith("<stdin>:1:1: error: this line has more than 400,000 characters"));
}

TEST_CASE("answers before a fault are given, and the last line needs no end", "[app][locate][errors]") {
  const Workshop w;
  w.write("t.yaml", kBoxTree);
  const Outcome o = w.run("locate t.yaml", "1 1 1\r\n\n1 one 1\n1 1 1\n");
  CHECK(o.status == 2);
  CHECK(o.out == "3 r0 1 a\n\n");
  CHECK(o.err ==
        "<stdin>:3:3: error: `one` is no number; write a decimal such as 0.1 or 1.5e-3, or a fraction such as "
        "1/3\n");
  CHECK(w.run("locate t.yaml", "1 1 1").out == "3 r0 1 a\n");
  CHECK_THAT(w.run("locate t.yaml", "1e100001 1 1\n").err,
             Contains("`1e100001` has the exponent 100001; exponents are from -100000 to 100000"));
  CHECK_THAT(w.run("locate t.yaml", std::string(100001, '1') + " 1 1\n").err,
             Contains("has 100,001 characters; a number here has at most 100,000"));
  CHECK(w.run("locate t.yaml", std::string(99999, '1') + " 1 1\n").out == "3 r1 0\n");
}

TEST_CASE("a byte order mark before the points is no part of them", "[app][locate]") {
  const Workshop w;
  w.write("t.yaml", kBoxTree);
  const Outcome o = w.run("locate t.yaml",
                          "\xef\xbb\xbf"
                          "1 1 1\n3 3 3\n");
  CHECK(o.err.empty());
  CHECK(o.out == "3 r0 1 a\n3 r1 0\n");
  CHECK_THAT(w.run("locate t.yaml",
                   "\xef\xbb\xbf"
                   "one 1 1\n")
                 .err,
             StartsWith("<stdin>:1:1: error: `one`"));
  CHECK_THAT(w.run("locate t.yaml",
                   "1 1 1\n\xef\xbb\xbf"
                   "1 1 1\n")
                 .err,
             StartsWith("<stdin>:2:1: error: "));
}

TEST_CASE("each point beyond the frame is located like one that was known before", "[app][locate]") {
  const Workshop w;
  w.write("t.yaml",
          "cnrg: 1\nnodes:\n  h: {halfspace: {point: [0, 0, 0], normal: [0, 1, 3]}}\n"
          "  g: {halfspace: {point: [0, 0, 5], normal: [1, 2, 0]}}\n  u: {union: [h, g]}\nresult: u\n");
  std::string points, answers;
  for (const char* x : {"1", "-1e3", "1e9", "-1e20", "1e60", "1e250", "-1e300"}) {
    const std::string point = std::string(x) + " " + x + " -7\n";
    points += point;
    answers += w.run("locate t.yaml", point).out;
  }
  const Outcome o = w.run("locate t.yaml", points);
  INFO(o.err);
  CHECK(o.status == 0);
  CHECK(o.out == answers);
  CHECK_THAT(w.run("locate t.yaml", "0 0 0\n1e302 0 0\n").err,
             StartsWith("<stdin>:2:1: error: this point is too far"));
}

}  // namespace
}  // namespace cnrg
