#include "storage/view_columns.hpp"

namespace lamprey::storage {

std::string utc_time(const std::string& milliseconds) {
  return "strftime('%Y-%m-%dT%H:%M:%SZ', " + milliseconds + " / 1000, 'unixepoch')";
}

Column worker_key(const std::string& row, const std::string& description) {
  const std::string worker = row + ".worker";
  return {"worker", "CAST(CASE WHEN " + worker + " IS NOT NULL THEN printf('%016x', " + worker + ") END AS TEXT)",
          description};
}

namespace {

SchemaObject progress_view() {
  const std::string ended = "(done + failed + quarantined + cancelled)";
  const std::string rate = "(1000.0 * (" + ended + " - reused) / nullif(last_result - created, 0))";
  return {"progress",
          "One row per sweep: how far it is.",
          {
              {"sweep", "name", "Name of the sweep"},
              {"state", "state", "running, paused, finished, cancelling, cancelled or deleting"},
              {"jobs", "jobs", "Number of its jobs"},
              {"pending", "CAST(jobs - " + ended + " AS INTEGER)", "Jobs that have not ended, leased ones included"},
              {"done", "done", "Jobs that have an outcome"},
              {"failed", "failed", "Jobs that ended without one"},
              {"quarantined", "quarantined", "Jobs given up after a number of attempts"},
              {"cancelled", "cancelled", "Jobs that were cancelled"},
              {"divergences", "divergences", "Results that contradicted the stored ones"},
              {"reused", "reused", "Of the done ones: those whose outcome the database had already"},
              {"audited", "audited", "Jobs that audits have computed again"},
              {"jobs_per_second", "CAST(" + rate + " AS REAL)",
               "Ended jobs per second from submission to the latest result, pauses included and reused ones not; NULL "
               "before "
               "the first"},
              {"seconds_left", "CAST((jobs - " + ended + ") / nullif(" + rate + ", 0) AS REAL)",
               "Time that the pending jobs need at that rate; NULL if it isn't known"},
              {"submitted", utc_time("created"), "When it was submitted, UTC"},
              {"ended", utc_time("ended"), "When it was finished or cancelled, UTC; NULL before"},
              {"archived", "archived", "1 if it is hidden unless asked for"},
              {"reason", "reason", "Why it was paused or stopped, where that was not a person's wish"},
          },
          "FROM sweep"};
}

/// A column of the worker that computed the job; NULL where it isn't known.
Column of_worker(const std::string& column, const std::string& description) {
  return {column, "nullif(w." + column + ", '')", description};
}

SchemaObject provenance_view() {
  SchemaObject view{
      "provenance",
      "One row per job that has ended: where its outcome comes from.",
      {{"sweep", "s.name", "Name of the sweep"},
       {"job", "j.job", "Number of the job within its sweep, from 0"},
       {"state", "j.state", "done, failed, quarantined or cancelled"},
       {"attempt", "j.attempt", "Which attempt this is the end of, from 1"},
       worker_key("j", "The worker that computed it, 16 hex digits; NULL if none did"),
       of_worker("host", "Name of that worker's host"),
       {"process", "w.process", "Its process id there"},
       of_worker("processor", "Name of its processor; NULL if unknown"),
       of_worker("instruction_set", "Instruction set that it computed with; NULL if unknown"),
       of_worker("build", "Version and commit that it was built from"),
       of_worker("flags", "Compiler and flags of its build; NULL if unknown"),
       of_worker("dds", "DDS implementation that it used"),
       {"queue_seconds", "j.queue_seconds", "Time from submission, or from being pending again, to lease"},
       {"waited_seconds", "j.waited_seconds", "Time that it then waited at its worker"},
       {"seconds", "j.seconds", "Time that its computation took"},
       {"commit_seconds", "j.commit_seconds", "Time from the arrival of its result to its commit"},
       {"ended", utc_time("j.ended"), "When its row was written, UTC"},
       {"reused_from",
        "CASE WHEN j.reused_from_job IS NOT NULL "
        "THEN coalesce(r.name, '(deleted)') || '/' || j.reused_from_job END",
        "Sweep and job whose outcome this is, with a slash between; NULL if it was computed for this one"}},
      ""};
  view.rest = std::string(jobs_with_sweep) +
              " LEFT JOIN worker AS w ON w.worker = j.worker LEFT JOIN sweep AS r ON r.sweep = j.reused_from_sweep";
  return view;
}

SchemaObject attempts_view() {
  return {"attempts",
          "One row per attempt at a job that has not led to the job's row.",
          {{"sweep", "s.name", "Name of the sweep"},
           {"job", "a.job", "Number of the job within its sweep, from 0"},
           {"ended", utc_time("a.at"), "When it ended, UTC"},
           worker_key("a", "The worker that had it, 16 hex digits; NULL if none did"),
           {"ending", "a.ending",
            "lost (with its worker), refused, or failed, quarantined or cancelled and taken back by a retry"},
           {"counted", "a.counted", "1 if it counts towards quarantine"},
           {"reason", "nullif(a.reason, '')", "Why it ended so"}},
          "FROM attempt AS a JOIN sweep AS s ON s.sweep = a.sweep"};
}

SchemaObject audits_view() {
  return {
      "audits",
      "One row per audit: how many of the jobs computed again have given the same bits.",
      {{"sweep", "s.name", "Name of the sweep"},
       {"audit", "a.id", "Id of the audit, 32 hex digits"},
       {"share", "a.share", "Share of the sweep's done jobs that it asks for, up to 1"},
       {"jobs", "a.jobs", "Number of jobs to compute again"},
       {"agreed", "a.agreed", "Number of jobs whose digest was the same again"},
       {"diverged", "a.diverged", "Number of jobs whose digest was another one"},
       {"state", "CASE WHEN a.agreed + a.diverged = a.jobs THEN 'finished' ELSE 'running' END", "running or finished"},
       {"started", utc_time("a.created"), "When it was asked for, UTC"}},
      "FROM audit AS a JOIN sweep AS s ON s.sweep = a.sweep"};
}

SchemaObject history_view() {
  return {"history",
          "One row per event: what happened, in order.",
          {{"event", "e.event", "Number, in order of time"},
           {"at", utc_time("e.at"), "When, UTC"},
           {"epoch", "e.epoch", "Epoch of the coordinator that wrote it"},
           {"kind", "e.kind", "What: database_opened, sweep_submitted, worker_joined, lease_lost and the like"},
           {"sweep", "s.name", "Name of the sweep, where it is about one"},
           {"job", "e.job", "Number of the job, where it is about one"},
           worker_key("e", "The worker, 16 hex digits, where it is about one"),
           {"text", "e.text", "The details, for people"}},
          "FROM event AS e LEFT JOIN sweep AS s ON s.sweep = e.sweep"};
}

}  // namespace

std::vector<SchemaObject> history_views() {
  return {progress_view(), provenance_view(), attempts_view(), audits_view(), history_view()};
}

}  // namespace lamprey::storage
