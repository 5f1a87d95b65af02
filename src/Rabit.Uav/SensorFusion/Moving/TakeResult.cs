namespace Rabit.Uav.SensorFusion.Moving;

/// <summary>What became of a measurement.</summary>
internal enum TakeResult
{
    /// <summary>It is in the estimate.</summary>
    Used,

    /// <summary>It was in the estimate before.</summary>
    Duplicate,

    /// <summary>It is older than what can still be filtered again.</summary>
    TooOld,
}
