namespace Rabit.Mavlink;

/// <summary>Evaluates a <see cref="MavlinkSignatureResult"/>.</summary>
public static class MavlinkSignatureResultExtensions
{
    /// <summary>Whether the frame may be acted on.</summary>
    /// <param name="result">The result.</param>
    /// <returns>
    /// True for <see cref="MavlinkSignatureResult.Valid"/>, <see cref="MavlinkSignatureResult.ValidNewStream"/> and
    /// <see cref="MavlinkSignatureResult.UnsignedAllowed"/>.
    /// </returns>
    public static bool IsAccepted(this MavlinkSignatureResult result) =>
        result is MavlinkSignatureResult.Valid or MavlinkSignatureResult.ValidNewStream
            or MavlinkSignatureResult.UnsignedAllowed;
}
