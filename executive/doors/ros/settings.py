"""Where the robot is on the network of ROS: domain, namespace, interface, and the name of its node."""

from __future__ import annotations

import re
from dataclasses import dataclass

from executive.errors import UserError

LOOPBACK = "lo"
HIGHEST_DOMAIN = 232
_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_INTERFACE = re.compile(r"[A-Za-z0-9_.:-]+")


class RosSettingsError(UserError):
    """A setting of the ROS door makes no sense."""


@dataclass(frozen=True, slots=True)
class RosSettings:
    """How the robot appears to ROS.

    Attributes:
        domain: ROS_DOMAIN_ID, 0 to 232.
        namespace: Before every topic's name, "/robot_1"; empty for none.
        interface: The network interface; "lo" reaches this machine alone. DDS authenticates nobody: on
            another interface whoever is in that network commands the robot.
        node: Name of the node in the graph.
    """

    domain: int = 0
    namespace: str = ""
    interface: str = LOOPBACK
    node: str = "humanoid_executive"

    def __post_init__(self) -> None:
        """Refuse what makes no name.

        Raises:
            RosSettingsError: A value makes no sense; the message names it.
        """
        if not 0 <= self.domain <= HIGHEST_DOMAIN:
            raise RosSettingsError(f"ROS domain {self.domain} is not in the range 0 to {HIGHEST_DOMAIN}")
        parts = self.namespace.strip("/").split("/") if self.namespace.strip("/") else []
        for part in (*parts, self.node):
            if not _NAME.fullmatch(part):
                raise RosSettingsError(f"{part!r} is no name in ROS: letters, digits and _, no digit first")
        if not _INTERFACE.fullmatch(self.interface):
            raise RosSettingsError(f"{self.interface!r} is no name of a network interface")

    @property
    def prefix(self) -> str:
        """The namespace as it stands before a topic: "/robot_1", or nothing."""
        inner = self.namespace.strip("/")
        return f"/{inner}" if inner else ""

    @property
    def is_local(self) -> bool:
        """Whether nobody outside this machine is reached."""
        return self.interface == LOOPBACK

    def dds_config(self) -> str:
        """The configuration of Cyclone DDS, as XML."""
        if self.is_local:
            network = '<NetworkInterface address="127.0.0.1" multicast="true"/>'
            discovery = '<Discovery><Peers><Peer address="127.0.0.1"/></Peers></Discovery>'
        else:
            network = f'<NetworkInterface name="{self.interface}"/>'
            discovery = ""
        return (
            "<CycloneDDS><Domain><General><Interfaces>"
            f"{network}</Interfaces></General>{discovery}"
            # Fast DDS of ROS 2 Kilted matches no type with a sequence otherwise
            "<Compatibility><IgnoreTypeInformation>1.15</IgnoreTypeInformation></Compatibility>"
            "</Domain></CycloneDDS>"
        )
