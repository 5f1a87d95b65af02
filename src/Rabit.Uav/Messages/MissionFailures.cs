using System;

namespace Rabit.Uav.Messages;

/// <summary>Why a mission is not accomplished.</summary>
[Flags]
public enum MissionFailures
{
    /// <summary>Nothing.</summary>
    None = 0,

    /// <summary>The search was given up before its end; <see cref="MissionStatus.Aborted"/> says why.</summary>
    GivenUp = 1,

    /// <summary>The vehicle did not take off.</summary>
    NotFlown = 2,

    /// <summary>The vehicle took off and is still armed, or its motors stopped in the air.</summary>
    NotLanded = 4,

    /// <summary>
    /// The vehicle landed farther from home than <see cref="MissionResult.MaxLandingDistanceMetres"/>, or where is not
    /// known.
    /// </summary>
    AwayFromHome = 8,

    /// <summary>The vehicle was outside the fence.</summary>
    OutsideFence = 16,

    /// <summary>
    /// The command was taken away, and the mission was not resumed; <see cref="MissionStatus.TakenOver"/> says by whom.
    /// </summary>
    TakenOver = 32,

    /// <summary>
    /// The camera saw less of the area than the mission requires, <see cref="MissionResult.RequiredCoverage"/>.
    /// </summary>
    AreaNotSeen = 64,

    /// <summary>
    /// The operator gave the mission up before the take-off, with a hold, return or land; beside
    /// <see cref="NotFlown"/>.
    /// </summary>
    CalledOff = 128,
}
