using System;
using System.Collections.Generic;
using Rabit.Core;
using Rabit.Mavlink;
using Rabit.Mavlink.Messages;
using Rabit.Uav.Messages;

namespace Rabit.Uav.HealthMonitoring;

// What is sent over the links.
public sealed partial class HealthManager
{
    // The version of the protocol's messages that every HEARTBEAT carries (minimal.xml: <version>3</version>).
    private const byte MavlinkMessagesVersion = 3;

    private readonly EnergyTelemetry _energy = new();

    private void SendHeartbeat()
    {
        var heartbeat = new Heartbeat
        {
            Type = MavType.OnboardController,
            Autopilot = MavAutopilot.Invalid,
            SystemStatus = _next.Level == HealthLevel.Critical ? MavState.Critical : MavState.Active,
            MavlinkVersion = MavlinkMessagesVersion,
        };
        OwnAddress own = _ownAddress.Value;
        var frame = new OutgoingFrame
        {
            Frame = MavlinkFrame.Create(heartbeat, own.SystemId, own.ComponentId, sequence: 0)
        };
        if (_outgoing.Push(frame) != PushResult.Rejected)
            _next.HeartbeatsSent++;
    }

    private void SendTexts(TimeSpan now)
    {
        OwnAddress own = _ownAddress.Value;
        if (!own.IsKnown)
            return;
        IReadOnlyList<Statustext> chunks = _texts.NextChunks(_next, now);
        for (int i = 0; i < chunks.Count; i++)
            _ = _outgoing.Push(
                new OutgoingFrame
                {
                    Frame = MavlinkFrame.Create(chunks[i], own.SystemId, own.ComponentId, sequence: 0)
                });
    }

    // With the heartbeat, and also while that is withheld: it is what is wrong with the computer that is of interest.
    private void SendComputerStatus(TimeSpan now)
    {
        OwnAddress own = _ownAddress.Value;
        if (_computer is null || !own.IsKnown)
            return;
        ComputerStatus known = new ComputerFacts(_next.Computer, now).Status;
        OnboardComputerStatus message = OnboardComputerReport.Of(known, now, _options);
        foreach (LinkWatch link in _links)
            OnboardComputerReport.AddLink(ref message, link.Number, link.Url);
        _ = _outgoing.Push(new OutgoingFrame
        {
            Frame = MavlinkFrame.Create(message, own.SystemId, own.ComponentId, sequence: 0),
        });
    }

    private void SendEnergy(TimeSpan now)
    {
        OwnAddress own = _ownAddress.Value;
        if (!own.IsKnown || _mission.Age > MaxEnergyAge || _energy.Next(_mission.Value.Energy, now) is not { } message)
            return;
        _ = _outgoing.Push(new OutgoingFrame
        {
            Frame = MavlinkFrame.Create(message, own.SystemId, own.ComponentId, sequence: 0),
        });
    }
}
