using System;
using Rabit.Uav.Messages;

namespace Rabit.Uav.MissionControl;

/// <summary>A target that is followed, by whatever tracks it is known.</summary>
internal interface IFollowedTarget
{
    /// <summary>How it moves.</summary>
    TargetMotion Motion { get; }

    /// <summary>For people.</summary>
    string Name { get; }

    /// <summary>How long it was in view of others that followed it before.</summary>
    TimeSpan InViewBefore { get; }

    /// <summary>For how long it is searched for where it is lost.</summary>
    TimeSpan MaxSearch { get; }

    /// <summary>Where it is when it begins to be followed.</summary>
    FollowMark Begin(MissionFlight flight);

    /// <summary>The track that shows it; null where none does.</summary>
    /// <param name="flight">The vehicle and its tracks.</param>
    /// <param name="expected">Where it is expected now.</param>
    /// <param name="radiusMetres">How far from there another track of its class is the same target.</param>
    TargetTrack? Find(MissionFlight flight, PlanePoint expected, double radiusMetres);

    /// <summary>Whether our own pictures show it; where that is not known, it is true.</summary>
    bool IsSeen(MissionFlight flight);
}
