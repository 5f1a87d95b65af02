namespace Rabit.Uav.Messages;

/// <summary>Whether a mission was accomplished, as Mission Control knows it.</summary>
public enum MissionOutcome
{
    /// <summary>There is no mission.</summary>
    None,

    /// <summary>The mission is not over.</summary>
    InProgress,

    /// <summary>
    /// The mission is over: the area was searched, and the vehicle landed at home. Where the command was taken away in
    /// between, the mission was resumed at the operator's command.
    /// </summary>
    Accomplished,

    /// <summary>The mission is over and was not accomplished; <see cref="MissionResult.Failures"/> says why.</summary>
    Failed,
}
