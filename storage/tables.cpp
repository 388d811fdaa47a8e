#include "storage/job_row.hpp"
#include "storage/schema.hpp"

namespace lamprey::storage {

namespace {

SchemaObject sweep_table() {
  return {
      "sweep",
      "One row per submitted sweep.",
      {
          // AUTOINCREMENT: the key of a deleted sweep must not come again, since rows of others may name it.
          {"sweep", "INTEGER PRIMARY KEY AUTOINCREMENT", "Key, in order of submission"},
          {"id", "TEXT NOT NULL UNIQUE CHECK (length(id) = 32)", "Id, 32 hex digits, from the canonical specification"},
          {"name", "TEXT NOT NULL UNIQUE", "Name given in the sweep file, or later"},
          {"state",
           "TEXT NOT NULL CHECK (state IN ('running', 'paused', 'finished', 'cancelling', 'cancelled', 'deleting'))",
           "running, paused, finished, cancelling, cancelled or deleting"},
          {"specification", "BLOB NOT NULL", "Protobuf message lamprey.idl.SweepSpecification"},
          {"source", "TEXT NOT NULL", "The sweep file as its author wrote it; may be empty"},
          {"seed", "INTEGER NOT NULL", "Seed of all its jobs; 64 bits, those from 2^63 on appear as negative"},
          {"replicates", "INTEGER NOT NULL CHECK (replicates > 0)", "Number of replicates of each cell of the grid"},
          {"jobs", "INTEGER NOT NULL CHECK (jobs > 0)", "Number of jobs: cells of all grids times replicates"},
          {"science_version", "INTEGER NOT NULL", "Version of the models and operators that it runs under"},
          {"checksum", "BLOB NOT NULL CHECK (length(checksum) = 32)",
           "SHA-256 over id, name, specification, source, seed, replicates, jobs, science_version, fresh and "
           "execution"},
          {"created", "INTEGER NOT NULL", "When it was submitted, Unix time in milliseconds"},
          {"ended", "INTEGER", "When it was finished or cancelled, Unix time in milliseconds; NULL before"},
          {"last_result", "INTEGER", "When its latest job ended, Unix time in milliseconds; NULL before the first"},
          {"done", "INTEGER NOT NULL DEFAULT 0", "Number of its jobs in state done"},
          {"failed", "INTEGER NOT NULL DEFAULT 0", "Number of its jobs in state failed"},
          {"quarantined", "INTEGER NOT NULL DEFAULT 0", "Number of its jobs in state quarantined"},
          {"cancelled", "INTEGER NOT NULL DEFAULT 0", "Number of its jobs in state cancelled"},
          {"divergences", "INTEGER NOT NULL DEFAULT 0", "Number of its rows in divergence"},
          {"reused", "INTEGER NOT NULL DEFAULT 0", "Number of its jobs whose outcome was another sweep's"},
          {"audited", "INTEGER NOT NULL DEFAULT 0", "Number of its jobs that audits have computed again"},
          {"fresh", "INTEGER NOT NULL DEFAULT 0 CHECK (fresh IN (0, 1))",
           "1 if every job is computed, also those whose outcome the database has"},
          {"archived", "INTEGER NOT NULL DEFAULT 0 CHECK (archived IN (0, 1))", "1 if it is hidden unless asked for"},
          {"reason", "TEXT", "Why it was paused or stopped, where that was not a person's wish"},
          {"execution", "BLOB NOT NULL DEFAULT X''",
           "Protobuf message lamprey.idl.Execution: how it is run; changes no outcome"},
      },
      "CHECK (done + failed + quarantined + cancelled <= jobs), CHECK (reused <= done)"};
}

SchemaObject job_table() {
  SchemaObject table{
      "job",
      "One row per job that has ended; jobs that are pending or leased have none. The view result shows it.",
      {
          {"sweep", "INTEGER NOT NULL REFERENCES sweep", "The sweep's key"},
          {"job", "INTEGER NOT NULL CHECK (job >= 0)", "Number of the job within its sweep, from 0"},
          {"state", "TEXT NOT NULL CHECK (state IN ('done', 'failed', 'quarantined', 'cancelled'))",
           "done, failed, quarantined or cancelled"},
          {"identity", "BLOB CHECK (length(identity) = 32)",
           "SHA-256 over science version, seed, replicate and canonical parameters"},
          {"digest", "BLOB CHECK (length(digest) = 32)", "SHA-256 over identity and outcome; NULL unless done"},
          {"attempt", "INTEGER NOT NULL CHECK (attempt > 0)", "Which attempt this is the end of, from 1"},
          {"worker", "INTEGER", "Key of the worker that computed it; NULL if none did"},
          {"seconds", "REAL NOT NULL", "Time that its computation took"},
          {"ended", "INTEGER NOT NULL", "When its row was written, Unix time in milliseconds"},
          {"reason", "TEXT", "Why it failed or was quarantined"},
          {"seed", "INTEGER", "Seed of its random streams; 64 bits, those from 2^63 on appear as negative"},
          {"replicate", "INTEGER", "Number of its replicate, from 0"},
      },
      // The tests of states only: a value of another kind is found by `lamprey verify`.
      "UNIQUE (sweep, job),\n"
      "  CHECK ((state = 'done') = (digest IS NOT NULL)), CHECK ((state = 'done') = (trace IS NOT NULL)),\n"
      "  CHECK (state <> 'done' OR (identity IS NOT NULL AND parameters IS NOT NULL))"};
  // The scores have no declared type because a REAL column would store -0.0 as 0, which has another digest.
  for (const auto& score : job_scores()) {
    for (const auto& part : score_parts()) {
      table.columns.push_back({score.prefix + "_" + part.name, "", part.meaning + " " + score.meaning});
    }
  }
  table.columns.insert(
      table.columns.end(),
      {{"cycles_run", "INTEGER", "Mutations tried"},
       {"accepted", "INTEGER", "Mutations kept: the number of rows of the trace"},
       {"successes", "INTEGER", "Mutations better than the last accepted state"},
       {"success_rate", "", "Eq. 8.1: successes / cycles_run"},
       {"parameters", "TEXT", "JSON object of the parameters that apply"},
       // Last, so that scans need not read the overflow pages that they fill.
       {"trace", "TEXT", "JSON array of the accepted changes, [cycle, stability, distance, fuel, total] each"},
       // After the trace, since databases of version 1 have got it by ALTER TABLE.
       {"measures", "TEXT",
        "JSON array of what only some jobs tell, [name, index, value] each; NULL if there is nothing"}});
  for (auto& column : columns_since_version_3("job")) table.columns.push_back(std::move(column));
  return table;
}

SchemaObject worker_table() {
  SchemaObject table{
      "worker",
      "One row per run of a worker process that has joined.",
      {
          {"worker", "INTEGER PRIMARY KEY", "Key: the worker's incarnation, 64 bits; printf('%016x', worker) in logs"},
          {"host", "TEXT NOT NULL", "Name of its host"},
          {"process", "INTEGER NOT NULL", "Its process id there"},
          {"threads", "INTEGER NOT NULL", "Number of its computing threads"},
          {"build", "TEXT NOT NULL", "Version and commit that it was built from"},
          {"dds", "TEXT NOT NULL", "DDS implementation that it used"},
          {"first_seen", "INTEGER NOT NULL", "When it first appeared, Unix time in milliseconds"},
          {"last_seen", "INTEGER NOT NULL", "When this row was last brought up to date, Unix time in milliseconds"},
      },
      ""};
  for (auto& column : columns_since_version_3("worker")) table.columns.push_back(std::move(column));
  return table;
}

SchemaObject event_table() {
  return {
      "event",
      "The history of the database: what happened, in order.",
      {
          {"event", "INTEGER PRIMARY KEY", "Key, in order of time"},
          {"at", "INTEGER NOT NULL", "When, Unix time in milliseconds"},
          {"epoch", "INTEGER NOT NULL", "Epoch of the coordinator that wrote it"},
          {"kind", "TEXT NOT NULL", "What: database_opened, sweep_submitted, worker_joined, lease_lost and the like"},
          {"sweep", "INTEGER REFERENCES sweep", "The sweep's key, where it is about one"},
          {"job", "INTEGER", "Number of the job, where it is about one"},
          {"worker", "INTEGER", "Key of the worker, where it is about one"},
          {"text", "TEXT NOT NULL", "The details, for people"},
      },
      ""};
}

SchemaObject divergence_table() {
  return {"divergence",
          "One row per result that contradicts the stored one: the same job, another digest.",
          {
              {"divergence", "INTEGER PRIMARY KEY", "Key, in order of time"},
              {"at", "INTEGER NOT NULL", "When, Unix time in milliseconds"},
              {"sweep", "INTEGER NOT NULL REFERENCES sweep", "The sweep's key"},
              {"job", "INTEGER NOT NULL", "Number of the job"},
              {"stored", "BLOB NOT NULL CHECK (length(stored) = 32)", "Digest of the stored outcome"},
              {"other", "BLOB NOT NULL CHECK (length(other) = 32)", "Digest of the outcome that contradicts it"},
              {"worker", "INTEGER", "Key of the worker that delivered the other one"},
          },
          ""};
}

SchemaObject attempt_table() {
  return {"attempt",
          "One row per attempt at a job that has not led to the job's row.",
          {
              {"attempt", "INTEGER PRIMARY KEY", "Key, in the order in which they were noted"},
              {"at", "INTEGER NOT NULL", "When it ended, Unix time in milliseconds"},
              {"sweep", "INTEGER NOT NULL REFERENCES sweep", "The sweep's key"},
              {"job", "INTEGER NOT NULL CHECK (job >= 0)", "Number of the job"},
              {"worker", "INTEGER", "Key of the worker that had it; NULL if none did"},
              {"ending", "TEXT NOT NULL CHECK (ending IN ('lost', 'refused', 'failed', 'quarantined', 'cancelled'))",
               "lost (with its worker), refused, or failed, quarantined or cancelled and taken back by a retry"},
              {"counted", "INTEGER NOT NULL CHECK (counted IN (0, 1))", "1 if it counts towards quarantine"},
              {"reason", "TEXT NOT NULL", "Why it ended so; may be empty"},
          },
          ""};
}

SchemaObject checkpoint_table() {
  return {"checkpoint",
          "One row per job that has not ended and that can go on from a state which its worker has sent.",
          {
              {"sweep", "INTEGER NOT NULL REFERENCES sweep", "The sweep's key"},
              {"job", "INTEGER NOT NULL CHECK (job >= 0)", "Number of the job"},
              {"at", "INTEGER NOT NULL", "When it came, Unix time in milliseconds"},
              {"worker", "INTEGER", "Key of the worker that sent it"},
              {"cycle", "INTEGER NOT NULL", "Cycle that is the next one"},
              {"seconds", "REAL NOT NULL", "Time that the computation has taken so far"},
              {"state", "BLOB NOT NULL", "Everything that the job needs to go on, with a check sum of its own"},
          },
          "PRIMARY KEY (sweep, job)"};
}

SchemaObject audit_table() {
  return {"audit",
          "One row per audit: done jobs of a sweep that other workers compute again.",
          {
              {"audit", "INTEGER PRIMARY KEY", "Key, in order of time"},
              {"id", "TEXT NOT NULL UNIQUE CHECK (length(id) = 32)", "Id, 32 hex digits"},
              {"sweep", "INTEGER NOT NULL REFERENCES sweep", "The sweep's key"},
              {"share", "REAL NOT NULL", "Share of the sweep's done jobs that it asks for, up to 1"},
              {"seed", "INTEGER NOT NULL", "Decides which jobs; 64 bits, those from 2^63 on appear as negative"},
              {"jobs", "INTEGER NOT NULL", "Number of jobs to compute again"},
              {"agreed", "INTEGER NOT NULL DEFAULT 0", "Number of jobs whose digest was the same again"},
              {"diverged", "INTEGER NOT NULL DEFAULT 0", "Number of jobs whose digest was another one"},
              {"created", "INTEGER NOT NULL", "When it was asked for, Unix time in milliseconds"},
          },
          "CHECK (agreed + diverged <= jobs)"};
}

SchemaObject audit_job_table() {
  return {"audit_job",
          "One row per job that an audit has computed again.",
          {
              {"audit", "INTEGER NOT NULL REFERENCES audit", "The audit's key"},
              {"job", "INTEGER NOT NULL CHECK (job >= 0)", "Number of the job"},
              {"at", "INTEGER NOT NULL", "When its result came, Unix time in milliseconds"},
              {"worker", "INTEGER", "Key of the worker that computed it again"},
              {"digest", "BLOB NOT NULL CHECK (length(digest) = 32)", "Digest of the outcome that it computed"},
              {"agreed", "INTEGER NOT NULL CHECK (agreed IN (0, 1))", "1 if that is the stored one"},
          },
          "PRIMARY KEY (audit, job)"};
}

SchemaObject recording_table() {
  return {"recording",
          "One row per attempt of a job on a robot of which there is a recording.",
          {
              {"recording", "INTEGER PRIMARY KEY", "Key, in order of time"},
              {"sweep", "INTEGER NOT NULL REFERENCES sweep", "The sweep's key"},
              {"job", "INTEGER NOT NULL CHECK (job >= 0)", "Number of the job"},
              {"number", "INTEGER NOT NULL CHECK (number > 0)", "Which of the job's recorded attempts it is, from 1"},
              {"at", "INTEGER NOT NULL", "When it was stored, Unix time in milliseconds"},
              {"worker", "INTEGER", "Key of the worker that had the job"},
              {"robot", "TEXT NOT NULL", "Name of the robot"},
              {"token", "INTEGER NOT NULL", "Number of the claim that the robot was moved under"},
              {"state", "TEXT NOT NULL CHECK (state IN ('done', 'failed'))", "How the attempt ended: done or failed"},
              {"accepted", "INTEGER NOT NULL CHECK (accepted IN (0, 1))", "1 if the job's row is its outcome"},
              {"checksum", "BLOB NOT NULL CHECK (length(checksum) = 32)",
               "SHA-256 over the other columns but recording, number and at, and over its evaluations"},
          },
          "UNIQUE (sweep, job, number),\n  CHECK (accepted = 0 OR state = 'done')"};
}

SchemaObject robot_evaluation_table() {
  return {"robot_evaluation",
          "One row per try of an evaluation on a robot. The view motion shows it position by position.",
          {
              {"recording", "INTEGER NOT NULL REFERENCES recording", "The recording's key"},
              {"evaluation", "INTEGER NOT NULL CHECK (evaluation >= 0)",
               "Number of the evaluation within the job: 0 of the first genes, then one for each cycle"},
              {"attempt", "INTEGER NOT NULL CHECK (attempt >= 0)", "Which try of the evaluation it is, from 0"},
              {"voided", "TEXT", "Why it is worth nothing and the evaluation was tried again; NULL if it counts"},
              {"measured", "INTEGER NOT NULL CHECK (measured IN (0, 1))",
               "1 if sensors measured what is reported, 0 if the device interpolates its commands"},
              {"steps", "INTEGER NOT NULL CHECK (steps >= 0)", "Number of its time steps"},
              // Last, so that scans need not read the overflow pages that they fill.
              {"commanded", "TEXT NOT NULL",
               "JSON array of where the servos were sent after all limits, in hundredths of a position: eight that it "
               "began with, then eight for each time step"},
              {"reported", "TEXT NOT NULL", "JSON array of where the robot said that they were, likewise"},
              {"feet", "TEXT NOT NULL",
               "JSON array of the feet down, a number for each eight positions: 1 front left, 2 front right, 4 back "
               "left, 8 back right, added up"},
          },
          "PRIMARY KEY (recording, evaluation, attempt)"};
}

SchemaObject database_table() {
  return {"database",
          "One row about the database itself.",
          {
              {"row", "INTEGER PRIMARY KEY CHECK (row = 1)", "Always 1"},
              {"database_id", "TEXT NOT NULL CHECK (length(database_id) = 32)", "Random id, 32 hex digits"},
              {"science_version", "INTEGER NOT NULL", "Version of the models and operators of all its outcomes"},
              {"epoch", "INTEGER NOT NULL", "How often a coordinator has opened it"},
              {"created", "INTEGER NOT NULL", "When it was made, Unix time in milliseconds"},
              {"opened", "INTEGER NOT NULL", "When a coordinator last opened it, Unix time in milliseconds"},
              {"fingerprint", "TEXT NOT NULL", "SHA-256 over the views and descriptions, in hex"},
          },
          ""};
}

}  // namespace

std::vector<Column> columns_since_version_3(const std::string& table) {
  if (table == "job") {
    return {{"queue_seconds", "REAL",
             "Time from its submission, or from being pending again, to its lease; NULL if none computed it for this "
             "sweep"},
            {"waited_seconds", "REAL", "Time that it then waited at its worker; NULL likewise"},
            {"commit_seconds", "REAL", "Time from the arrival of its result to its commit; NULL likewise"},
            {"reused_from_sweep", "INTEGER", "Key of the sweep whose outcome this is; NULL if it was computed"},
            {"reused_from_job", "INTEGER", "Number of the job there"}};
  }
  if (table == "worker") {
    return {{"flags", "TEXT NOT NULL DEFAULT ''", "Compiler and flags of its build; empty if unknown"},
            {"processor", "TEXT NOT NULL DEFAULT ''", "Name of its processor; empty if unknown"},
            {"instruction_set", "TEXT NOT NULL DEFAULT ''", "Instruction set that it computed with; empty if unknown"},
            {"labels", "TEXT NOT NULL DEFAULT ''", "Its labels, between commas"},
            {"draining", "INTEGER NOT NULL DEFAULT 0 CHECK (draining IN (0, 1))",
             "1 if it was told to take nothing more and has not left since"}};
  }
  return {};
}

std::vector<SchemaObject> tables() {
  return {sweep_table(),
          job_table(),
          worker_table(),
          event_table(),
          divergence_table(),
          attempt_table(),
          checkpoint_table(),
          audit_table(),
          audit_job_table(),
          recording_table(),
          robot_evaluation_table(),
          database_table(),
          {"schema_version",
           "One row per version that the tables have had.",
           {{"version", "INTEGER PRIMARY KEY", "Version of the tables; the highest is PRAGMA user_version"},
            {"applied", "INTEGER NOT NULL", "Since when, Unix time in milliseconds"},
            {"program", "TEXT NOT NULL", "Version of Lamprey that made them"}},
           ""},
          {"schema_description",
           "What every table, view and column means.",
           {{"object", "TEXT NOT NULL", "Name of the table or view"},
            {"column", "TEXT NOT NULL", "Name of the column; empty for the object itself"},
            {"description", "TEXT NOT NULL", "What it means"}},
           "PRIMARY KEY (object, \"column\")"}};
}

std::string table_sql(const SchemaObject& table) {
  std::string sql = "CREATE TABLE " + quoted(table.name) + " (";
  for (const auto& column : table.columns) {
    sql += (&column == &table.columns.front() ? "\n  " : ",\n  ") + quoted(column.name);
    if (!column.definition.empty()) sql += " " + column.definition;
  }
  if (!table.rest.empty()) sql += ",\n  " + table.rest;
  return sql + "\n)";
}

}  // namespace lamprey::storage
