using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>A final phase, Done, HandedOver or Failed: nothing more is commanded.</summary>
internal sealed class EndState(MissionPhase phase) : MissionState(phase)
{
    public override void Enter(MissionFlight flight, MissionEvent by) => flight.Commands.Clear();

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase) => MissionStep.Stay;
}
