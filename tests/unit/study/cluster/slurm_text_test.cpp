#include "study/cluster/slurm_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rockslope::slurm_text_test {
namespace {

using namespace study;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(SlurmText, BatchesHaveTheExpectedTimeOfATask) {
    const std::vector<std::string> targets(1000, "row");
    SlurmOptions options;
    options.row_time = 60;
    options.batch_time = 600;
    options.most_tasks = 5;
    EXPECT_EQ(make_batches(targets, options).size(), 100u) << "ten rows in ten minutes";
    options.rows_at_once = 4;
    EXPECT_EQ(make_batches(targets, options).size(), 25u) << "forty of them, four at a time";
    options.most_tasks = 500;
    EXPECT_EQ(make_batches(targets, options).size(), 500u) << "all tasks that may run get some";
    options.row_time = 1e6;
    const Batches one_each = make_batches(targets, options);
    EXPECT_EQ(one_each.size(), 1000u) << "a row at least";
    EXPECT_EQ(make_batches(std::vector<std::string>(2500, "row"), options).size(), 834u)
        << "at most a thousand";
    EXPECT_TRUE(make_batches({}, options).empty());
}

TEST(SlurmText, SmallModelsTakeOneThread) {
    EXPECT_EQ(threads_for(400), 1);
    EXPECT_EQ(threads_for(9'999), 1);
    EXPECT_EQ(threads_for(10'000), 2);
    EXPECT_EQ(threads_for(1'000'000), 2);
}

TEST(SlurmText, TasksAreSignalledAndQueuedAgain) {
    SlurmOptions options;
    options.threads = 2;
    options.rows_at_once = 3;
    options.more = {"--partition=my part"};
    const std::string job = job_script(options);
    EXPECT_THAT(job, HasSubstr("make -k -j3 THREADS=2"));
    EXPECT_THAT(job, HasSubstr("scontrol requeue"));
    EXPECT_THAT(job, HasSubstr("asked to stop: runs write checkpoints"));
    const std::string submit = submit_script("/home/a b", options, 2, 7);
    for (const char* part :
         {"--requeue", "--signal=B:TERM@60", "--time=120", "--cpus-per-task=6", "'--partition=my part'",
          "--array=1-2%64", "--array=1-7%64", "--dependency=afterany:\"$shared\"", "cd '/home/a b'"})
        EXPECT_THAT(submit, HasSubstr(part));
    EXPECT_THAT(submit_script("/a", options, 0, 7), Not(HasSubstr("shared")));
}

}  // namespace
}  // namespace rockslope::slurm_text_test
