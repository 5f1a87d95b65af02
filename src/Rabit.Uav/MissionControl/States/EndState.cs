using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>Nothing more is commanded: there is no mission, or it is over, one way or the other.</summary>
internal sealed class EndState(MissionPhase phase) : MissionState(phase)
{
    public override void Enter(MissionFlight flight, MissionEvent by) => flight.Desk.WantNothing();

    public override MissionStep Tick(MissionFlight flight, TimeSpan inPhase) => MissionStep.Stay;
}
