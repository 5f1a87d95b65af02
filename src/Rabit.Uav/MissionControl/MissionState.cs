using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>One phase of the mission: its goals, and what ends it.</summary>
internal abstract class MissionState(MissionPhase phase)
{
    /// <summary>After so many refusals or time-outs of one kind of command in the air the phase is given up.</summary>
    protected const int MaxFailures = 3;

    /// <summary>Which phase it is.</summary>
    public MissionPhase Phase { get; } = phase;

    /// <summary>Whether the mission is over: nothing more will happen.</summary>
    public virtual bool IsOver => false;

    /// <summary>Called when the phase begins.</summary>
    /// <param name="flight">The state of the mission.</param>
    /// <param name="by">What led here.</param>
    /// <param name="reason">Why, as text.</param>
    public virtual void Enter(MissionFlight flight, MissionEvent by, string reason)
    {
    }

    /// <summary>Called when the phase ends.</summary>
    public virtual void Leave(MissionFlight flight)
    {
    }

    /// <summary>Called several times a second while an autopilot is connected and has a position.</summary>
    /// <param name="flight">The state of the mission.</param>
    /// <param name="inPhase">
    /// How long the phase has lasted, without the time in which no autopilot was connected.
    /// </param>
    public abstract MissionStep Tick(MissionFlight flight, TimeSpan inPhase);

    /// <summary>Called where another vehicle stays in the way: what is flown now is left.</summary>
    /// <param name="flight">The state of the mission.</param>
    /// <param name="why">Why, as text.</param>
    public virtual MissionStep LeaveLeg(MissionFlight flight, string why) => MissionStep.Stay;

    protected static MissionStep ReturnToLaunch(string reason) => new(MissionEvent.ReturnToLaunch, reason);

    protected static MissionStep Impossible(string reason) => new(MissionEvent.Impossible, reason);

    protected static TimeSpan Seconds(double seconds) => TimeSpan.OfSeconds(seconds);
}
