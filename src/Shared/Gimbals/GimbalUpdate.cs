namespace Rabit.Uav.AutopilotInterface;

/// <summary>What came of a gimbal's message.</summary>
internal enum GimbalUpdate
{
    /// <summary>It is of another vehicle, or of another gimbal of ours than the one whose attitude is used.</summary>
    OfOther,

    /// <summary>It is no attitude: not a number, no rotation, or of a gimbal that reports an error.</summary>
    Refused,

    /// <summary>It is the attitude of our gimbal.</summary>
    Taken,
}
