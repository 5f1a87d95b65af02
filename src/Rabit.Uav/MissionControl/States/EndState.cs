using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>A final phase, Done or Failed: nothing more is commanded.</summary>
internal sealed class EndState(MissionPhase phase) : MissionState(phase)
{
    public override bool IsOver => true;

    public override void Enter(MissionFlight flight, MissionEvent by, string reason) => flight.Commands.Clear();

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase) => MissionStep.Stay;
}
