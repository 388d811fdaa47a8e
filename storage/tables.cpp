#include "storage/job_row.hpp"
#include "storage/schema.hpp"

namespace lamprey::storage {

namespace {

SchemaObject sweep_table() {
  return {
      "sweep",
      "One row per submitted sweep.",
      {
          {"sweep", "INTEGER PRIMARY KEY", "Key, in order of submission"},
          {"id", "TEXT NOT NULL UNIQUE CHECK (length(id) = 32)", "Id, 32 hex digits, from the canonical specification"},
          {"name", "TEXT NOT NULL UNIQUE", "Name given in the sweep file"},
          {"state", "TEXT NOT NULL CHECK (state IN ('running', 'finished', 'cancelling', 'cancelled'))",
           "running, finished, cancelling or cancelled"},
          {"specification", "BLOB NOT NULL", "Protobuf message lamprey.idl.SweepSpecification"},
          {"source", "TEXT NOT NULL", "The sweep file as its author wrote it; may be empty"},
          {"seed", "INTEGER NOT NULL", "Seed of all its jobs; 64 bits, those from 2^63 on appear as negative"},
          {"replicates", "INTEGER NOT NULL CHECK (replicates > 0)", "Number of replicates of each cell of the grid"},
          {"jobs", "INTEGER NOT NULL CHECK (jobs > 0)", "Number of jobs: cells of all grids times replicates"},
          {"science_version", "INTEGER NOT NULL", "Version of the models and operators that it runs under"},
          {"checksum", "BLOB NOT NULL CHECK (length(checksum) = 32)",
           "SHA-256 over id, name, specification, source, seed, replicates, jobs and science_version"},
          {"created", "INTEGER NOT NULL", "When it was submitted, Unix time in milliseconds"},
          {"ended", "INTEGER", "When it was finished or cancelled, Unix time in milliseconds; NULL before"},
          {"last_result", "INTEGER", "When its latest job ended, Unix time in milliseconds; NULL before the first"},
          {"done", "INTEGER NOT NULL DEFAULT 0", "Number of its jobs in state done"},
          {"failed", "INTEGER NOT NULL DEFAULT 0", "Number of its jobs in state failed"},
          {"quarantined", "INTEGER NOT NULL DEFAULT 0", "Number of its jobs in state quarantined"},
          {"cancelled", "INTEGER NOT NULL DEFAULT 0", "Number of its jobs in state cancelled"},
          {"divergences", "INTEGER NOT NULL DEFAULT 0", "Number of its rows in divergence"},
      },
      "CHECK (done + failed + quarantined + cancelled <= jobs)"};
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
  return table;
}

SchemaObject worker_table() {
  return {
      "worker",
      "One row per run of a worker process that has joined.",
      {
          {"worker", "INTEGER PRIMARY KEY", "Key: the worker's incarnation, 64 bits; printf('%016x', worker) in logs"},
          {"host", "TEXT NOT NULL", "Name of its host"},
          {"process", "INTEGER NOT NULL", "Its process id there"},
          {"threads", "INTEGER NOT NULL", "Number of its computing threads"},
          {"build", "TEXT NOT NULL", "Version and compiler that it was built with"},
          {"dds", "TEXT NOT NULL", "DDS implementation that it used"},
          {"first_seen", "INTEGER NOT NULL", "When it first appeared, Unix time in milliseconds"},
          {"last_seen", "INTEGER NOT NULL", "When this row was last brought up to date, Unix time in milliseconds"},
      },
      ""};
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

std::vector<SchemaObject> tables() {
  return {sweep_table(),
          job_table(),
          worker_table(),
          event_table(),
          divergence_table(),
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
