// Reads an MCAP file as Foxglove does, and writes each message as a line of JSON: {"topic", "time" (ns), "message"}.
// Shares no code with Lamprey.
"use strict";

const fs = require("fs");
const { McapStreamReader } = require("@mcap/core");
const { parse } = require("@foxglove/rosmsg");
const { MessageReader } = require("@foxglove/rosmsg2-serialization");

const reader = new McapStreamReader({ validateCrcs: true });
reader.append(fs.readFileSync(process.argv[2]));

const schemas = new Map();
const channels = new Map();
const expect = (holds, what) => {
  if (!holds) throw new Error(what);
};

for (let record; (record = reader.nextRecord()) != undefined; ) {
  if (record.type === "Header") expect(record.profile === "ros2", "profile " + record.profile);
  if (record.type === "Schema") {
    expect(record.encoding === "ros2msg", "schema encoding " + record.encoding);
    const definition = new TextDecoder().decode(record.data);
    schemas.set(record.id, new MessageReader(parse(definition, { ros2: true })));
  }
  if (record.type === "Channel") {
    expect(record.messageEncoding === "cdr", "message encoding " + record.messageEncoding);
    channels.set(record.id, record);
  }
  if (record.type === "Message") {
    const channel = channels.get(record.channelId);
    const message = schemas.get(channel.schemaId).readMessage(record.data);
    const plain = (_, value) =>
      typeof value === "bigint" ? Number(value) : ArrayBuffer.isView(value) ? Array.from(value) : value;
    console.log(JSON.stringify({ topic: channel.topic, time: String(record.logTime), message }, plain));
  }
  if (record.type === "Statistics") console.log(JSON.stringify({ statistics: Number(record.messageCount) }));
}
expect(reader.done() || process.argv[3] === "--cut", "the file has no end");
