"""The hashes that endpoints announce are those of the types in idl/ros2.idl, by the rules of REP 2016."""
import hashlib
import json
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]

# Of type_description_interfaces/msg/FieldType.
NESTED, UNBOUNDED_SEQUENCE = 1, 144
PRIMITIVES = {"long": 6, "unsigned long": 7, "double": 11, "octet": 16, "string": 17}


def ros_name(wire_name):
    """std_msgs::msg::dds_::Header_ as std_msgs/msg/Header."""
    package, kind, _, name = wire_name.split("::")
    return f"{package}/{kind}/{name.removesuffix('_')}"


def field_type(text):
    sequence = re.fullmatch(r"sequence<(.*)>", text)
    element = sequence[1] if sequence else text
    number = PRIMITIVES.get(element, NESTED)
    return {"type_id": number + (UNBOUNDED_SEQUENCE if sequence else 0), "capacity": 0, "string_capacity": 0,
            "nested_type_name": ros_name(element) if number == NESTED else ""}


def descriptions():
    """Of each type in the IDL, by its name in ROS 2."""
    types = {}
    for package, body in re.findall(r"module (\w+) \{ module msg \{ module dds_ \{(.*?)\n\}; \}; \};",
                                    (ROOT / "idl" / "ros2.idl").read_text(), re.DOTALL):
        for name, fields in re.findall(r"@final struct (\w+)_ \{(.*?)\n\};", body, re.DOTALL):
            types[f"{package}/msg/{name}"] = [
                {"name": field, "type": field_type(kind)} for kind, field in re.findall(r"^  (.*) (\w+);$", fields, re.MULTILINE)]
    return types


def type_hash(name):
    types = descriptions()
    referenced, open_names = set(), [name]
    while open_names:
        for field in types[open_names.pop()]:
            nested = field["type"]["nested_type_name"]
            if nested and nested not in referenced:
                referenced.add(nested)
                open_names.append(nested)
    describe = lambda one: {"type_name": one, "fields": types[one]}
    text = json.dumps({"type_description": describe(name),
                       "referenced_type_descriptions": [describe(one) for one in sorted(referenced)]},
                      separators=(", ", ": "))
    return "RIHS01_" + hashlib.sha256(text.encode()).hexdigest()


class TypeHashes(unittest.TestCase):
    def test_the_known_hash_of_joint_state_is_reproduced(self):
        """As a ROS 2 of Iron or later prints it: the proof that the rules are understood."""
        self.assertEqual(type_hash("sensor_msgs/msg/JointState"),
                         "RIHS01_a13ee3a330e346c9d87b5aa18d24e11690752bd33a0350f11c5882bc9179260e")

    def test_announced_hashes_are_those_of_the_idl(self):
        header = (ROOT / "messaging" / "ros2" / "topics.hpp").read_text()
        for message, name in (("JointState", "sensor_msgs/msg/JointState"),
                              ("Diagnostics", "diagnostic_msgs/msg/DiagnosticArray"),
                              ("JointCommand", "std_msgs/msg/Float64MultiArray")):
            topic = header[header.index(f"struct Topic<ros2::{message}>"):]
            self.assertEqual(re.search(r'type_hash\s*=\s*"(\w+)"', topic)[1], type_hash(name), name)


if __name__ == "__main__":
    unittest.main()
