using System;
using System.Linq;
using Rabit.Core;
using Rabit.Geodesy;
using Rabit.Links;
using Rabit.Mavlink.Messages;

namespace Rabit.Uav.Simulation;

/// <summary>One vehicle of a simulated group: what its companion computer is composed of.</summary>
public sealed class SimulatedGroupVehicle
{
    internal SimulatedGroupVehicle(SimulatedWorld world, VirtualTime time, IByteLink radio, TimeSpan switchedOnAt)
    {
        (World, Time, Radio, SwitchedOnAt) = (world, time, radio, switchedOnAt);
    }

    /// <summary>The world with this vehicle: its camera, its telemetry, its truth.</summary>
    public SimulatedWorld World { get; }

    /// <summary>The time of its reactor.</summary>
    public VirtualTime Time { get; }

    /// <summary>The link to the other vehicles; what its companion computer opens beside the telemetry.</summary>
    public IByteLink Radio { get; }

    /// <summary>
    /// What goes over that link, for <see cref="Communications.CommunicationsOptions.LinkSettings"/>: our own
    /// heartbeat, position, vehicle messages and answers to commands. The telemetry of the autopilot would fill it.
    /// </summary>
    public LinkSettings RadioSettings => new()
    {
        Name = "radio",
        AllowOut = new LinkFilter(
            [
                (int)Heartbeat.MavlinkId, (int)GlobalPositionInt.MavlinkId, (int)Tunnel.MavlinkId,
                (int)CommandAck.MavlinkId,
            ],
            [(SystemId, (byte)MavComponent.OnboardComputer)]),
    };

    /// <summary>
    /// What does not go over the link of a vehicle to its autopilot: what ground stations send by radio. An autopilot
    /// that has received one returns when it is not received any more (ArduPilot's FS_GCS_ENABLE); in a group the
    /// search goes on without.
    /// </summary>
    public static LinkSettings TelemetrySettings => new()
    {
        DenyOut = new LinkFilter(
            [],
            Enumerable.Range(0, SimulatedGroupOptions.MaxGroundStations)
                .Select(i => ((byte)(SimulatedGroundStation.FirstSystemId - i), (byte?)null))),
    };

    /// <summary>When it is switched on, by the clock of the group: the time at which its own clock begins.</summary>
    public TimeSpan SwitchedOnAt { get; }

    /// <summary>Its MAVLink system id.</summary>
    public byte SystemId => World.Options.SystemId;

    /// <summary>How its reactor ended; null while it runs, and where the vehicle was lost.</summary>
    public ReactorResult? Result { get; internal set; }

    /// <summary>Whether the vehicle is lost.</summary>
    public bool IsLost { get; internal set; }

    internal RabitReactor? Reactor { get; set; }

    /// <summary>Whether its reactor has started: before that its messages cannot be fetched.</summary>
    public bool HasStarted { get; internal set; }

    /// <summary>Where it stands at the start, in the frame of the group.</summary>
    internal NedPosition Start { get; init; }

    /// <summary>Where it is now, in the frame of the group.</summary>
    internal NedPosition Place => World.Truth.Pose.Position + (Start - NedPosition.Origin);
}
