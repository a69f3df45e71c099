// A reader of a store leaves no trace: neither the file nor SQLite's files beside it are created,
// changed or removed. This holds at rest, while a campaign writes, and after it was killed.
#include <gtest/gtest.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include "campaign/store/store.h"
#include "scenes/places.h"
#include "scenes/small_study.h"
#include "wythe/parts/error.h"
#include "wythe/parts/stored_states.h"

namespace wythe::study::untouched_store_test {
namespace {

namespace fs = std::filesystem;
using scenes::TemporaryFolder;

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// Names and bytes of all that lies in a folder.
std::map<std::string, std::string> content_of(const std::string& folder) {
  std::map<std::string, std::string> content;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    content[entry.path().filename().string()] =
        std::string(std::istreambuf_iterator<char>(file), {});
  }
  return content;
}

SampleRecord refused_sample(int number) {
  SampleRecord record;
  record.sample = number;
  record.status = "refused";
  record.reason = {"other", {{"text", "too thin"}}};
  return record;
}

// Another process with the store open for writing: it stores a sample at each word, until it is killed or told to end.
class Writer {
 public:
  explicit Writer(const std::string& folder) {
    if (::pipe(orders_) != 0 || ::pipe(answers_) != 0) throw IoError("no pipe");
    child_ = ::fork();
    if (child_ == 0) {
      ::close(orders_[1]);
      int code = 1;
      try {
        work(folder);
        code = 0;
      } catch (...) {
      }
      ::_exit(code);
    }
    ::close(orders_[0]), ::close(answers_[1]);
  }
  ~Writer() { end(SIGKILL); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  [[nodiscard]] bool store(char sample) {
    char said = 0;
    return ::write(orders_[1], &sample, 1) == 1 && ::read(answers_[0], &said, 1) == 1;
  }
  void kill() { end(SIGKILL); }
  // Ends as a campaign does.
  void end(int signal = 0) {
    if (child_ <= 0) return;
    if (signal != 0) ::kill(child_, signal);
    ::close(orders_[1]), ::close(answers_[0]);
    ::waitpid(child_, nullptr, 0);
    child_ = 0;
  }

 private:
  void work(const std::string& folder) {
    Store store(folder, Store::Access::kWrite);
    char sample = 0;
    while (::read(orders_[0], &sample, 1) == 1) {
      store.write(packed(refused_sample(sample), {}));
      if (::write(answers_[1], &sample, 1) != 1) return;
    }
  }
  int orders_[2] = {}, answers_[2] = {};
  pid_t child_ = 0;
};

class UntouchedStore : public testing::Test {
 protected:
  void SetUp() override {
    const StudySpec study = scenes::small_study(3);
    create_store(out_, study, draw_samples(study), {"1/1", "this program", 0.75});
  }
  // All that only reads, and how many samples it saw; the folder stays as it was.
  void read_all(std::size_t samples) {
    const auto before = content_of(out_);
    EXPECT_EQ(campaign_progress(out_).done, static_cast<int>(samples));
    EXPECT_EQ(read_campaign(out_).records.size(), samples);
    EXPECT_EQ(read_answers(out_).records.size(), samples);
    check_campaign(out_);
    EXPECT_TRUE(holds_campaign(out_));
    EXPECT_TRUE(content_of(out_) == before);
    merge_campaigns({out_}, folder_ / "merged");
    EXPECT_EQ(read_campaign(folder_ / "merged").records.size(), samples);
    EXPECT_TRUE(content_of(out_) == before);
    fs::remove_all(folder_ / "merged");
  }
  TemporaryFolder folder_;
  std::string out_ = folder_ / "out";
};

TEST_F(UntouchedStore, at_rest) {
  EXPECT_EQ(content_of(out_).size(), 1U);
  read_all(0);
  fs::permissions(out_, fs::perms::owner_read | fs::perms::owner_exec);
  read_all(0);
  fs::permissions(out_, fs::perms::owner_all);
}

TEST_F(UntouchedStore, while_a_campaign_writes) {
  Writer writer(out_);
  ASSERT_TRUE(writer.store(1));
  EXPECT_EQ(content_of(out_).size(), 3U);  // with -wal and -shm
  read_all(1);
  ASSERT_TRUE(writer.store(2));  // which the reader did not hinder
  read_all(2);
  writer.end();
  EXPECT_EQ(content_of(out_).size(), 1U);
  read_all(2);
}

TEST_F(UntouchedStore, after_a_campaign_was_killed) {
  Writer writer(out_);
  ASSERT_TRUE(writer.store(1) && writer.store(3));
  writer.kill();
  EXPECT_EQ(content_of(out_).size(), 3U);
  read_all(2);
  fs::permissions(out_, fs::perms::owner_read | fs::perms::owner_exec);
  read_all(2);
  fs::permissions(out_, fs::perms::owner_all);
  fs::remove(store_path(out_).string() + "-shm");  // a copy made without it
  read_all(2);
  EXPECT_EQ(Store(out_, Store::Access::kWrite).done(), (std::set<int>{1, 3}));
  EXPECT_EQ(content_of(out_).size(), 1U);  // a writer takes the journal in
}

// A disk that failed when the last writer removed its files: the index alone is left, and it tells nothing.
TEST_F(UntouchedStore, with_the_index_of_a_writer_that_has_ended) {
  Writer writer(out_);
  ASSERT_TRUE(writer.store(1));
  const std::string index = store_path(out_).string() + "-shm";
  fs::copy_file(index, folder_ / "index");
  writer.end();
  fs::copy_file(folder_ / "index", index);
  read_all(1);
  EXPECT_EQ(Store(out_, Store::Access::kWrite).done(), (std::set<int>{1}));
  EXPECT_EQ(content_of(out_).size(), 1U);  // a writer removes it
}

// The file alone is the whole campaign when its writer has ended, also where somebody read to the end.
TEST_F(UntouchedStore, a_reader_keeps_nothing_in_the_journal) {
  Writer writer(out_);
  ASSERT_TRUE(writer.store(1));
  Store reader(out_, Store::Access::kRead);
  EXPECT_EQ(reader.done().size(), 1U);
  ASSERT_TRUE(writer.store(2));
  writer.end();
  EXPECT_EQ(reader.done().size(), 2U);
  fs::create_directories(folder_ / "copy");
  fs::copy_file(store_path(out_), store_path(folder_ / "copy"));
  EXPECT_EQ(read_campaign(folder_ / "copy").records.size(), 2U);
}

TEST_F(UntouchedStore, with_a_rollback_journal_it_is_refused_as_it_is) {
  Database(store_path(out_), Database::Access::kWrite).execute("PRAGMA journal_mode = DELETE");
  fs::create_directories(folder_ / "hot");
  {
    Database database(store_path(out_), Database::Access::kWrite);
    database.execute(
        "PRAGMA cache_size = 1; BEGIN; UPDATE study SET value = value || hex(zeroblob(50000))");
    for (const fs::directory_entry& entry : fs::directory_iterator(out_))
      fs::copy_file(entry.path(), fs::path(folder_ / "hot") / entry.path().filename());
  }
  const auto before = content_of(folder_ / "hot");
  ASSERT_EQ(before.size(), 2U);
  try {
    check_campaign(folder_ / "hot");
    FAIL() << "read half a transaction";
  } catch (const IoError& error) {
    EXPECT_TRUE(has(error.what(), "campaign.db-journal is there")) << error.what();
  }
  EXPECT_TRUE(content_of(folder_ / "hot") == before);
  EXPECT_THROW((void)read_campaign(folder_ / "hot"), IoError);
  EXPECT_TRUE(content_of(folder_ / "hot") == before);
}

}  // namespace
}  // namespace wythe::study::untouched_store_test
