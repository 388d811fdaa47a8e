/* A robot in some 300 lines of C on Cyclone DDS, to begin one's own with: it speaks the topics of
 * docs/formats/robot_topics.md and has ideal servos, which are at once where they are sent. What a real one has to do
 * instead is marked YOUR ROBOT.
 *
 *   idlc -f case-sensitive robot.idl               (idl/robot.idl; makes robot.h and robot.c)
 *   cc example_robot.c robot.c -lddsc -o example_robot
 *   ./example_robot bench $(printf bench | sha256sum | cut -c1-16) lamprey bench.state
 *   lamprey-worker --bridge bench
 */
#include "robot.h"

#include <dds/dds.h>
#include <inttypes.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { servos = 8, remembered = 64, askers = 8, standing = 10, highest = 30 };
#define CLAIM_LEASE DDS_MSECS(2000)
#define GRACE DDS_MSECS(500)
#define HEARTBEAT DDS_MSECS(500)

typedef lamprey_wire_RobotStatus Status;
typedef lamprey_wire_RobotRequest Request;
typedef lamprey_wire_RobotReply Reply;
typedef lamprey_wire_ServoCommand Command;
typedef lamprey_wire_ServoState State;

static volatile sig_atomic_t ending = 0;

static void end(int signal_number) {
  (void)signal_number;
  ending = 1;
}

static void fail(const char* what, dds_return_t code) {
  fprintf(stderr, "%s: %s\n", what, dds_strretcode(-code));
  exit(1);
}

static dds_entity_t made(dds_entity_t entity, const char* what) {
  if (entity < 0) fail(what, entity);
  return entity;
}

/* ---- Everything there is to know of the robot ---- */

struct Robot {
  const char* name;
  const char* isolation;
  const char* state_file;
  uint64_t number;
  lamprey_wire_RobotState state;
  double position[servos];

  uint64_t token; /* of the newest claim that was ever granted: never granted again */
  bool stopped;   /* until somebody resets it */
  char reason[256];

  uint64_t holder; /* whose claim it is; 0: nobody's */
  dds_time_t claim_ends;

  uint64_t evaluation; /* the newest one of this claim */
  uint32_t next_step;
  bool going_on;
  dds_time_t step_due; /* while it is going on */
  uint64_t voided;
};

/* What must survive: a token is granted once, an emergency stop is latched. */
static bool store(const struct Robot* robot) {
  char next[4096];
  snprintf(next, sizeof next, "%s.next", robot->state_file);
  FILE* file = fopen(next, "w");
  if (file == NULL) return false;
  bool good = fprintf(file, "%" PRIu64 " %d %s\n", robot->token, robot->stopped, robot->reason) > 0;
  good = fflush(file) == 0 && fsync(fileno(file)) == 0 && good;
  good = fclose(file) == 0 && good;
  return good && rename(next, robot->state_file) == 0;
}

static void restore(struct Robot* robot) {
  FILE* file = fopen(robot->state_file, "r");
  if (file == NULL) return; /* its first start */
  int stopped = 0;
  if (fscanf(file, "%" SCNu64 " %d %255[^\n]", &robot->token, &stopped, robot->reason) < 2) {
    fprintf(stderr, "%s is unreadable; tokens must not start anew: mend it\n", robot->state_file);
    exit(2);
  }
  robot->stopped = stopped != 0;
  fclose(file);
}

static bool has_claim(const struct Robot* robot, uint64_t token, dds_time_t now) {
  return robot->holder != 0 && token == robot->token && now < robot->claim_ends;
}

/* ---- DDS: one participant, an entity or two per topic ---- */

struct Wire {
  dds_entity_t participant;
  dds_entity_t reply_topic;
  dds_entity_t requests;
  dds_entity_t commands;
  dds_entity_t states;
  dds_entity_t statuses;
  struct {
    uint64_t asker;
    dds_entity_t publisher;
    dds_entity_t writer;
  } repliers[askers]; /* the newest ones */
  unsigned next_replier;
  Reply replies[remembered]; /* a repeated request gets the same reply */
  unsigned next_reply;
};

static dds_qos_t* qos(bool reliable, bool transient_local, int depth) {
  dds_qos_t* qos = dds_create_qos();
  const dds_data_representation_id_t representation = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos, 1, &representation);
  dds_qset_reliability(qos, reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, DDS_MSECS(100));
  dds_qset_durability(qos, transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, depth);
  dds_qset_durability_service(qos, 0, DDS_HISTORY_KEEP_LAST, depth, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED,
                              DDS_LENGTH_UNLIMITED);
  dds_qset_writer_data_lifecycle(qos, false);
  return qos;
}

static dds_qos_t* partition(const char* isolation, const char* rest) {
  char name[128];
  snprintf(name, sizeof name, "%s/%s", isolation, rest);
  dds_qos_t* qos = dds_create_qos();
  dds_qset_partition1(qos, name);
  return qos;
}

static void open_wire(struct Wire* wire, const struct Robot* robot) {
  char own[17];
  snprintf(own, sizeof own, "%016" PRIx64, robot->number);
  dds_qos_t* common_partition = partition(robot->isolation, "common");
  dds_qos_t* own_partition = partition(robot->isolation, own);
  dds_qos_t* requests = qos(true, false, 256);
  dds_qos_t* servo = qos(false, false, 1);
  dds_qos_t* servo_reader = qos(false, false, 32);
  dds_qos_t* status = qos(true, true, 1);
  dds_qset_liveliness(status, DDS_LIVELINESS_AUTOMATIC, DDS_MSECS(2000));

  const dds_entity_t p = made(dds_create_participant(DDS_DOMAIN_DEFAULT, NULL, NULL), "participant");
  wire->participant = p;
  const dds_entity_t subscriber = made(dds_create_subscriber(p, own_partition, NULL), "subscriber");
  const dds_entity_t publisher = made(dds_create_publisher(p, own_partition, NULL), "publisher");
  const dds_entity_t common = made(dds_create_publisher(p, common_partition, NULL), "publisher");
  const dds_entity_t request_topic =
      made(dds_create_topic(p, &lamprey_wire_RobotRequest_desc, "lamprey/4/robot_request", NULL, NULL), "topic");
  const dds_entity_t command_topic =
      made(dds_create_topic(p, &lamprey_wire_ServoCommand_desc, "lamprey/4/servo_command", NULL, NULL), "topic");
  const dds_entity_t state_topic =
      made(dds_create_topic(p, &lamprey_wire_ServoState_desc, "lamprey/4/servo_state", NULL, NULL), "topic");
  const dds_entity_t status_topic =
      made(dds_create_topic(p, &lamprey_wire_RobotStatus_desc, "lamprey/4/robot_status", NULL, NULL), "topic");
  wire->reply_topic =
      made(dds_create_topic(p, &lamprey_wire_RobotReply_desc, "lamprey/4/robot_reply", NULL, NULL), "topic");
  wire->requests = made(dds_create_reader(subscriber, request_topic, requests, NULL), "reader");
  wire->commands = made(dds_create_reader(subscriber, command_topic, servo_reader, NULL), "reader");
  wire->states = made(dds_create_writer(publisher, state_topic, servo, NULL), "writer");
  wire->statuses = made(dds_create_writer(common, status_topic, status, NULL), "writer");

  dds_delete_qos(common_partition);
  dds_delete_qos(own_partition);
  dds_delete_qos(requests);
  dds_delete_qos(servo);
  dds_delete_qos(servo_reader);
  dds_delete_qos(status);
}

/* Replies go to the asker's own partition; the history there waits for an asker that DDS has not matched yet. */
static dds_entity_t writer_to(struct Wire* wire, const struct Robot* robot, uint64_t asker) {
  for (unsigned i = 0; i < askers; ++i) {
    if (wire->repliers[i].publisher != 0 && wire->repliers[i].asker == asker) return wire->repliers[i].writer;
  }
  const unsigned i = wire->next_replier++ % askers;
  if (wire->repliers[i].publisher != 0) dds_delete(wire->repliers[i].publisher);
  char name[17];
  snprintf(name, sizeof name, "%016" PRIx64, asker);
  dds_qos_t* asker_partition = partition(robot->isolation, name);
  dds_qos_t* reply = qos(true, true, 4);
  wire->repliers[i].asker = asker;
  wire->repliers[i].publisher = made(dds_create_publisher(wire->participant, asker_partition, NULL), "publisher");
  wire->repliers[i].writer =
      made(dds_create_writer(wire->repliers[i].publisher, wire->reply_topic, reply, NULL), "writer");
  dds_delete_qos(asker_partition);
  dds_delete_qos(reply);
  return wire->repliers[i].writer;
}

/* ---- Requests: claims, emergency stop, placing ---- */

static bool in_range(const double* position) {
  for (int servo = 0; servo < servos; ++servo) {
    if (!(position[servo] >= 0 && position[servo] <= highest)) return false; /* NaN neither */
  }
  return true;
}

/* Why it is not granted; NULL if it is. Reasons end up in people's logs. */
static const char* handle(struct Robot* robot, const Request* request, dds_time_t now) {
  const bool ours = has_claim(robot, request->token, now);
  switch (request->kind) {
    case lamprey_wire_ROBOT_STOP:
      /* YOUR ROBOT: take the torque off, before anything else. */
      robot->stopped = true;
      robot->state = lamprey_wire_ROBOT_INACTIVE;
      snprintf(robot->reason, sizeof robot->reason, "%s", request->reason);
      return store(robot) ? NULL : "it is stopped, but that could not be stored";
    case lamprey_wire_ROBOT_RESET:
      robot->stopped = false;
      robot->reason[0] = '\0';
      return store(robot) ? NULL : "the reset could not be stored";
    case lamprey_wire_ROBOT_RELEASE:
      if (ours) robot->holder = 0;
      return NULL;
    case lamprey_wire_ROBOT_DEACTIVATE:
      /* YOUR ROBOT: take the torque off. */
      robot->state = lamprey_wire_ROBOT_INACTIVE;
      return NULL;
    case lamprey_wire_ROBOT_ACTIVATE:
      if (robot->stopped) return "emergency stop";
      /* YOUR ROBOT: torque on, where the servos are. */
      robot->state = lamprey_wire_ROBOT_ACTIVE;
      return NULL;
    case lamprey_wire_ROBOT_CLAIM:
      if (robot->stopped) return "emergency stop";
      if (robot->state != lamprey_wire_ROBOT_ACTIVE) return "it is not active";
      if (!ours) {
        if (request->token != 0) return "that claim is over";
        if (robot->holder != 0 && now < robot->claim_ends) return "somebody else has claimed it";
        ++robot->token;
        if (!store(robot)) return "the claim could not be stored"; /* the number is lost, which does no harm */
        robot->holder = request->asker;
        robot->evaluation = 0;
        robot->going_on = false;
      }
      robot->claim_ends = now + CLAIM_LEASE;
      return NULL;
    case lamprey_wire_ROBOT_PLACE:
      if (!ours) return "without its claim it is not moved";
      if (!in_range(request->position)) return "a position is out of range";
      /* YOUR ROBOT: go there slowly, and answer when it is there. */
      memcpy(robot->position, request->position, sizeof robot->position);
      robot->claim_ends = now + CLAIM_LEASE;
      return NULL;
  }
  return "unknown request";
}

static void take_requests(struct Robot* robot, struct Wire* wire) {
  void* sample = NULL;
  dds_sample_info_t info;
  while (dds_take(wire->requests, &sample, &info, 1, 1) > 0) {
    const Request* request = sample;
    const Reply* known = NULL;
    for (unsigned i = 0; i < remembered; ++i) {
      const Reply* old = &wire->replies[i];
      if (old->robot != 0 && old->asker == request->asker && old->correlation == request->correlation) known = old;
    }
    if (info.valid_data && request->robot == robot->number) {
      if (known == NULL) {
        Reply* reply = &wire->replies[wire->next_reply++ % remembered];
        free(reply->reason);
        const char* reason = handle(robot, request, dds_time());
        *reply = (Reply){.robot = robot->number,
                         .asker = request->asker,
                         .correlation = request->correlation,
                         .granted = reason == NULL || request->kind == lamprey_wire_ROBOT_STOP,
                         .reason = strdup(reason == NULL ? "" : reason),
                         .token = robot->token,
                         .lease_milliseconds = (uint32_t)(CLAIM_LEASE / DDS_MSECS(1)),
                         .state = robot->state,
                         .stopped = robot->stopped};
        known = reply;
      }
      dds_write(writer_to(wire, robot, request->asker), known);
    }
    dds_return_loan(wire->requests, &sample, 1);
    sample = NULL;
  }
}

/* ---- Commands: one per time step ---- */

static uint32_t feet_down(const double* position) {
  static const int vertical[] = {0, 1, 4, 5}; /* front left, front right, back left, back right */
  uint32_t feet = 0;
  for (int leg = 0; leg < 4; ++leg) feet |= position[vertical[leg]] <= standing ? 1U << leg : 0U;
  return feet; /* YOUR ROBOT: of its contacts, if it has any */
}

static void tell(struct Wire* wire, const struct Robot* robot, uint32_t time_step, const char* void_reason) {
  State state = {.robot = robot->number,
                 .token = robot->token,
                 .evaluation = robot->evaluation,
                 .time_step = time_step,
                 .outcome = void_reason == NULL ? lamprey_wire_STEP_DONE : lamprey_wire_STEP_VOID,
                 .reason = (char*)(void_reason == NULL ? "" : void_reason),
                 .measured = false,
                 .feet_down = feet_down(robot->position)};
  memcpy(state.commanded, robot->position, sizeof state.commanded);
  memcpy(state.reported, robot->position, sizeof state.reported);
  dds_write(wire->states, &state);
}

static void give_up(struct Robot* robot, struct Wire* wire, const char* reason) {
  robot->going_on = false;
  ++robot->voided;
  tell(wire, robot, robot->next_step, reason);
}

static void obey(struct Robot* robot, struct Wire* wire, const Command* command, dds_time_t now) {
  const bool active = robot->state == lamprey_wire_ROBOT_ACTIVE && !robot->stopped;
  if (command->robot != robot->number || !active || !has_claim(robot, command->token, now)) return;
  if (command->time_step == 0 && command->evaluation > robot->evaluation) {
    robot->evaluation = command->evaluation;
    robot->next_step = 0;
    robot->going_on = true;
  }
  if (!robot->going_on || command->evaluation != robot->evaluation) return;
  if (command->time_step != robot->next_step) return give_up(robot, wire, "a step is missing or repeated");
  if (!in_range(command->position)) return give_up(robot, wire, "a position is out of range");
  /* YOUR ROBOT: move there within its limits, wait for the end of the time step, ask where it is. */
  memcpy(robot->position, command->position, sizeof robot->position);
  tell(wire, robot, command->time_step, NULL);
  ++robot->next_step;
  robot->going_on = !command->last;
  robot->step_due = now + GRACE;
  robot->claim_ends = now + CLAIM_LEASE;
}

static void take_commands(struct Robot* robot, struct Wire* wire) {
  void* sample = NULL;
  dds_sample_info_t info;
  while (dds_take(wire->commands, &sample, &info, 1, 1) > 0) {
    if (info.valid_data) obey(robot, wire, sample, dds_time());
    dds_return_loan(wire->commands, &sample, 1);
    sample = NULL;
  }
}

/* ---- Status ---- */

static void publish_status(const struct Robot* robot, struct Wire* wire, uint64_t incarnation, dds_time_t now) {
  static uint64_t heartbeat = 0;
  static Status last;
  static dds_time_t due = 0;
  lamprey_wire_RobotCounter counters[] = {{.name = "evaluations_voided", .value = robot->voided}};
  Status status = {.robot = robot->number,
                   .name = (char*)robot->name,
                   .state = robot->state,
                   .stopped = robot->stopped,
                   .reason = (char*)robot->reason,
                   .incarnation = incarnation,
                   .token = robot->token,
                   .holder = robot->holder != 0 && now < robot->claim_ends ? robot->holder : 0,
                   .rate = 0, /* as fast as it is asked */
                   .driver = (char*)"example",
                   .device = (char*)"ideal servos",
                   .scheduling = (char*)"",
                   .host = (char*)"",
                   .process = (uint32_t)getpid(),
                   .build = (char*)"",
                   .dds = (char*)"cyclonedds",
                   .counters = {._maximum = 1, ._length = 1, ._buffer = counters, ._release = false}};
  const bool same = status.state == last.state && status.stopped == last.stopped && status.token == last.token &&
                    status.holder == last.holder;
  if (same && now < due) return;
  status.heartbeat = ++heartbeat;
  dds_write(wire->statuses, &status);
  last = status;
  due = now + HEARTBEAT;
}

int main(int count, char** arguments) {
  if (count != 5) {
    fprintf(stderr, "usage: %s NAME NUMBER ISOLATION STATE_FILE\n"
                    "NUMBER: the first 16 hexadecimal digits of the SHA-256 of NAME\n", arguments[0]);
    return 2;
  }
  struct Robot robot = {.name = arguments[1], .isolation = arguments[3], .state_file = arguments[4]};
  char* rest = NULL;
  robot.number = strtoull(arguments[2], &rest, 16);
  if (rest == arguments[2] || *rest != '\0' || robot.number == 0) {
    fprintf(stderr, "'%s' is no number in hexadecimal digits\n", arguments[2]);
    return 2;
  }
  restore(&robot);
  for (int servo = 0; servo < servos; ++servo) robot.position[servo] = standing;
  robot.state = robot.stopped ? lamprey_wire_ROBOT_INACTIVE : lamprey_wire_ROBOT_ACTIVE;
  signal(SIGINT, end);
  signal(SIGTERM, end);

  struct Wire wire = {0};
  open_wire(&wire, &robot);
  const dds_entity_t waiting = made(dds_create_waitset(wire.participant), "waitset");
  dds_set_status_mask(wire.requests, DDS_DATA_AVAILABLE_STATUS);
  dds_set_status_mask(wire.commands, DDS_DATA_AVAILABLE_STATUS);
  dds_waitset_attach(waiting, wire.requests, wire.requests);
  dds_waitset_attach(waiting, wire.commands, wire.commands);
  const uint64_t incarnation = (uint64_t)dds_time() ^ (uint64_t)getpid() << 48;

  while (!ending) {
    take_requests(&robot, &wire);
    take_commands(&robot, &wire);
    const dds_time_t now = dds_time();
    if (robot.going_on && robot.next_step > 0 && now > robot.step_due) give_up(&robot, &wire, "a step is late");
    publish_status(&robot, &wire, incarnation, now);
    dds_waitset_wait(waiting, NULL, 0, DDS_MSECS(10));
  }
  robot.state = lamprey_wire_ROBOT_FINALIZED;
  publish_status(&robot, &wire, incarnation, dds_time());
  dds_delete(wire.participant);
  for (unsigned i = 0; i < remembered; ++i) free(wire.replies[i].reason);
  return 0;
}
