namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>What became of the track of another vehicle.</summary>
internal enum EstimateResult
{
    /// <summary>Ours goes on with it.</summary>
    Fused,

    /// <summary>A track of ours starts with it.</summary>
    Started,

    /// <summary>Ours is as new.</summary>
    NotNeeded,

    /// <summary>Its numbers do not go together with ours.</summary>
    Unusable,

    /// <summary>There are too many tracks, or half of them are known from other vehicles alone.</summary>
    WithoutRoom,
}
