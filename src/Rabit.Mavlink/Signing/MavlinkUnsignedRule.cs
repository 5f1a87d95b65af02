namespace Rabit.Mavlink;

/// <summary>
/// Decides whether a frame that is not signed is accepted. Every sender with access to the link can send such frames.
/// </summary>
/// <param name="frame">The frame.</param>
/// <param name="link">
/// The number of the link it came from, as given to <see cref="MavlinkVerifier.Verify"/>; for example to trust a cable.
/// </param>
/// <returns>Whether it is accepted.</returns>
public delegate bool MavlinkUnsignedRule(in MavlinkFrame frame, int link);
