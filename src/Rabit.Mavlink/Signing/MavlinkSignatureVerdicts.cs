namespace Rabit.Mavlink;

/// <summary>Reads a verdict.</summary>
public static class MavlinkSignatureVerdicts
{
    /// <summary>Whether the frame may be acted on.</summary>
    /// <param name="verdict">The verdict.</param>
    /// <returns>True for <see cref="MavlinkSignatureVerdict.Valid"/>, <see cref="MavlinkSignatureVerdict.ValidNewStream"/> and <see cref="MavlinkSignatureVerdict.UnsignedAllowed"/>.</returns>
    public static bool IsAccepted(this MavlinkSignatureVerdict verdict) =>
        verdict is MavlinkSignatureVerdict.Valid or MavlinkSignatureVerdict.ValidNewStream or MavlinkSignatureVerdict.UnsignedAllowed;
}
