#include <argos3/campaign/store/database.h>
#include <argos3/campaign/store/result_store.h>
#include <argos3/testing/unit/campaign/campaign_files.h>

#include <catch2/catch.hpp>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>

namespace store_faults_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

constexpr auto kWrite = CResultStore::EMode::Write;
constexpr auto kReadOnly = CResultStore::EMode::ReadOnly;

std::string OpenError(const std::string& file, CResultStore::EMode mode) {
  return CatchText([&] { CResultStore store(file, mode); });
}

// runs a function in a child process, which ends without destructors
pid_t Fork(const std::function<void()>& body) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      body();
    } catch (...) {
      _exit(1);
    }
    _exit(0);
  }
  return child;
}

int WaitFor(pid_t child) {
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

std::vector<SStoredRun> MakeBatch(UInt32 combination, UInt32 firstSeed) {
  std::vector<SStoredRun> runs;
  for (UInt32 i = 0; i < 10; ++i) {
    SStoredRun run = MakeRun(combination, firstSeed + i, firstSeed);
    SMetricSeries& series = run.Result.Series[0];
    for (UInt32 tick = 21; tick < 300; ++tick) {
      series.Ticks.push_back(tick);
      series.Values.push_back(tick);
    }
    runs.push_back(run);
  }
  return runs;
}

}  // namespace

TEST_CASE("result store: a file that is removed or replaced is noticed", "[campaign][store]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, "<runs seeds=\"1\"/>");
  CResultStore store(campaign.ResultsFile, kWrite);
  store.Register(campaign, false);
  store.Add(MakeBatch(1, 1));
  CHECK_NOTHROW(store.ThrowIfRemoved());
  std::filesystem::rename(campaign.ResultsFile, campaign.ResultsFile + ".old");
  const std::string removed = "\"" + campaign.ResultsFile + "\" was removed or renamed";
  CHECK_THROWS_WITH(store.ThrowIfRemoved(), Contains(removed));
  CHECK_THROWS_WITH(store.Add(MakeBatch(1, 11)), Contains(removed));
  std::filesystem::copy_file(campaign.ResultsFile + ".old", campaign.ResultsFile);
  CHECK_THROWS_WITH(store.Add(MakeBatch(1, 11)), Contains("was replaced while"));
  std::filesystem::rename(campaign.ResultsFile + ".old", campaign.ResultsFile);
  CHECK_NOTHROW(store.Add(MakeBatch(1, 11)));
}

TEST_CASE("result store: kill -9 at any moment loses and doubles nothing", "[campaign][store]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, "<runs seeds=\"1\"/>");
  CResultStore(campaign.ResultsFile, kWrite).Register(campaign, false);
  UInt32 stored = 0;
  UInt32 killed = 0;
  for (int attempt = 0; attempt < 12; ++attempt) {
    int ends[2];
    REQUIRE(pipe(ends) == 0);
    const pid_t child = Fork([&] {
      CResultStore store(campaign.ResultsFile, kWrite);
      for (UInt32 seed = stored + 1;; seed += 10) {
        store.Add(MakeBatch(1, seed));
        const UInt32 last = seed + 9;
        if (write(ends[1], &last, sizeof(last)) != sizeof(last)) {
          _exit(2);
        }
      }
    });
    close(ends[1]);
    // waits until it writes, then for a time that differs
    UInt32 confirmed = 0;
    REQUIRE(read(ends[0], &confirmed, sizeof(confirmed)) == sizeof(confirmed));
    usleep(700 * attempt);
    kill(child, SIGKILL);
    killed += WTERMSIG(WaitFor(child)) == SIGKILL ? 1 : 0;
    UInt32 next = 0;
    while (read(ends[0], &next, sizeof(next)) == sizeof(next)) {
      confirmed = next;
    }
    close(ends[0]);

    CResultStore store(campaign.ResultsFile, kWrite);
    const std::vector<SStoredRun> runs = store.ListRuns();
    // a batch that was stored, but not confirmed, may follow
    CHECK(runs.size() >= confirmed);
    CHECK(runs.size() <= confirmed + 10);
    CHECK(runs.size() % 10 == 0);
    CHECK(store.ReadMetric("delivered").size() == runs.size());
    for (size_t i = 0; i < runs.size(); ++i) {
      CHECK(runs[i].Seed == i + 1);
    }
    const auto series = store.ReadSeries("spread");
    CHECK(series.size() == runs.size());
    CHECK(series.back().Series.Ticks.size() == 282);
    stored = static_cast<UInt32>(runs.size());
  }
  CHECK(killed == 12);
  CDatabase database(campaign.ResultsFile, CDatabase::EAccess::ReadOnly);
  CQuery check(database, "PRAGMA integrity_check");
  REQUIRE(check.Step());
  CHECK(check.GetText(0) == "ok");
}

TEST_CASE("result store: one writer, any number of readers", "[campaign][store]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, "<runs seeds=\"1\"/>");
  CResultStore store(campaign.ResultsFile, kWrite);
  store.Register(campaign, false);
  CHECK_THAT(OpenError(campaign.ResultsFile, kWrite),
             Contains("is being written by this process: wait until it ends"));
  // the failed attempt has not released the lock
  const pid_t child = Fork([&] {
    const std::string text = OpenError(campaign.ResultsFile, kWrite);
    const std::string owner = "is being written by process " + std::to_string(getppid()) + " on ";
    // the child's own list of locks was copied from this process
    _exit(text.find(owner) != std::string::npos ||
                  text.find("is being written by this process") != std::string::npos
              ? 7
              : 8);
  });
  CHECK(WEXITSTATUS(WaitFor(child)) == 7);
  const CResultStore reader(campaign.ResultsFile, kReadOnly);
  store.Add({MakeRun(1, 1, 2.0)});
  CHECK(reader.ListRuns().size() == 1);
}

TEST_CASE("result store: another process has the lock until it is killed", "[campaign][store]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, "<runs seeds=\"1\"/>");
  int ends[2];
  REQUIRE(pipe(ends) == 0);
  const pid_t child = Fork([&] {
    CResultStore store(campaign.ResultsFile, kWrite);
    store.Register(campaign, false);
    if (write(ends[1], "x", 1) == 1) {
      pause();
    }
  });
  char ready = 0;
  REQUIRE(read(ends[0], &ready, 1) == 1);
  CHECK_THAT(OpenError(campaign.ResultsFile, kWrite),
             Contains("is being written by process " + std::to_string(child) + " on "));
  kill(child, SIGKILL);
  WaitFor(child);
  close(ends[0]);
  close(ends[1]);
  CHECK(OpenError(campaign.ResultsFile, kWrite).empty());
  CHECK_FALSE(std::filesystem::exists(campaign.ResultsFile + ".lock"));
}

TEST_CASE("result store: a forked process leaves the store alone", "[campaign][store]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, "<runs seeds=\"1\"/>");
  auto store = std::make_unique<CResultStore>(campaign.ResultsFile, kWrite);
  store->Register(campaign, false);
  CHECK(WaitFor(Fork([&] { store.reset(); })) == 0);
  CHECK(std::filesystem::exists(campaign.ResultsFile + ".lock"));
  store->Add({MakeRun(1, 1, 2.0)});
  CHECK(store->ListRuns().size() == 1);
}

TEST_CASE("result store: a full disk is an error, what was stored is whole", "[campaign][store]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, "<runs seeds=\"1\"/>");
  CResultStore(campaign.ResultsFile, kWrite).Register(campaign, false);
  // the limit of the size of files stands for the disk
  const pid_t child = Fork([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    CResultStore store(campaign.ResultsFile, kWrite);
    store.Add(MakeBatch(1, 1));
    const rlimit limit{600000, 600000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const std::string text = CatchText([&] {
      for (UInt32 seed = 11; seed < 2000; seed += 10) {
        store.Add(MakeBatch(1, seed));
      }
    });
    const bool isClear =
        text.find(
            "test.sqlite\": writing failed (disk I/O error), as it does when the disk is full "
            "or a quota or the limit of the size of files is reached: free some space and "
            "resume the campaign; what was stored before is whole") != std::string::npos;
    // and it can go on after the failure
    _exit(isClear && !store.ListRuns().empty() ? 7 : 8);
  });
  const int status = WaitFor(child);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 7);
  CResultStore store(campaign.ResultsFile, kWrite);
  const size_t runs = store.ListRuns().size();
  CHECK(runs >= 10);
  CHECK(runs % 10 == 0);
  CHECK(store.ReadSeries("spread").size() == runs);
  store.Add(MakeBatch(1, 5001));
  CHECK(store.ListRuns().size() == runs + 10);
}

TEST_CASE("database: the text of a full disk", "[campaign][store]") {
  const CTemporaryFolder folder;
  CDatabase database(folder.Path("a.sqlite"), CDatabase::EAccess::Write);
  database.Execute("CREATE TABLE a(b); PRAGMA max_page_count = 3");
  CHECK_THAT(CatchText([&] { database.Execute("INSERT INTO a VALUES (zeroblob(100000))"); }),
             Contains("a.sqlite\": the disk, or the quota, is full: free some space and resume the "
                      "campaign; what was stored before is whole"));
}

TEST_CASE("database: a transaction that fails is undone", "[campaign][store]") {
  const CTemporaryFolder folder;
  CDatabase database(folder.Path("a.sqlite"), CDatabase::EAccess::Write);
  database.Execute("CREATE TABLE a(b UNIQUE); INSERT INTO a VALUES (1)");
  CHECK_THAT(CatchText([&] {
               CTransaction transaction(database);
               database.Execute("INSERT INTO a VALUES (2)");
               database.Execute("INSERT INTO a VALUES (1)");
               transaction.Commit();
             }),
             Contains("UNIQUE constraint failed"));
  CHECK(database.QueryNumber("SELECT count(*) FROM a") == 1);
}

TEST_CASE("result store: files that are no results", "[campaign][store]") {
  const CTemporaryFolder folder;
  const auto mode = GENERATE(kWrite, kReadOnly);
  CHECK_THAT(OpenError(folder.Write("text.sqlite", std::string(5000, 'x')), mode),
             Contains("text.sqlite\": it is not a database: choose another name"));
  {
    CDatabase other(folder.Path("other.sqlite"), CDatabase::EAccess::Write);
    other.Execute("CREATE TABLE IF NOT EXISTS a(b)");
  }
  CHECK_THAT(OpenError(folder.Path("other.sqlite"), mode),
             Contains("other.sqlite\" is a database, but not one of a campaign"));
  CHECK_THAT(OpenError(folder.Path("nowhere/a.sqlite"), mode), Contains("No such file"));
}

TEST_CASE("result store: a file that does not exist cannot be read", "[campaign][store]") {
  const CTemporaryFolder folder;
  CHECK_THAT(OpenError(folder.Path("a.sqlite"), kReadOnly),
             Contains("a.sqlite\" cannot be read: No such file or directory; argos3-campaign run "
                      "FILE creates it"));
  CHECK_FALSE(std::filesystem::exists(folder.Path("a.sqlite")));
}

TEST_CASE("result store: another format", "[campaign][store]") {
  const CTemporaryFolder folder;
  const std::string file = folder.Path("a.sqlite");
  { CResultStore store(file, kWrite); }
  CDatabase(file, CDatabase::EAccess::Write).Execute("PRAGMA user_version = 99");
  CHECK_THAT(OpenError(file, kWrite),
             Contains("a.sqlite\" has format 99, but this program knows format 1: use the version "
                      "of argos3-campaign that wrote it"));
}

TEST_CASE("result store: a damaged file", "[campaign][store]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, "<runs seeds=\"1\"/>");
  {
    CResultStore store(campaign.ResultsFile, kWrite);
    store.Register(campaign, false);
    for (UInt32 seed = 1; seed < 200; seed += 10) {
      store.Add(MakeBatch(1, seed));
    }
  }
  {
    std::fstream file(campaign.ResultsFile, std::ios::in | std::ios::out | std::ios::binary);
    const std::string garbage(std::filesystem::file_size(campaign.ResultsFile) - 4096, '\xa5');
    file.seekp(4096);
    file << garbage;
  }
  CHECK_THAT(CatchText([&] {
               CResultStore store(campaign.ResultsFile, kReadOnly);
               store.ListRuns();
             }),
             Contains("test.sqlite\": it is damaged (") && Contains(".recover"));
}

TEST_CASE("result store: no right to write", "[campaign][store]") {
  const CTemporaryFolder folder;
  SCampaign campaign = ReadTestCampaign(folder, "<runs seeds=\"1\"/>");
  // the name is a part of a URI, too
  campaign.ResultsFile = folder.Path("a%20b?c#d.sqlite");
  {
    CResultStore store(campaign.ResultsFile, kWrite);
    store.Register(campaign, false);
    store.Add({MakeRun(1, 1, 2.0)});
  }
  chmod(folder.GetPath().c_str(), 0555);
  chmod(campaign.ResultsFile.c_str(), 0444);
  // root may write everywhere
  const pid_t child = Fork([&] {
    if (geteuid() == 0 && (chown(folder.GetPath().c_str(), 65533, 65533) != 0 ||
                           setgid(65534) != 0 || setuid(65534) != 0)) {
      _exit(9);
    }
    const bool isRefused =
        OpenError(campaign.ResultsFile, kWrite).find("cannot be written: ") != std::string::npos;
    const CResultStore reader(campaign.ResultsFile, kReadOnly);
    _exit(isRefused && reader.ListRuns().size() == 1 ? 7 : 8);
  });
  CHECK(WEXITSTATUS(WaitFor(child)) == 7);
  chmod(folder.GetPath().c_str(), 0755);
}

TEST_CASE("result store: a reader cannot write", "[campaign][store]") {
  const CTemporaryFolder folder;
  const SCampaign campaign = ReadTestCampaign(folder, "<runs seeds=\"1\"/>");
  CResultStore(campaign.ResultsFile, kWrite).Register(campaign, false);
  CResultStore reader(campaign.ResultsFile, kReadOnly);
  CHECK_THAT(CatchText([&] { reader.Register(campaign, true); }),
             Contains("it is not writable (attempt to write a readonly database)"));
}

}  // namespace store_faults_test
