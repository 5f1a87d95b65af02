using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>One phase of the mission: what is to be commanded in it, and what ends it.</summary>
internal abstract class MissionState(MissionPhase phase)
{
    /// <summary>After so many refusals or time-outs of one command in the air something else is done.</summary>
    protected const int MaxFailures = 3;

    /// <summary>Which phase it is.</summary>
    public MissionPhase Phase { get; } = phase;

    /// <summary>Called when the phase begins.</summary>
    /// <param name="flight">Everything there is to know.</param>
    /// <param name="by">What led here.</param>
    public virtual void Enter(MissionFlight flight, MissionEvent by)
    {
    }

    /// <summary>Called several times a second while the vehicle is heard and knows where it is.</summary>
    /// <param name="flight">Everything there is to know.</param>
    /// <param name="inPhase">For how long the phase lasts, without the time in which the vehicle was not heard.</param>
    public abstract MissionStep Tick(MissionFlight flight, TimeSpan inPhase);

    protected static MissionStep ReturnToLaunch(string reason) => new(MissionEvent.ReturnToLaunch, reason);

    protected static MissionStep Impossible(string reason) => new(MissionEvent.Impossible, reason);

    protected static TimeSpan Seconds(double seconds) => TimeSpan.FromSeconds(seconds);
}
